// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

/// - error: data are lost. Either the import fails, or it succeeds without a part that nothing else needs, such as an
///   animation channel; the error is then among ImportedFile::warnings.
/// - warning: the file loads, with a repair.
/// - info: the file is valid, but larger than necessary or unusual.
enum class Severity { error, warning, info };

/// Returns "error", "warning" or "info".
const char* name_of(Severity severity) noexcept;

/// One violation of a rule: the rule, the location in the file, and the details.
struct ImportIssue {
  Severity severity = Severity::error;
  std::string rule;          ///< stable identifier such as "accessor-fit"; importer/rules.inc lists them all
  std::string json_pointer;  ///< RFC 6901, for example /accessors/3/count; empty for the whole file
  std::string detail;        ///< the violation with its numbers; for a warning also the repair
  /// Number of violations that this entry stands for. 1, except for the last listed entry of a rule, which also counts
  /// the unlisted ones.
  std::size_t cases = 1;
};

/// Why an import failed: the first error, further independent errors, and all warnings.
struct ImportError {
  std::string file;
  ImportIssue issue;
  std::vector<ImportIssue> more_errors;
  std::vector<ImportIssue> warnings;
};

template <class T>
using ImportResult = tl::expected<T, ImportError>;

/// Formats an issue as one line: "FILE: /accessors/3/count: error: accessor-fit: ...". Control characters from the file
/// are escaped.
std::string describe(std::string_view file, const ImportIssue& issue);

}  // namespace sinew
