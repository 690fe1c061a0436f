// SPDX-License-Identifier: MIT
// Parsing JSON text into a tree: valid JSON is accepted, everything else refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "importer/file/json_fault.h"
#include "importer/file/json_shape.h"
#include "importer/file/parse_json.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

std::unique_ptr<JsonTree> parse(const std::string& text) {
  IssueLog log;
  return parse_json(bytes_of(text), log);
}

double number(const std::string& text) {
  const auto tree = parse(text);
  return tree != nullptr && tree->root.IsNumber() ? tree->root.GetDouble() : std::nan("");
}

TEST(json, T10_numbers_are_the_nearest_doubles) {
  FixedRandom random(3);
  char text[400];
  for (int i = 0; i < 20'000; ++i) {
    const double value = (random.unit() - 0.5) * std::pow(10.0, random.in(-320, 307));
    std::snprintf(text, sizeof text, i % 3 == 0 ? "%.17g" : i % 3 == 1 ? "%.9e" : "%.30f", value);
    EXPECT_EQ(number(text), std::strtod(text, nullptr)) << text;
  }
  for (const char* odd :
       {"0", "-0", "1e-400", "4.9e-324", "2.4703282292062328e-324", "1.7976931348623158e308", "9007199254740993",
        "18446744073709551615", "18446744073709551616", "-9223372036854775809", "123456789012345678901234567890.5e-3"})
    EXPECT_EQ(number(odd), std::strtod(odd, nullptr)) << odd;
  EXPECT_EQ(parse("1e309"), nullptr) << "no finite number";
}

TEST(json, text_is_utf8_also_where_it_is_escaped) {
  for (const char* bad :
       {"\"\xed\xa0\x80\"", "\"\\ud800\"", "\"\\udc00\"", "\"\\ud800x\"", "\"\\ud800\\u0041\"", "\"\xc0\x80\"",
        "\"\xf5\x80\x80\x80\"", "\"\xe2\x82\"", "{\"\\udfff\":1}", "\"\x01\"", "\"\\x\"", "\"\\u12g4\""})
    EXPECT_EQ(parse(bad), nullptr) << bad;
  const std::string text = R"("\ud83d\ude00 \u00e9 ퟿")";
  const auto tree = parse(text);
  ASSERT_NE(tree, nullptr);
  EXPECT_EQ(text_of(tree->root), "\xF0\x9F\x98\x80 \xC3\xA9 \xED\x9F\xBF");
}

TEST(json, T11_strings_are_not_copied_out_of_the_text_unless_they_are_escaped) {
  const std::string text =
      "\xEF\xBB\xBF"
      R"( {"plain":"abc","":"","esc\u0061ped":"abc\n"} )";
  const auto tree = parse(text);
  ASSERT_NE(tree, nullptr);
  const auto in_text = [&](std::string_view value) {
    return value.data() >= text.data() && value.data() < text.data() + text.size();
  };
  EXPECT_TRUE(in_text(text_of(*find_member(tree->root, "plain"))));
  EXPECT_EQ(text_of(*find_member(tree->root, "plain")), "abc");
  EXPECT_EQ(text_of(*find_member(tree->root, "")), "");
  ASSERT_NE(find_member(tree->root, "escaped"), nullptr);
  EXPECT_FALSE(in_text(text_of(*find_member(tree->root, "escaped"))));
  EXPECT_EQ(text_of(*find_member(tree->root, "escaped")), "abc\n");
}

TEST(json, what_json_does_not_allow_is_refused) {
  for (const char* bad : {"",    " ",        "{", "[1,]", "{\"a\":1,}", "{a:1}", "01",      "+1",    ".5", "1.", "1e",
                          "NaN", "Infinity", "-", "'a'",  "[1] [2]",    "nul",   "/* */ 1", "[1 2]", "\"", "tru"})
    EXPECT_EQ(parse(bad), nullptr) << bad;
}

/// Changes a few bytes, mostly to those that mean something in JSON.
std::string damaged(std::string text, FixedRandom& random) {
  constexpr std::string_view kTelling =
      "{}[]\",:\\/0123456789+-.eEutrfnalsb \n\t\x01\x7f\x80\xbf\xc2\xe0\xed\xa0\xf4\x90\xff";
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    const std::uint32_t at = random.below(static_cast<std::uint32_t>(text.size()));
    const char byte = kTelling[random.below(static_cast<std::uint32_t>(kTelling.size()))];
    switch (random.below(4)) {
      case 0: text.erase(at, 1 + random.below(9)); break;
      case 1: text.insert(at, 1, byte); break;
      case 2:
        text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), random.below(40)));
        break;
      default: text[at] = byte;
    }
    if (text.empty()) text = " ";
  }
  return text;
}

/// nlohmann's reader is the truth. Text that is refused has a fault with a name.
TEST(json, damaged_text_is_judged_and_read_as_by_another_reader) {
  const std::string texts[] = {
      R"({"asset": {"version": "2.0"}, "nodes": [{"name": "\ud83d\ude00 \u00e9 ß日本 𝄞", "scale": [1, -2.5e-3, 0.1]}]})",
      R"([0, -0, 0.0, 12345678901234567890, -9223372036854775808, 18446744073709551616, 1e300, 0.30000000000000004])",
      R"({"a long name of a property, longer than a word": "line\nline\ttab \"quoted\" \/ \\", "b": [true, false, null, {}, []]})",
      "[\"\x7f plain text of many bytes, then \xf4\x8f\xbf\xbf\", \"\xe1\x80\x80\xed\x9f\xbf\xee\x80\x80\", "
      "\"\\u0000\"]"};
  FixedRandom random(7);
  std::size_t good = 0, bad = 0;
  for (int i = 0; i < 60'000; ++i) {
    const std::string text = i < 4 ? texts[i] : damaged(texts[random.below(4)], random);
    const Json truth = Json::parse(text, nullptr, false);
    const auto tree = parse(text);
    ASSERT_EQ(tree == nullptr, truth.is_discarded()) << text;
    ASSERT_TRUE(tree != nullptr || !describe_json_fault(text).empty()) << text;
    ++(tree != nullptr ? good : bad);
    if (tree != nullptr) {
      ASSERT_EQ(to_json(tree->root), truth) << text;
    }
  }
  EXPECT_GT(good, 1000u);
  EXPECT_GT(bad, 1000u);
}

TEST(json, the_last_of_two_values_with_one_name_counts_and_is_reported) {
  const auto result = import_gltf(
      bytes_of(
          R"({"asset":{"version":"2.0"},"nodes":[{"name":"a","name":"b","mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":7,"POSITION":0}}]}],
                                               "accessors":[{"componentType":5126,"type":"VEC3","count":3}]})"),
      "x");
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->scene.skeleton.names[0], "b");
  EXPECT_EQ(result->scene.meshes[0].primitives[0].vertex_count(), 3u);
  EXPECT_TRUE(warns(result, "json-duplicate", "/nodes/0"));
  EXPECT_TRUE(warns(result, "json-duplicate", "/meshes/0/primitives/0/attributes"));
}

TEST(json, many_names_are_compared_too) {
  std::string attributes = R"("POSITION":0)";
  for (int i = 0; i < 30; ++i) attributes += ",\"_" + std::to_string(i) + "\":0";
  const auto import = [&](const std::string& more) {
    return import_gltf(bytes_of(R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{)" + attributes +
                                more + R"(}}]}],"accessors":[{"componentType":5126,"type":"VEC3","count":3}]})"),
                       "x");
  };
  EXPECT_FALSE(warns(import(""), "json-duplicate", "/meshes/0/primitives/0/attributes"));
  EXPECT_TRUE(warns(import(R"(,"_7":0)"), "json-duplicate", "/meshes/0/primitives/0/attributes"));
}

TEST(json, trees_go_into_values_and_back) {
  const std::string text = R"({"a":[1,-2,3.5,true,null,"x\u0000y",18446744073709551615],"b":{}})";
  const auto tree = parse(text);
  ASSERT_NE(tree, nullptr);
  const auto value = to_json(tree->root);
  EXPECT_EQ(value["a"][5], std::string("x\0y", 3));
  EXPECT_EQ(value["a"][6], 18446744073709551615u);
  JsonTree back(1024);
  back.root = from_json(value, back.pool);
  EXPECT_EQ(to_json(back.root), value);
}

}  // namespace
}  // namespace sinew::test
