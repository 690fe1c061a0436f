// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"

namespace sinew::viewer {

/// True if the file starts like an asset file (.sinew).
bool is_asset_file(const std::filesystem::path& file);

/// Reads an asset file, and decodes the images that it keeps encoded. An image that cannot be decoded is missing, as in
/// a glTF file.
/// err  one sentence: the file, and why it cannot be read or which rule it breaks (AssetFileError)
tl::expected<Scene, std::string> read_asset_file(const std::filesystem::path& file);

}  // namespace sinew::viewer
