// SPDX-License-Identifier: MIT
// Some calls must not occur: functions that lose digits or fail at values that skinning produces, raw intrinsics, and
// fast but inexact arithmetic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

const std::regex& unstable_calls() {
  static const std::regex calls(
      R"((\bacosf?\s*\()|(\bglm::(slerp|mix|squad|intermediate|decompose|rotation|angle|axis|exp|log|quat_cast|eulerAngles|fastMix)\s*(<[^>]*>)?\())");
  return calls;
}

/// Names are written in pieces, here and below, so that a search for them in the tree does not find this file.
const std::regex& raw_intrinsics() {
  static const std::regex names(
      R"(\b(_m{2}(256|512)?_\w+|_{2}m(128|256|512)\w*|v(ld|st)[1-4]q?_\w+)\b|[a-z]+mintrin\.h|arm_(neon|sve)\.h)");
  return names;
}

std::vector<std::string> places(const SourceFile& file, const std::regex& pattern) {
  std::vector<std::string> found;
  const auto lines = lines_of(without_comments(file.text));
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::regex_search(lines[i], pattern))
      found.push_back(file.path + ":" + std::to_string(i + 1) + ": " + lines[i]);
  return found;
}

TEST(forbidden_calls, N03_runtime_uses_neither_acos_nor_unstable_glm_functions) {
  std::vector<std::string> found;
  for (const SourceFile& file : source_tree())
    if (file.in("runtime"))
      for (const std::string& place : places(file, unstable_calls())) found.push_back(place);
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(forbidden_calls, N28_no_raw_intrinsics_anywhere) {
  std::vector<std::string> found;
  for (const SourceFile& file : source_tree())
    for (const std::string& place : places(file, raw_intrinsics())) found.push_back(place);
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(forbidden_calls, comments_and_strings_do_not_count_but_code_does) {
  EXPECT_THAT(places({"runtime/x.cpp", "// acos(x)\nfloat a = std::acos(x);\n"}, unstable_calls()), testing::SizeIs(1));
  EXPECT_THAT(places({"runtime/x.cpp", "/* glm::slerp(a, b, t) */ puts(\"acos(1)\");\n"}, unstable_calls()),
              testing::IsEmpty());
  EXPECT_THAT(places({"runtime/x.cpp", "auto q = glm::slerp(a, b, t);\n"}, unstable_calls()), testing::SizeIs(1));
  for (const std::string line : {"_"
                                 "_m128 v;",
                                 "v = _"
                                 "mm_add_ps(a, b);",
                                 "v = _"
                                 "mm512_add_ps(a, b);",
                                 "v = v"
                                 "ld1q_f32(p);",
                                 "#include <im"
                                 "mintrin.h>",
                                 "#include <arm"
                                 "_neon.h>"})
    EXPECT_THAT(places({"runtime/x.cpp", line}, raw_intrinsics()), testing::SizeIs(1)) << line;
}

}  // namespace
}  // namespace sinew::test
