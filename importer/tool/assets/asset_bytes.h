// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sinew::tool {

/// The bytes of an asset file (asset_file.h) or of compiled clips (clip_file.h); empty if the file is neither.
std::optional<std::vector<std::byte>> asset_bytes(const std::string& file);

}  // namespace sinew::tool
