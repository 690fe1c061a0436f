// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <vector>

namespace sinew::test {

/// A function, class or test of a namespace: its name, and all of its text from what stands before `{` to `}`.
struct Definition {
  std::string name;  ///< "f(" of a function, "C" of a class, "TEST_F(" and so on of a test
  std::string text;

  bool is_test() const;
};

/// Definitions of a source, without those inside of classes and functions.
std::vector<Definition> definitions_of(const std::string& source);

/// "suite.name" of a test.
std::string test_name(const Definition& test);

/// Names of everything that may skip a test: GTEST_SKIP, functions and classes that call it or a function that does,
/// and classes derived from such a class.
std::set<std::string> skipping_names(const std::vector<Definition>& definitions);

/// Whether a test is disabled, or it, its suite or something that it calls may skip it.
bool may_be_skipped(const Definition& test, const std::set<std::string>& skipping);

}  // namespace sinew::test
