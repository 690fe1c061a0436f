// SPDX-License-Identifier: MIT
// Every hard case has a test that carries its ID in its name.
#include "tests/architecture/hard_cases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"
#include "tests/architecture/test_definitions.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

/// Rows of the table that must have a test; the others are only printed.
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

/// Rows about shaders, which no test reaches without a GPU device. Every other row needs a test that runs on every
/// machine: a test that skips itself does not count.
constexpr std::string_view kOnShaders[] = {"N31", "N32", "N33", "N35"};

bool must_be_covered(std::string_view id) {
  const int number = std::atoi(id.data() + 1);
  return std::any_of(std::begin(kMustBeCovered), std::end(kMustBeCovered), [&](const Rows& rows) {
    return rows.letter == id[0] && rows.first <= number && number <= rows.last;
  });
}

/// IDs in a test's name: words between underscores that consist of a letter and a number.
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

/// Definitions in all test sources. The tests of the references are left out: they cover no row.
std::vector<Definition> test_definitions() {
  std::vector<Definition> all;
  for (const SourceFile& file : source_tree())
    if (file.in("tests") && !file.in("tests/reference"))
      std::ranges::move(definitions_of(file.text), std::back_inserter(all));
  return all;
}

std::multimap<std::string, std::string> find_tests_by_id() {
  const std::vector<Definition> definitions = test_definitions();
  const std::set<std::string> skipping = skipping_names(definitions);
  std::multimap<std::string, std::string> found;
  for (const Definition& test : definitions) {
    if (!test.is_test()) continue;
    const bool always_runs = !may_be_skipped(test, skipping);
    for (const std::string& id : ids_in(test_name(test)))
      if (always_runs || std::ranges::count(kOnShaders, id) > 0) found.emplace(id, test_name(test));
  }
  return found;
}

const std::multimap<std::string, std::string>& tests_by_id() {
  static const auto found = find_tests_by_id();
  return found;
}

TEST(hard_cases, each_has_a_test_that_carries_its_id) {
  const auto& tests = tests_by_id();
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

std::vector<std::string> tests_that_always_run(const std::string& source) {
  const std::vector<Definition> definitions = definitions_of(source);
  std::vector<std::string> names;
  for (const Definition& d : definitions)
    if (d.is_test() && !may_be_skipped(d, skipping_names(definitions))) names.push_back(test_name(d));
  return names;
}

TEST(hard_cases, only_enabled_tests_and_whole_words_count) {
  const std::string source =
      "#if defined(X)\nnamespace sinew { namespace {\nTEST(a, G06_x) {}\n// TEST(a, G07_x) {}\n#endif\nTEST_F(b,\n  "
      "y_N12_G13) {}\nTEST(a, DISABLED_G08_x) {}\nTEST(a, G09x_XG10) {}\n}\n"
      "RC_GTEST_PROP(p, T10_z, (int i)) {}\nvoid f() { EXPECT_EQ(TESTS(a, G11_x), 1); }\n}\n";
  EXPECT_THAT(tests_that_always_run(source), ElementsAre("a.G06_x", "b.y_N12_G13", "a.G09x_XG10", "p.T10_z"));
  EXPECT_THAT(ids_in("b.y_N12_G13"), ElementsAre("N12", "G13"));
  EXPECT_THAT(ids_in("a.G09x_XG10"), testing::IsEmpty());
  EXPECT_THAT(ids_in("p.T10_z"), ElementsAre("T10"));
}

TEST(hard_cases, tests_that_may_skip_do_not_count_wherever_the_skip_stands) {
  const std::string source =
      "class Device : public testing::Test {\n  void SetUp() override { if (!x) GTEST_SKIP() << 1; }\n};\n"
      "template <class T>\nclass Picture : public Device {};\n"
      "struct Plain : testing::Test {};\n"
      "void expect_all(int i) { if (i == 0) GTEST_SKIP(); }\nvoid expect_twice() { expect_all(1); }\n"
      "TEST(a, itself) { if (!corpus()) { GTEST_SKIP() << 1; } }\nTEST_F(Device, fixture) {}\nTEST_F(Picture, base) "
      "{}\n"
      "TEST(a, helper) { expect_all(0); }\nTEST_P(a, helper_of_helper) { expect_twice(); }\n"
      "TEST_F(Plain, always) { const char* text = \"GTEST_SKIP\"; }  // GTEST_SKIP\n";
  EXPECT_THAT(tests_that_always_run(source), ElementsAre("Plain.always"));
}

}  // namespace
}  // namespace sinew::test
