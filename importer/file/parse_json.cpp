// SPDX-License-Identifier: MIT
#include "importer/file/parse_json.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "importer/file/json_fault.h"

namespace sinew {
namespace {

void report_syntax(std::string_view text, IssueLog& log) {
  std::string fault = describe_json_fault(text);
  if (fault.empty()) throw std::logic_error("the two readers of JSON disagree");
  log.report(Rule::json_syntax, "", std::move(fault));
}

}  // namespace

std::unique_ptr<JsonTree> parse_json(std::span<const std::byte> bytes, IssueLog& log) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) {
    log.report(Rule::json_bom, "", "the text starts with a byte order mark, which is skipped");
    text.remove_prefix(3);
  }
  constexpr std::size_t kSmallest = 2048, kLargest = std::size_t{1} << 18;
  auto out = std::make_unique<JsonTree>(std::clamp(text.size(), kSmallest, kLargest));
  JsonBuilder tree(&out->pool, 256, &out->memory);
  JsonOutcome outcome{};
  const auto read = [&](JsonBuilder& builder) { return (outcome = read_json(text, builder)) == JsonOutcome::read; };
  tree.Populate(read);
  switch (outcome) {
    case JsonOutcome::read: out->root.Swap(tree); return out;
    case JsonOutcome::invalid: report_syntax(text, log); return nullptr;
    case JsonOutcome::too_deep: break;
  }
  log.report(Rule::json_depth, "", "nested more than " + std::to_string(kMaxJsonDepth) + " deep");
  return nullptr;
}

}  // namespace sinew
