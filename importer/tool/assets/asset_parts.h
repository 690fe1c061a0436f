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
  std::optional<Scene> scene;  ///< present if the file has a skeleton
  std::vector<Clip> clips;
  std::vector<CompiledSkeletonLod> lods;  ///< empty if the file has no skeleton
  std::vector<StoredGraph> graphs;
};

/// Opens and reads all of a file. It also compares the checksums of unknown blocks.
/// in    bytes  must outlive the result
tl::expected<AssetParts, AssetFileError> asset_parts(std::span<const std::byte> bytes);

}  // namespace sinew::tool
