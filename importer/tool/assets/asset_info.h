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
  std::string headline;  ///< one line, without a line end
  std::string tables;    ///< tables of blocks, of the model's parts and of the certificates of clips
};

/// Describes a file.     out  empty if it is neither an asset file nor a file of compiled clips
/// err   a sentence for the user, with the rule, the block and the byte
std::optional<tl::expected<AssetInfo, std::string>> asset_info(const std::string& file);

}  // namespace sinew::tool
