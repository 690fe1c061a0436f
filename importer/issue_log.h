// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/import_error.h"
#include "importer/rules.h"

namespace sinew {

/// Text from the file, for a message: in double quotes, cut after 80 bytes.
std::string in_quotes(std::string_view text);

/// The broken rules that one import has found so far. A step of the import reports here and goes on while that is safe.
/// Between steps the import calls settle(), puts aside what is broken, and goes on or ends.
class IssueLog {
 public:
  /// in    listed   of each rule and severity, the reports that are kept; further ones are counted
  explicit IssueLog(std::size_t listed = kMaxPerRule) : listed_(listed) {}

  /// in    json_pointer   the place, such as "/accessors/3/count"; empty for the whole file
  ///       detail         what is wrong here, with its numbers
  void report(Rule rule, std::string json_pointer, std::string detail);

  /// The same as a warning, where a rule is broken by something that the scene can do without.
  void report_as_warning(Rule rule, std::string json_pointer, std::string detail);

  /// True while there is no error since the last settle().
  bool ok() const noexcept { return error_count_ == settled_; }

  /// All errors so far, muted ones included. A step compares two values to see whether a part of it failed.
  std::size_t error_count() const noexcept { return error_count_; }

  /// Returns the places of the errors since the last call, for code that goes on without what is broken there.
  /// out   nothing when there were more than kMaxPlaces errors
  std::optional<std::vector<std::string>> settle();

  /// From now on, drops the text of reports at this place and below it, because they only follow from an error that is
  /// already known. Errors there still count.
  void mute(std::string json_pointer) { muted_.insert(std::move(json_pointer)); }

  /// Moves the reports out, as import_gltf() returns them.
  std::vector<ImportIssue> take_warnings();
  ImportError take_error(std::string file);

  static constexpr std::size_t kMaxPerRule = 64;
  static constexpr std::size_t kMaxPlaces = 4096;  ///< between two settle() calls

 private:
  /// The reports of one rule and severity.
  struct Tally {
    std::size_t listed = 0;
    std::size_t last = 0;  ///< place in issues_ of the last that is listed
  };
  void name_unlisted();

  std::size_t listed_;
  std::vector<ImportIssue> issues_;
  std::vector<std::array<Tally, 3>> tallies_;  ///< by rule, by severity
  void add(Severity severity, Rule rule, std::string json_pointer, std::string detail);
  bool is_muted(std::string_view json_pointer) const;

  std::set<std::string, std::less<>> muted_;
  std::vector<std::string> fresh_places_;
  bool unlisted_error_ = false;
  std::size_t error_count_ = 0, settled_ = 0;
};

}  // namespace sinew
