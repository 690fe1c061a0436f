// SPDX-License-Identifier: MIT
// Every hard case has a test that carries its ID in its name.
#include "tests/architecture/hard_cases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <regex>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

/// Rows that must have a test; the rest of the table is only printed.
struct Rows {
  char letter;
  int first, last;
};
constexpr Rows kMustBeCovered[] = {
    {'N', 1, 36},
    {'G', 1, 68},
    {'T', 1, 11},
    {'P', 1, 19},
};

/// Rows that only the references know yet: no shader interpolates quaternions.
constexpr std::string_view kOnlyReferences[] = {"N35"};

bool must_be_covered(std::string_view id) {
  const int number = std::atoi(id.data() + 1);
  return std::any_of(std::begin(kMustBeCovered), std::end(kMustBeCovered), [&](const Rows& rows) {
    return rows.letter == id[0] && rows.first <= number && number <= rows.last;
  });
}

/// "suite.name" of every enabled test that a source defines and that runs wherever the project is built: tests that
/// skip themselves prove nothing there.
std::vector<std::string> tests_of(const std::string& source) {
  static const std::regex definition(
      R"re(\b(?:TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\s*\(\s*(\w+)\s*,\s*(\w+))re");
  std::vector<std::string> names;
  const std::string code = without_comments(source);
  for (std::sregex_iterator m(code.begin(), code.end(), definition), end; m != end; ++m) {
    const std::string suite = (*m)[1], name = (*m)[2];
    const auto next = std::next(m);
    const auto body_end = next == end ? code.size() : static_cast<std::size_t>(next->position());
    const std::string body =
        code.substr(static_cast<std::size_t>(m->position()), body_end - static_cast<std::size_t>(m->position()));
    if (suite.starts_with("DISABLED_") || name.starts_with("DISABLED_") || body.find("GTEST_SKIP") != body.npos)
      continue;
    names.push_back(suite + "." + name);
  }
  return names;
}

/// IDs in a test's name: words between underscores of the form G06 or T10.
std::vector<std::string> ids_in(const std::string& test) {
  static const std::regex id("[NGTP][0-9]{1,2}");
  std::vector<std::string> ids;
  for (std::size_t begin = test.find('.') + 1; begin <= test.size();) {
    const std::size_t end = std::min(test.find('_', begin), test.size());
    if (const std::string word = test.substr(begin, end - begin); std::regex_match(word, id)) ids.push_back(word);
    begin = end + 1;
  }
  return ids;
}

std::multimap<std::string, std::string> tests_by_id() {
  std::multimap<std::string, std::string> found;
  for (const SourceFile& file : source_tree())
    if (file.path.ends_with("_test.cpp"))
      for (const std::string& test : tests_of(file.text))
        for (const std::string& id : ids_in(test))
          if (!file.path.starts_with("tests/reference/") || std::ranges::count(kOnlyReferences, id) > 0)
            found.emplace(id, test);
  return found;
}

TEST(hard_cases, each_has_a_test_that_carries_its_id) {
  const auto tests = tests_by_id();
  std::vector<std::string> missing;
  for (const HardCase& row : kHardCases) {
    std::printf("%-4s %s\n", row.id, row.claim);
    const auto [first, last] = tests.equal_range(row.id);
    for (auto test = first; test != last; ++test) std::printf("       %s\n", test->second.c_str());
    if (first != last) continue;
    std::printf("       no test carries this ID\n");
    if (must_be_covered(row.id)) missing.emplace_back(row.id);
  }
  EXPECT_THAT(missing, testing::IsEmpty());
}

TEST(hard_cases, no_test_carries_an_id_that_does_not_exist) {
  std::vector<std::string> unknown;
  for (const auto& [id, test] : tests_by_id())
    if (std::none_of(std::begin(kHardCases), std::end(kHardCases), [&](const HardCase& row) { return row.id == id; }))
      unknown.push_back(test);
  EXPECT_THAT(unknown, testing::IsEmpty());
}

TEST(hard_cases, rows_that_must_be_covered_are_all_in_the_table) {
  std::size_t expected = 0;
  for (const Rows& rows : kMustBeCovered) expected += static_cast<std::size_t>(rows.last - rows.first + 1);
  EXPECT_EQ(std::count_if(std::begin(kHardCases), std::end(kHardCases),
                          [](const HardCase& row) { return must_be_covered(row.id); }),
            static_cast<std::ptrdiff_t>(expected));
}

TEST(hard_cases, only_enabled_tests_and_whole_words_count) {
  const std::string source =
      "TEST(a, G06_x) {}\n// TEST(a, G07_x)\nTEST_F(b,\n  y_N12_G13) {}\nTEST(a, DISABLED_G08_x) {}\nTEST(a, "
      "G09x_XG10) {}\n"
      "RC_GTEST_PROP(p, T10_z, (int i)) {}\nEXPECT_EQ(TESTS(a, G11_x), 1);\n"
      "TEST(a, G14_x) { if (!corpus()) GTEST_SKIP() << 1; }\n";
  EXPECT_THAT(tests_of(source), testing::ElementsAre("a.G06_x", "b.y_N12_G13", "a.G09x_XG10", "p.T10_z"));
  EXPECT_THAT(ids_in("b.y_N12_G13"), testing::ElementsAre("N12", "G13"));
  EXPECT_THAT(ids_in("a.G09x_XG10"), testing::IsEmpty());
  EXPECT_THAT(ids_in("p.T10_z"), testing::ElementsAre("T10"));
}

}  // namespace
}  // namespace sinew::test
