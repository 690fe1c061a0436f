// SPDX-License-Identifier: MIT
#include "importer/rewrite/decode_images.h"

#include <string_view>

#include "importer/file/json_pointer.h"
#include "importer/import_gltf.h"
#include "importer/read/images.h"
#include "importer/rewrite/embed_images.h"
#include "importer/write/encode_png.h"

namespace sinew::rewrite {
namespace {

constexpr struct {
  std::string_view type;
  const char* extension;
} kDecoded[] = {
    {"image/webp", "EXT_texture_webp"}, {"image/avif", "EXT_texture_avif"}, {"image/ktx2", "KHR_texture_basisu"}};

bool is_decoded_type(std::string_view type) {
  for (const auto& kind : kDecoded)
    if (kind.type == type) return true;
  return false;
}

/// Names the image of an extension as the source of the texture.   out   true if the extension has to stay
bool name_as_source(Json& texture, const char* extension, const std::vector<bool>& is_png) {
  const Json* fields = extension_of(texture, extension);
  if (fields == nullptr) return false;
  const auto source = fields->find("source");
  if (source == fields->end() || !source->is_number() || index_of(*source) >= is_png.size()) return true;
  if (!is_png[index_of(*source)]) return true;
  texture["source"] = index_of(*source);
  erase_extension(texture, extension);
  return false;
}

}  // namespace

void decode_images(const gltf::Document& document, Draft& draft) {
  Json& images = list_of(draft, "images");
  std::vector<bool> is_png(images.size(), false);
  std::uint64_t pixels_left = ImportOptions{}.max_image_pixels;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Bytes encoded = document.images[i].encoded;
    if (encoded.empty() || !is_decoded_type(image_type(encoded, ""))) continue;
    const auto image = read_image(encoded, pixels_left);
    if (!image) {
      draft.losses.push_back({"image-missing", pointer("images", i), image.error()});
      continue;
    }
    draft.spare_views.insert(index_of(images[i]["bufferView"]));
    images[i]["bufferView"] = draft.add_view(write::encode_png(*image));
    images[i]["mimeType"] = "image/png";
    is_png[i] = true;
  }
  for (const auto& kind : kDecoded) {
    bool stays = false;
    for (Json& texture : list_of(draft, "textures")) stays |= name_as_source(texture, kind.extension, is_png);
    if (!stays) undeclare(draft, kind.extension);
  }
}

}  // namespace sinew::rewrite
