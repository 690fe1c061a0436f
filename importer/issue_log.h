// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/import_error.h"
#include "importer/rules.h"

namespace sinew {

/// Quotes text from the file for a message; cut after 80 bytes.
std::string in_quotes(std::string_view text);

/// Collects the issues of one import. A step reports issues and continues while that is safe. Between steps, the import
/// calls settle(), removes broken parts, and continues or ends.
class IssueLog {
 public:
  /// in    listed   number of issues kept for each rule and severity; further ones are only counted
  explicit IssueLog(std::size_t listed = kMaxPerRule) : listed_(listed) {}

  /// Reports that the file breaks a rule, with the severity of the rule.
  /// in    json_pointer   location, such as "/accessors/3/count"; empty for the whole file
  ///       detail         the violation, with its numbers
  void report(Rule rule, std::string json_pointer, std::string detail);

  /// Reports an error rule as a warning, because the scene does not need the broken part.
  void report_as_warning(Rule rule, std::string json_pointer, std::string detail);

  /// Reports an error after which the import goes on, because the reporting step itself leaves out or repairs the
  /// broken part. It is not counted as an error; import_gltf() returns it among the warnings, with severity error.
  void report_survived(Rule rule, std::string json_pointer, std::string detail);

  /// Turns all errors so far into survived ones: the import goes on without the broken parts, and the scene is sound.
  /// in   consequence(json_pointer)   what is left out, as the end of the message
  void survive(const std::function<std::string(std::string_view)>& consequence);

  /// True if there was no error since the last settle().
  bool ok() const noexcept { return error_count_ == settled_; }

  /// Number of errors so far, including muted ones. Comparing two values tells if an operation failed.
  std::size_t error_count() const noexcept { return error_count_; }

  /// Returns the locations of all errors since the last call, for code that removes the broken parts.
  /// out   empty if there were more than kMaxPlaces errors, or one of memory-budget: steps stop at it, so that what
  ///       follows is not checked
  std::optional<std::vector<std::string>> settle();

  /// From now on, does not list issues at or below this location, because they follow from a known error. Errors there
  /// still count.
  void mute(std::string json_pointer) { muted_.insert(std::move(json_pointer)); }

  /// Moves the issues out, in the form that import_gltf() returns.
  std::vector<ImportIssue> take_warnings();
  ImportError take_error(std::string file);

  static constexpr std::size_t kMaxPerRule = 64;
  static constexpr std::size_t kMaxPlaces = 4096;  ///< error locations kept between two settle() calls

 private:
  /// Counters of one rule and severity.
  struct Tally {
    std::size_t listed = 0;
    std::size_t last = 0;  ///< index in issues_ of the last listed one
  };
  /// An issue, and if it ends the import.
  struct Entry {
    ImportIssue issue;
    bool fatal = false;
  };
  void name_unlisted();

  std::size_t listed_;
  std::vector<Entry> issues_;
  std::vector<std::array<Tally, 3>> tallies_;  ///< [rules][severities]
  void add(Severity severity, bool fatal, Rule rule, std::string json_pointer, std::string detail);
  bool is_muted(std::string_view json_pointer) const;

  std::set<std::string, std::less<>> muted_;
  std::vector<std::string> fresh_places_;
  bool has_no_place_ = false;
  std::size_t error_count_ = 0, settled_ = 0;
};

}  // namespace sinew
