// SPDX-License-Identifier: MIT
// Parameters that graphs compute from others.
#include "runtime/graph/graph_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "runtime/graph/graph_bytes.h"
#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

using Kind = GraphFormulaKind;
using test::GraphPlayer;

constexpr float kMost = std::numeric_limits<float>::max();

GraphFormulaStep number(float value) { return {.value = value}; }
GraphFormulaStep read(GraphIndex parameter) { return {0.0f, parameter, Kind::parameter}; }
GraphFormulaStep step(Kind kind) { return {.kind = kind}; }

/// The value of steps with parameters a (0), b (1) and c (2).
float value_of(const std::vector<GraphFormulaStep>& steps, float a, float b = 0.0f, float c = 0.0f) {
  GraphBuilder builder;
  builder.number("a");
  builder.number("b");
  builder.number("c");
  const GraphIndex made = builder.computed("d", steps);
  const auto graph = builder.build(builder.clip("clip"));
  if (!graph) ADD_FAILURE() << graph.error().rule;
  const std::vector<float> given = {a, b, c, 99.0f};
  return GraphValues(graph->tables(), given).all()[made];
}

TEST(graph_values, each_step_follows_its_equation) {
  struct Case {
    Kind kind;
    std::function<double(double, double, double)> truth;
  };
  const std::vector<Case> cases = {
      {Kind::negate, [](double a, double, double) { return -a; }},
      {Kind::absolute, [](double a, double, double) { return std::fabs(a); }},
      {Kind::is_false, [](double a, double, double) { return a == 0 ? 1 : 0; }},
      {Kind::add, [](double a, double b, double) { return a + b; }},
      {Kind::subtract, [](double a, double b, double) { return a - b; }},
      {Kind::multiply, [](double a, double b, double) { return a * b; }},
      {Kind::divide, [](double a, double b, double) { return b == 0 ? 0 : a / b; }},
      {Kind::minimum, [](double a, double b, double) { return a < b ? a : b; }},
      {Kind::maximum, [](double a, double b, double) { return a > b ? a : b; }},
      {Kind::length, [](double a, double b, double) { return std::hypot(a, b); }},
      {Kind::below, [](double a, double b, double) { return a < b ? 1 : 0; }},
      {Kind::below_or_equal, [](double a, double b, double) { return a <= b ? 1 : 0; }},
      {Kind::equal, [](double a, double b, double) { return a == b ? 1 : 0; }},
      {Kind::both, [](double a, double b, double) { return a != 0 && b != 0 ? 1 : 0; }},
      {Kind::either, [](double a, double b, double) { return a != 0 || b != 0 ? 1 : 0; }},
      {Kind::choose, [](double a, double b, double c) { return a != 0 ? b : c; }},
  };
  for (const Case& one : cases)
    for (const float a : {-2.5f, 0.0f, 0.3f, 7.0f})
      for (const float b : {-2.5f, 0.0f, 0.3f, 1e20f}) {
        std::vector<GraphFormulaStep> steps;
        for (GraphIndex p = 0; p < operands_of(one.kind); ++p) steps.push_back(read(p));
        steps.push_back(step(one.kind));
        const double truth = one.truth(static_cast<double>(a), static_cast<double>(b), 5.0);
        EXPECT_FLOAT_EQ(value_of(steps, a, b, 5.0f), static_cast<float>(truth))
            << "kind " << static_cast<int>(one.kind) << " of " << a << ' ' << b;
      }
}

TEST(graph_values, results_beyond_float_are_its_largest_numbers) {
  const std::vector<GraphFormulaStep> square = {read(0), read(0), step(Kind::multiply)};
  EXPECT_EQ(value_of(square, kMost), kMost);
  const std::vector<GraphFormulaStep> difference = {
      read(0), read(0), step(Kind::multiply), read(0), read(0), step(Kind::multiply), step(Kind::subtract)};
  EXPECT_EQ(value_of(difference, kMost), 0.0f) << "no difference of infinities";
  EXPECT_EQ(value_of({read(0), step(Kind::negate), read(0), step(Kind::multiply)}, kMost), -kMost);
}

TEST(graph_values, a_graph_plays_by_what_it_computes) {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed");
  const GraphIndex rate = b.computed("rate", std::vector{read(speed), number(2.0f), step(Kind::divide)});
  const GraphIndex fast = b.computed("fast", std::vector{number(1.0f), read(rate), step(Kind::below)});
  const GraphIndex machine = b.machine("m");
  const GraphIndex walk = b.state(machine, "walk", b.clip("walk", {.speed_parameter = rate}));
  const GraphIndex run = b.state(machine, "run", b.clip("run"));
  b.transition(machine, walk, {.duration_s = 0.0f, .to = run}, {when_on(fast)});
  GraphPlayer player(b, machine, {{0, 10.0}, {1, 10.0}});
  player.set(speed, 1.0f);
  player.set(rate, 77.0f);  // has no effect
  player.advance(2.0);
  EXPECT_EQ(player.active(), "walk");
  ASSERT_EQ(player.ops().size(), 1u);
  EXPECT_DOUBLE_EQ(player.ops()[0].time_s, 1.0);
  player.set(speed, 2.5f);
  player.advance(0.0);
  EXPECT_EQ(player.active(), "run");
}

TEST(graph_values, entry_rules_read_what_is_computed) {
  GraphBuilder b;
  const GraphIndex wish = b.number("wish", 3.0f);
  const GraphIndex high = b.computed("high", std::vector{number(2.0f), read(wish), step(Kind::below)});
  const GraphIndex machine = b.machine("m");
  b.state(machine, "low", b.clip("a"));
  const GraphIndex top = b.state(machine, "top", b.clip("b"));
  b.entry(machine, {.to = top}, {when_on(high)});
  GraphPlayer player(b, machine, {{0, 1.0}, {1, 1.0}});
  EXPECT_EQ(player.active(), "top");
}

TEST(graph_values, each_rule_names_the_formula_that_breaks_it) {
  struct Case {
    const char* text;
    std::function<void(GraphTables&)> change;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Case> cases = {
      {"formula 0: it reads a parameter that is not computed before it",
       [](auto& t) { t.formula_steps[0] = read(t.formulas[1].parameter); }},
      {"formula 1: it reads a parameter that is not computed before it",
       [](auto& t) { t.formula_steps[t.formulas[1].first_step] = read(t.formulas[1].parameter); }},
      {"formula 0: it reads a parameter that does not exist", [](auto& t) { t.formula_steps[0] = read(99); }},
      {"formula 0: it reads a trigger, which has no value", [](auto& t) { t.formula_steps[0] = read(1); }},
      {"formula 0: a number of it is not finite", [=](auto& t) { t.formula_steps[1].value = kNan; }},
      {"formula 0: a step of it is of an unknown kind",
       [](auto& t) { t.formula_steps[2].kind = static_cast<Kind>(99); }},
      {"formula 0: a step of it lacks operands", [](auto& t) { t.formula_steps[1].kind = Kind::add; }},
      {"formula 0: its steps do not end with one number", [](auto& t) { t.formulas[0].step_count = 2; }},
      {"formula 0: its steps do not end with one number", [](auto& t) { t.formulas[0].step_count = 0; }},
      {"formula 1: its steps do not exist", [](auto& t) { t.formulas[1].step_count = 99; }},
      {"formula 0: its parameter does not exist", [](auto& t) { t.formulas[0].parameter = 99; }},
      {"formula 0: its parameter is a trigger, which has no value", [](auto& t) { t.formulas[0].parameter = 1; }},
      {"formula 1: its parameter has another formula, too",
       [](auto& t) { t.formulas[1].parameter = t.formulas[0].parameter; }},
      {"formula 0: it needs more than 16 numbers at once",
       [](auto& t) {
         t.formulas[0] = {t.formulas[0].parameter, static_cast<GraphIndex>(t.formula_steps.size()), 17};
         t.formula_steps.insert(t.formula_steps.end(), 17, number(1));
       }},
      {"formula 0: a graph with formulas has more than 256 parameters",
       [](auto& t) { t.parameters.resize(257, t.parameters[0]); }},
  };
  GraphBuilder b;
  const GraphIndex speed = b.number("speed");
  b.trigger("jump");
  const GraphIndex half = b.computed("half", std::vector{read(speed), number(2), step(Kind::divide)});
  b.computed("less", std::vector{read(half), step(Kind::negate)});
  const GraphTables sound = b.tables(b.clip("clip"));
  ASSERT_EQ(find_fault(sound).code, ErrorCode::ok);
  for (const Case& one : cases) {
    GraphTables tables = sound;
    one.change(tables);
    EXPECT_EQ(describe(find_fault(tables), tables), one.text);
  }
}

TEST(graph_values, bytes_keep_formulas_and_curves_in_the_version_that_has_them) {
  GraphBuilder plain;
  EXPECT_EQ(write_graph_bytes(plain.tables(plain.clip("clip")))[7], std::byte{1});
  GraphBuilder b;
  const GraphIndex speed = b.number("speed");
  b.computed("half", std::vector{read(speed), number(2), step(Kind::divide)});
  const GraphIndex machine = b.machine("m");
  const GraphIndex only = b.state(machine, "only", b.clip("clip"));
  b.transition(machine, only, {.to = only, .curve = b.curve(1.0f, 0.5f)}, {when_played(1)});
  const std::vector<std::byte> bytes = write_graph_bytes(b.tables(machine));
  EXPECT_EQ(bytes[7], std::byte{2});
  const auto again = read_graph_bytes(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(write_graph_bytes(*again), bytes);
  EXPECT_EQ(again->formulas[0].parameter, 1);
  EXPECT_EQ(again->transitions[0].curve, 0);
  EXPECT_EQ(again->curve_keys[0].slope, 1.0f);
  std::vector<std::byte> unknown = bytes;
  unknown[7] = std::byte{3};
  EXPECT_FALSE(read_graph_bytes(unknown));
}

}  // namespace
}  // namespace sinew
