// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <vector>

namespace sinew::test {

/// A function, class or test at namespace level: its name, and its text from the head before `{` to `}`.
struct Definition {
  std::string name;  ///< "f(" for a function, "C" for a class, "TEST_F(" and so on for a test
  std::string text;

  bool is_test() const;
};

/// Definitions of a source file, without those inside of classes and functions.
std::vector<Definition> definitions_of(const std::string& source);

/// "suite.name" of a test.
std::string test_name(const Definition& test);

/// Names of everything that may skip a test: GTEST_SKIP, functions and classes that call it or such a function, and
/// classes derived from such a class.
std::set<std::string> skipping_names(const std::vector<Definition>& definitions);

/// True if a test is disabled, or if it, its suite or something that it calls may skip it.
bool may_be_skipped(const Definition& test, const std::set<std::string>& skipping);

}  // namespace sinew::test
