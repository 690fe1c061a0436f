// SPDX-License-Identifier: MIT
#include "importer/read/images.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/image_codec.h"
#include "runtime/threads/default_executor.h"

namespace sinew {
namespace {

/// Plausible pixels per encoded byte: deflate expands a byte to at most 1032 bytes of 8 pixels each. Only
/// single-coloured WebP and AVIF exceed this, so images up to a common texture size are always accepted.
constexpr std::uint64_t kMaxPixelsPerByte = 8 * 1032;
constexpr std::uint64_t kPlausiblePixels = std::uint64_t{1} << 22;

/// Reserves the pixels of an image. Returns the reason if that fails, else an empty string.
std::string admit(gltf::Bytes encoded, bool decode, std::uint64_t& pixels_left, Image& image) {
  const auto size = probe_image(encoded);
  if (!size) return size.error();
  if (decode && !size->is_decoded) return std::string("is ") + size->mime_type + ", which is not decoded";
  const std::string dimensions = std::to_string(size->width) + " x " + std::to_string(size->height) + " pixels";
  if (size->pixels() > std::max(kPlausiblePixels, kMaxPixelsPerByte * encoded.size()))
    return "claims " + dimensions + " in " + std::to_string(encoded.size()) + " bytes";
  if (decode && size->pixels() > pixels_left) return dimensions + " exceed the pixels allowed for all images";
  if (decode) pixels_left -= size->pixels();
  image.width = size->width;
  image.height = size->height;
  image.mime_type = size->mime_type;
  image.encoded_size = encoded.size();
  return {};
}

void decode(gltf::Bytes encoded, Image& image) {
  auto pixels = decode_image(encoded);
  if (pixels) {
    image.rgba = std::move(*pixels);
    return;
  }
  image.width = image.height = 0;
  image.mime_type.clear();
  image.encoded_size = 0;
  image.missing_reason = pixels.error();
}

/// For each image, the first image with identical bytes (possibly itself).
std::vector<std::uint32_t> first_of_equals(const gltf::Document& document) {
  std::map<std::pair<const std::byte*, std::size_t>, std::uint32_t> known;
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < document.images.size(); ++i) {
    const gltf::Bytes encoded = document.images[i].encoded;
    first.push_back(encoded.empty() ? i : known.try_emplace({encoded.data(), encoded.size()}, i).first->second);
  }
  return first;
}

}  // namespace

tl::expected<Image, std::string> read_image(std::span<const std::byte> encoded, std::uint64_t& pixels_left) {
  Image image;
  image.missing_reason = admit(encoded, true, pixels_left, image);
  if (image.missing_reason.empty()) decode(encoded, image);
  if (!image.missing_reason.empty()) return tl::make_unexpected(image.missing_reason);
  return image;
}

std::vector<Image> read_images(const gltf::Document& document, const ImportOptions& options,
                               std::vector<Texture>& textures, IssueLog& log) {
  const std::size_t count = document.images.size();
  std::vector<Image> images(count);
  for (std::size_t i = 0; i < count; ++i) images[i].name = document.images[i].name;
  if (!options.decode_images && !options.probe_images && !options.keep_encoded_images) return images;

  const std::vector<std::uint32_t> first = first_of_equals(document);
  for (Texture& texture : textures)
    if (texture.image < count) texture.image = first[texture.image];
  std::uint64_t pixels_left = options.max_image_pixels;
  for (std::size_t i = 0; i < count; ++i) {
    const gltf::Image& source = document.images[i];
    if (first[i] != i) {
      images[i].missing_reason = "has the bytes of image " + std::to_string(first[i]) + ", which textures use instead";
      continue;
    }
    images[i].missing_reason = source.encoded.empty()
                                   ? source.missing_reason
                                   : admit(source.encoded, options.decode_images, pixels_left, images[i]);
  }
  run_in_parallel(count, [&](std::size_t i) {
    const gltf::Bytes encoded = document.images[i].encoded;
    if (options.decode_images && images[i].missing_reason.empty()) decode(encoded, images[i]);
    if (options.keep_encoded_images && images[i].missing_reason.empty())
      images[i].encoded.assign(encoded.begin(), encoded.end());
  });
  // load_images() has already reported images whose bytes could not be read.
  for (std::size_t i = 0; i < count; ++i)
    if (first[i] == i && !images[i].missing_reason.empty() && document.images[i].missing_reason.empty())
      log.report(Rule::image_missing, pointer("images", i), images[i].missing_reason + "; a placeholder is shown");
  return images;
}

}  // namespace sinew
