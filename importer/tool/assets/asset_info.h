// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace sinew::tool {

/// What `sinew info` says of an asset file, or of compiled clips.
struct AssetInfo {
  nlohmann::ordered_json json;
  std::string headline;  ///< one line without its end
  std::string tables;    ///< blocks, what the model has, certificates of the clips
};

/// out   nothing when the file is neither
/// err   a sentence: rule, block, byte
std::optional<tl::expected<AssetInfo, std::string>> asset_info(const std::string& file);

}  // namespace sinew::tool
