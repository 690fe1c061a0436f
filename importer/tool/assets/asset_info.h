// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "importer/tool/json.h"

namespace sinew::tool {

/// The output of `sinew info` for an asset file or a file of compiled clips.
struct AssetInfo {
  Json json;
  std::string headline;  ///< one line without its end
  std::string tables;    ///< blocks, what the model has, certificates of the clips
};

/// out   nothing when the file is neither
/// err   a sentence for the user, with the rule, the block and the byte
std::optional<tl::expected<AssetInfo, std::string>> asset_info(const std::string& file);

}  // namespace sinew::tool
