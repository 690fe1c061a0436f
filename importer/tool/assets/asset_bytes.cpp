// SPDX-License-Identifier: MIT
#include "importer/tool/assets/asset_bytes.h"

#include <limits>

#include "importer/file/regular_file.h"
#include "importer/platform/files.h"
#include "runtime/asset_file/asset_file.h"
#include "runtime/clip/clip_file.h"

namespace sinew::tool {

std::optional<std::vector<std::byte>> asset_bytes(const std::string& file) {
  const std::vector<std::byte> head = RegularFile(platform::path_of(file)).read_up_to(kAssetHead);
  if (!looks_like_asset_file(head) && !looks_like_clips(head)) return std::nullopt;
  return RegularFile(platform::path_of(file)).read_up_to(std::numeric_limits<std::uint64_t>::max());
}

}  // namespace sinew::tool
