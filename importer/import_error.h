// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

enum class Severity { error, warning };

/// One broken rule of a file: where and why. `rule` is a stable identifier such as "accessor-fit", listed with one
/// sentence each in importer/rules.h.
struct ImportIssue {
  Severity severity = Severity::error;
  std::string rule;
  std::string json_pointer;  ///< RFC 6901, for example /accessors/3/count; empty for the container or file itself
  std::string detail;        ///< this case, with the numbers that broke the rule and, for a warning, the repair
};

/// Why an import failed: the first error, the other errors of the file as far as they can be told apart from their
/// consequences, and every warning.
struct ImportError {
  std::string file;
  ImportIssue issue;
  std::vector<ImportIssue> more_errors;
  std::vector<ImportIssue> warnings;
};

template <class T>
using ImportResult = tl::expected<T, ImportError>;

/// "FILE: /accessors/3/count: accessor-fit: ..." : what programs print.
std::string describe(std::string_view file, const ImportIssue& issue);

}  // namespace sinew
