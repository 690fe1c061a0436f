// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace sinew::test {

/// One source file of the repository, with its path from the root ("runtime/math/affine.h").
struct SourceFile {
  std::string path;
  std::string text;

  bool is_header() const { return path.ends_with(".h"); }
  bool in(const std::string& folder) const { return path.starts_with(folder + "/"); }
};

/// Every .h and .cpp file of runtime, importer, viewer, tests and samples, sorted by path.
std::vector<SourceFile> source_tree();

/// Lines of a text, without line ends.
std::vector<std::string> lines_of(const std::string& text);

/// Names of the #include lines with quotes (not angle brackets), in order.
std::vector<std::string> quoted_includes(const std::string& text);

/// Names of the #include lines with angle brackets.
std::vector<std::string> system_includes(const std::string& text);

/// The text with comments and the contents of string literals blanked, lines kept.
std::string without_comments(const std::string& text);

}  // namespace sinew::test
