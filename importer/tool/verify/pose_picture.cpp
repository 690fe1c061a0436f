// SPDX-License-Identifier: MIT
#include "importer/tool/verify/pose_picture.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

constexpr int kPicturesAtMost = 12;

/// err   a sentence for the user
tl::expected<std::string, std::string> draw(const VerifiedFile& file, const std::string& viewer) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path picture =
      fs::temp_directory_path(error) / fmt::format("sinew-verify-{}.png", platform::process_number());
  if (error) return tl::unexpected(error.message());
  const PoseFigure& figure = file.history.figure;
  const std::vector<std::string> arguments{file.file,
                                           "--headless",
                                           platform::text_of(picture),
                                           "--size",
                                           "560x420",
                                           "--clip",
                                           figure.clip == kNone ? "none" : fmt::format("{}", figure.clip),
                                           "--time",
                                           fmt::format("{:.9g}", figure.time_s)};
  if (const auto drawn = platform::output_of(platform::path_of(viewer), arguments); !drawn)
    return tl::unexpected(drawn.error());
  std::ifstream stream(picture, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  stream.close();
  fs::remove(picture, error);
  if (bytes.empty()) return tl::unexpected(std::string("it drew nothing"));
  return bytes;
}

}  // namespace

void add_pictures(std::span<VerifiedFile> files, const std::string& viewer) {
  int left = kPicturesAtMost;
  for (VerifiedFile& file : files) {
    if (!file.moved() || left-- <= 0) continue;
    if (auto picture = draw(file, viewer))
      file.picture = std::move(*picture);
    else
      print_error(fmt::format("warning: {}: no picture of {}: {}", viewer, file.file, picture.error()));
  }
}

}  // namespace sinew::tool
