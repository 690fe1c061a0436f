// SPDX-License-Identifier: MIT
#include "importer/file/parse_json.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace sinew {
namespace {

std::size_t nesting_depth(std::string_view text) {
  std::size_t depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return deepest;
}

/// nlohmann's messages start with "[json.exception.parse_error.101] ", which says nothing to a reader.
std::string plain_message(const std::exception& error) {
  const std::string_view what = error.what();
  const auto end = what.find("] ");
  return std::string(what.starts_with("[json.") && end != what.npos ? what.substr(end + 2) : what);
}

}  // namespace

std::optional<nlohmann::json> parse_json(std::span<const std::byte> bytes, IssueLog& log) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) {
    log.report(Rule::json_bom, "", "the text starts with a byte order mark, which is skipped");
    text.remove_prefix(3);
  }
  if (const auto depth = nesting_depth(text); depth > kMaxJsonDepth) {
    log.report(Rule::json_depth, "", "nested " + std::to_string(depth) + " deep, at most " + std::to_string(kMaxJsonDepth));
    return std::nullopt;
  }
  try {
    return nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::exception& error) {
    log.report(Rule::json_syntax, "", plain_message(error));
  }
  return std::nullopt;
}

}  // namespace sinew
