// SPDX-License-Identifier: MIT
#include "importer/graph/formula_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "importer/graph/graph_text.h"
#include "runtime/graph/graph_values.h"

namespace sinew {
namespace {

/// A graph text with the parameters a, b, "left foot" and the formula of "result".
std::string text_with(const std::string& formula, const std::string& others = {}) {
  return R"({"graph": 1, "root": "n", "nodes": {"n": {"kind": "clip", "clip": "c"}}, "parameters": {)" + others +
         R"("a": {"kind": "number"}, "b": {"kind": "number"}, "left foot": {"kind": "flag"},
           "pull": {"kind": "trigger"}, "result": {"kind": "number", "formula": ")" +
         formula + "\"}}}";
}

GraphTextResult<GraphDefinition> compiled(const std::string& text) {
  const auto document = read_graph(text);
  return document ? compile_graph(*document) : tl::make_unexpected(document.error());
}

float value_of(const std::string& formula, float a, float b, float foot) {
  const auto graph = compiled(text_with(formula));
  if (!graph) {
    ADD_FAILURE() << formula << ": " << graph.error().json_pointer << ": " << graph.error().sentence;
    return 0.0f;
  }
  std::vector<float> given(graph->tables().parameters.size());
  given[graph->find_parameter("a")] = a;
  given[graph->find_parameter("b")] = b;
  given[graph->find_parameter("left foot")] = foot;
  return GraphValues(graph->tables(), given).all()[graph->find_parameter("result")];
}

TEST(formula_text, means_what_the_language_of_the_code_means) {
  using Truth = std::function<double(double, double, double)>;
  const std::vector<std::pair<const char*, Truth>> cases = {
      {"1 + 2 * a - b / 4 - 1", [](double a, double b, double) { return 1 + 2 * a - b / 4 - 1; }},
      {"(1 + 2) * -a - -b", [](double a, double b, double) { return (1 + 2) * -a + b; }},
      {"a / b / 2", [](double a, double b, double) { return b == 0 ? 0 : a / b / 2; }},
      {"- -a * .5e1", [](double a, double, double) { return a * 5; }},
      {"min(a, b) + max(a, b) * 10 + abs(a - b)",
       [](double a, double b, double) { return std::min(a, b) + std::max(a, b) * 10 + std::abs(a - b); }},
      {"clamp(a, -1, b)", [](double a, double b, double) { return std::min(std::max(a, -1.0), b); }},
      {"length(a, b)", [](double a, double b, double) { return std::hypot(a, b); }},
      {"if('left foot', a, b)", [](double a, double b, double f) { return f != 0 ? a : b; }},
      {"a < b", [](double a, double b, double) { return a < b; }},
      {"a <= b", [](double a, double b, double) { return a <= b; }},
      {"a > b", [](double a, double b, double) { return a > b; }},
      {"a >= b", [](double a, double b, double) { return a >= b; }},
      {"a == b", [](double a, double b, double) { return a == b; }},
      {"a != b", [](double a, double b, double) { return a != b; }},
      {"a > 0 or b > 0 and 'left foot'", [](double a, double b, double f) { return a > 0 || (b > 0 && f != 0); }},
      {"not a > 0 and not not b", [](double a, double b, double) { return !(a > 0) && b != 0; }},
  };
  for (const auto& [formula, truth] : cases)
    for (const float a : {-3.0f, 0.0f, 0.5f, 2.0f})
      for (const float b : {-3.0f, 0.0f, 0.5f, 2.0f})
        for (const float f : {0.0f, 1.0f})
          EXPECT_FLOAT_EQ(
              value_of(formula, a, b, f),
              static_cast<float>(truth(static_cast<double>(a), static_cast<double>(b), static_cast<double>(f))))
              << formula << " with " << a << ' ' << b << ' ' << f;
}

TEST(formula_text, faults_have_a_place_and_a_sentence) {
  const std::vector<std::pair<std::string, const char*>> cases = {
      {"", "none"},  // no formula: the caller sets the parameter
      {" ", "at character 2: a number, a parameter or \"(\" was expected"},
      {"a +", "at character 4: a number, a parameter or \"(\" was expected"},
      {"a b", "at character 3: an operator or the end was expected"},
      {"(a", "at character 3: \")\" was expected"},
      {"min(a)", "at character 6: \",\" was expected"},
      {"sin(a)", "at character 1: there is no function \"sin\"; there are min, max, clamp, abs, length, if"},
      {"a + and", "at character 5: a number, a parameter or \"(\" was expected"},
      {"1e99", "at character 1: a number, a parameter or \"(\" was expected"},
      {"'a", "at character 1: a number, a parameter or \"(\" was expected"},
      {"a # b", "at character 3: an operator or the end was expected"},
      {"a < b < 1", "at character 7: an operator or the end was expected"},
      {"speed", "there is no parameter \"speed\""},
      {"pull", "it reads a trigger, which has no value"},
      {"result + 1", "is computed from itself: \"result\" reads \"result\""},
      {std::string(100, '(') + "a", "at character 65: it is nested more than 64 deep"},
      {"a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a+(a))))))))))))))))", "it needs more than 16 numbers at once"},
  };
  for (const auto& [formula, sentence] : cases) {
    const auto graph = compiled(text_with(formula));
    if (graph) {
      EXPECT_EQ(std::string(sentence), "none") << formula;
      continue;
    }
    EXPECT_EQ(graph.error().json_pointer, "/parameters/result/formula");
    EXPECT_EQ(graph.error().sentence, sentence) << formula;
  }
}

TEST(formula_text, parameters_that_compute_each_other_are_named) {
  const auto graph = compiled(text_with("x", R"("x": {"kind": "number", "formula": "y + 1"},
    "y": {"kind": "number", "formula": "result"},)"));
  ASSERT_FALSE(graph);
  EXPECT_EQ(graph.error().json_pointer, "/parameters/result/formula");
  EXPECT_EQ(graph.error().sentence, "is computed from itself: \"result\" reads \"x\" reads \"y\" reads \"result\"");
  const auto trigger = compiled(text_with("a", R"("t": {"kind": "trigger", "formula": "a"},)"));
  ASSERT_FALSE(trigger);
  EXPECT_EQ(trigger.error().sentence, "a trigger has no value to compute");
  const auto initial = compiled(text_with("a", R"("t": {"kind": "number", "initial": 1, "formula": "a"},)"));
  ASSERT_FALSE(initial);
  EXPECT_EQ(initial.error().json_pointer, "/parameters/t/initial");
}

TEST(formula_text, formulas_are_computed_after_those_that_they_read) {
  const auto graph = compiled(text_with("z * 10", R"("x": {"kind": "number", "formula": "a + 1"},
    "z": {"kind": "number", "formula": "x * 2"},)"));
  ASSERT_TRUE(graph) << graph.error().sentence;
  std::vector<float> given(graph->tables().parameters.size());
  given[graph->find_parameter("a")] = 3.0f;
  EXPECT_EQ(GraphValues(graph->tables(), given).all()[graph->find_parameter("result")], 80.0f);
}

TEST(formula_text, renaming_keeps_functions_words_and_what_is_not_renamed) {
  const std::map<std::string, std::string> names = {
      {"a", "walk speed"}, {"min", "least"}, {"or", "either"}, {"left foot", "l"}, {"o'clock", "o''"}};
  EXPECT_EQ(rename_in_formula("min(a,min) or 'left foot' * b", names), "min('walk speed',least) or l * b");
  EXPECT_EQ(rename_in_formula("'or' + 'o''clock'", names), "either + 'o'''''");
  EXPECT_TRUE(parse_formula("either + 'o'''''"));
  EXPECT_EQ(parse_formula("'o'''''")->front().parameter, "o''");
  EXPECT_EQ(rename_in_formula("a +", names), "a +");
}

}  // namespace
}  // namespace sinew
