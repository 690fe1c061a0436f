// SPDX-License-Identifier: MIT
#include "importer/visible_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "importer/import_error.h"

namespace sinew {
namespace {

TEST(visible_text, leaves_plain_text_of_all_languages_alone) {
  for (const char* text : {"", "Fox", "caf\xc3\xa9", "\xe7\x8b\x90", "\xf0\x9f\xa6\x8a", "a\\b \"c\""})
    EXPECT_EQ(visible_text(text), text);
}

TEST(visible_text, escapes_what_terminals_obey) {
  EXPECT_EQ(visible_text("\x1b[31m"), R"(\x1b[31m)");
  EXPECT_EQ(visible_text(std::string_view("a\0b\nc\td\x7f", 8)), R"(a\x00b\x0ac\x09d\x7f)");
  EXPECT_EQ(visible_text("\xc2\x9b"
                         "0m"),
            R"(\u009b0m)");
  EXPECT_EQ(visible_text("\xe2\x80\xae"
                         "txt\xe2\x81\xa6"),
            R"(\u202etxt\u2066)");
}

TEST(visible_text, escapes_bytes_that_are_no_utf8) {
  EXPECT_EQ(visible_text("\x9b"
                         "0m"),
            R"(\x9b0m)")
      << "some terminals take the byte for a control character";
  EXPECT_EQ(visible_text("\xc0\x9b"), R"(\xc0\x9b)") << "not the shortest form";
  EXPECT_EQ(visible_text("\xed\xa0\x80"), R"(\xed\xa0\x80)") << "half a surrogate pair";
  EXPECT_EQ(visible_text("\xf4\x90\x80\x80"), R"(\xf4\x90\x80\x80)") << "past the last character";
  EXPECT_EQ(visible_text("caf\xc3"), R"(caf\xc3)") << "cut short";
}

TEST(visible_json, says_the_same_and_holds_no_control_character) {
  const nlohmann::json value{{"name", "\x1b\x7f\xc2\x9b\xe2\x80\xae caf\xc3\xa9"}};
  const std::string text = visible_json(value.dump(2));
  EXPECT_EQ(nlohmann::json::parse(text), value);
  EXPECT_EQ(text, "{\n  \"name\": \"\\u001b\\u007f\\u009b\\u202e caf\xc3\xa9\"\n}");
}

TEST(describe_issue, escapes_what_comes_from_the_file) {
  const ImportIssue issue{Severity::error, "reference", "/meshes/0/\x1b", "index \x1b"};
  EXPECT_EQ(describe("f\n", issue), R"(f\x0a: /meshes/0/\x1b: error: reference: index \x1b)");
}

}  // namespace
}  // namespace sinew
