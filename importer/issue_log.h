// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/import_error.h"
#include "importer/rules.h"

namespace sinew {

/// Text of the file for a message: in quotes, cut when long.
std::string in_quotes(std::string_view text);

/// What one import has found so far. Passes report here and go on while that is safe; between passes the import settles
/// what they found, or ends.
class IssueLog {
 public:
  /// `json_pointer` names the place ("/accessors/3/count", or empty for the container), `detail` this case with its
  /// numbers.
  void report(Rule rule, std::string json_pointer, std::string detail);

  /// No error since the last settle().
  bool ok() const noexcept { return error_count_ == settled_; }

  /// Errors so far; a pass compares two of them to see whether a part of it went wrong.
  std::size_t error_count() const noexcept { return error_count_; }

  /// The places of the errors since the last call, for who goes on without what is broken there; nothing where they
  /// were too many to remember.
  std::optional<std::vector<std::string>> settle();

  /// Reports at this place or below it are dropped from here on, though errors count: they follow from what is known.
  void mute(std::string json_pointer) { muted_.insert(std::move(json_pointer)); }

  /// Everything as the caller of import_gltf gets it. Repeated warnings of one rule are cut after kMaxPerRule.
  std::vector<ImportIssue> take_warnings();
  ImportError take_error(std::string file);

  static constexpr std::size_t kMaxPerRule = 64;
  static constexpr std::size_t kMaxPlaces = 4096;  ///< errors between two settle() calls

 private:
  std::vector<ImportIssue> issues_;
  std::vector<std::size_t> seen_;
  bool is_muted(std::string_view json_pointer) const;

  std::set<std::string, std::less<>> muted_;
  std::vector<std::string> fresh_places_;
  bool unlisted_error_ = false;
  std::size_t error_count_ = 0, settled_ = 0;
};

}  // namespace sinew
