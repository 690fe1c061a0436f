// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "runtime/asset_file/read_assets.h"

namespace sinew::tool {

/// Everything in an asset file that can be read without another file.
struct AssetParts {
  AssetFile file;
  std::optional<Scene> scene;  ///< of a file with a skeleton
  std::vector<Clip> clips;
  std::vector<CompiledSkeletonLod> lods;  ///< of a file with a skeleton
};

/// Opens and reads all of a file, checksums of unknown blocks among it.
/// in    bytes  must outlive the answer
tl::expected<AssetParts, AssetFileError> asset_parts(std::span<const std::byte> bytes);

}  // namespace sinew::tool
