// SPDX-License-Identifier: MIT
#include "importer/tool/assets/asset_rules.h"

#include <fmt/core.h>

#include "importer/tool/assets/asset_bytes.h"
#include "importer/tool/assets/asset_parts.h"
#include "runtime/clip/clip_file.h"

namespace sinew::tool {

std::optional<std::vector<ImportIssue>> broken_asset_rules(const std::string& file) {
  const auto bytes = asset_bytes(file);
  if (!bytes) return std::nullopt;
  std::vector<ImportIssue> issues;
  if (looks_like_asset_file(*bytes)) {
    if (const auto parts = asset_parts(*bytes); !parts) {
      const AssetFileError& error = parts.error();
      const std::string where = error.block.empty() ? "" : "block " + error.block + ", ";
      issues.push_back(
          {Severity::error, error.rule, "", fmt::format("{}byte {}: {}", where, error.offset, error.detail)});
    }
  } else if (const auto clips = load_clips(*bytes); !clips) {
    issues.push_back({Severity::error, clips.error().rule, "",
                      fmt::format("byte {}: {}", clips.error().offset, clips.error().detail)});
  }
  return issues;
}

}  // namespace sinew::tool
