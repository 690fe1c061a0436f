// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

/// - error: the file cannot be loaded.
/// - warning: the file loads, with a repair.
/// - info: nothing is wrong; the file is larger than it must be, or otherwise odd.
enum class Severity { error, warning, info };

/// "error", "warning" or "info".
const char* name_of(Severity severity) noexcept;

/// One rule that a file breaks: which rule, where in the file, and the numbers of this case.
struct ImportIssue {
  Severity severity = Severity::error;
  std::string rule;          ///< stable identifier such as "accessor-fit"; importer/rules.inc lists them all
  std::string json_pointer;  ///< RFC 6901, for example /accessors/3/count; empty for the whole file
  std::string detail;        ///< what is wrong here, with its numbers; for a warning also the repair
  /// Places that break the rule and that this entry stands for: its own, and with the last entry of a rule those that
  /// are not listed.
  std::size_t cases = 1;
};

/// Why an import failed: the first error, further errors of the file that are not mere consequences of another one, and
/// all warnings.
struct ImportError {
  std::string file;
  ImportIssue issue;
  std::vector<ImportIssue> more_errors;
  std::vector<ImportIssue> warnings;
};

template <class T>
using ImportResult = tl::expected<T, ImportError>;

/// One line as programs print it: "FILE: /accessors/3/count: error: accessor-fit: ...". Control characters from the
/// file are escaped.
std::string describe(std::string_view file, const ImportIssue& issue);

}  // namespace sinew
