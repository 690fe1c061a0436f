// SPDX-License-Identifier: MIT
#include "importer/rewrite/embed_images.h"

#include <filesystem>
#include <string_view>

#include "importer/file/data_uri.h"
#include "importer/file/json_pointer.h"
#include "importer/file/sandboxed_files.h"
#include "importer/platform/files.h"

namespace sinew::rewrite {
namespace {

struct Signature {
  std::size_t offset;
  std::string_view bytes;
  const char* type;
};

constexpr Signature kSignatures[] = {
    {0, "\x89PNG\r\n\x1a\n", "image/png"},         {0, "\xff\xd8\xff", "image/jpeg"}, {8, "WEBP", "image/webp"},
    {0, "\xabKTX 20\xbb\r\n\x1a\n", "image/ktx2"}, {4, "ftypavif", "image/avif"},     {0, "DDS ", "image/vnd-ms.dds"},
};

void name_after_file(const std::string& uri, Json& image) {
  if (is_data_uri(uri) || image.contains("name")) return;
  if (const auto path = percent_decode(uri)) image["name"] = platform::text_of(platform::path_of(*path).stem());
}

}  // namespace

std::string image_type(Bytes encoded, const std::string& declared) {
  const std::string_view text(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  for (const Signature& known : kSignatures)
    if (text.size() > known.offset && text.substr(known.offset).starts_with(known.bytes)) return known.type;
  return declared.empty() ? "application/octet-stream" : declared;
}

void embed_images(const gltf::Document& document, Draft& draft) {
  Json& images = list_of(draft, "images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    const gltf::Image& source = document.images[i];
    if (source.encoded.empty()) {
      images[i].erase("bufferView");
      draft.losses.push_back({"image-missing", pointer("images", i), source.missing_reason});
      continue;
    }
    if (source.buffer_view == kNone) {
      name_after_file(images[i].value("uri", ""), images[i]);
      images[i].erase("uri");
      images[i]["bufferView"] = draft.add_view(source.encoded);
    }
    if (!images[i].contains("mimeType")) images[i]["mimeType"] = image_type(source.encoded, source.mime_type);
  }
}

}  // namespace sinew::rewrite
