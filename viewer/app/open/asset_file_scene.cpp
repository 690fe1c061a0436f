// SPDX-License-Identifier: MIT
#include "viewer/app/open/asset_file_scene.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "importer/file/regular_file.h"
#include "importer/read/image_codec.h"
#include "runtime/asset_file/read_assets.h"

namespace sinew::viewer {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;  // as ImportOptions::max_image_pixels

void decode(Image& image) {
  if (!image.rgba.empty() || image.encoded.empty()) return;
  const auto header = probe_image(image.encoded);
  if (!header || !header->is_decoded || header->pixels() > kMostPixels) {
    image.missing_reason = header ? "this build does not decode it, or it is too large" : header.error();
    return;
  }
  auto pixels = decode_image(image.encoded);
  if (!pixels) {
    image.missing_reason = pixels.error();
    return;
  }
  image.width = header->width;
  image.height = header->height;
  image.rgba = *std::move(pixels);
}

}  // namespace

bool is_asset_file(const std::filesystem::path& file) {
  return looks_like_asset_file(RegularFile(file).read_up_to(kAssetHead));
}

tl::expected<Scene, std::string> read_asset_file(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = RegularFile(file).read_up_to(std::numeric_limits<std::uint64_t>::max());
  if (bytes.empty()) return tl::unexpected(file.string() + ": cannot be read");
  const auto opened = AssetFile::open(bytes);
  if (!opened) return tl::unexpected(file.string() + ": " + describe(opened.error()));
  auto scene = read_scene(*opened);
  if (!scene) return tl::unexpected(file.string() + ": " + describe(scene.error()));
  for (Image& image : scene->images) decode(image);
  return *std::move(scene);
}

}  // namespace sinew::viewer
