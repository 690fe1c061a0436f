// SPDX-License-Identifier: MIT
#include "importer/tool/assets/asset_bytes.h"

#include <algorithm>
#include <limits>

#include "importer/file/regular_file.h"
#include "importer/platform/files.h"
#include "runtime/asset_file/asset_file.h"
#include "runtime/clip/clip_file.h"

namespace sinew::tool {
namespace {

/// The first bytes of a file, at most `size`; empty if it is not a regular file.
std::vector<std::byte> read_head(const std::string& path, std::uint64_t size) {
  const RegularFile file(platform::path_of(path));
  const auto whole = file.opened() ? file.size() : std::nullopt;
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::min(size, whole.value_or(0))));
  if (!file.read(bytes)) bytes.clear();
  return bytes;
}

}  // namespace

std::optional<std::vector<std::byte>> asset_bytes(const std::string& file) {
  const std::vector<std::byte> head = read_head(file, kAssetHead);
  if (!looks_like_asset_file(head) && !looks_like_clips(head)) return std::nullopt;
  return read_head(file, std::numeric_limits<std::uint64_t>::max());
}

}  // namespace sinew::tool
