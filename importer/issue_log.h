// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"
#include "importer/rules.h"

namespace sinew {

/// Text of the file for a message: in quotes, cut when long.
std::string in_quotes(std::string_view text);

/// What one import has found so far. Passes report here and go on while that is safe; the import stops after a pass that
/// reported an error.
class IssueLog {
 public:
  /// `json_pointer` names the place ("/accessors/3/count", or empty for the container), `detail` this case with its numbers.
  void report(Rule rule, std::string json_pointer, std::string detail);

  bool ok() const noexcept { return error_count_ == 0; }

  /// Everything as the caller of import_gltf gets it. Repeated warnings of one rule are cut after kMaxPerRule.
  std::vector<ImportIssue> take_warnings();
  ImportError take_error(std::string file);

  static constexpr std::size_t kMaxPerRule = 64;

 private:
  std::vector<ImportIssue> issues_;
  std::vector<std::size_t> seen_;
  std::size_t error_count_ = 0;
};

}  // namespace sinew
