// SPDX-License-Identifier: MIT
#include "runtime/procedures/expressions/expressions.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

using Override = Expression::Override;
using Part = Expression::Part;

/// Weights of a face: expression i sets weight i.
std::vector<float> weights_of(std::vector<Expression> expressions, const std::vector<float>& values) {
  std::vector<float> weights(expressions.size(), 0.0f);
  for (std::uint32_t e = 0; e < expressions.size(); ++e)
    if (expressions[e].binds.empty()) expressions[e].binds = {{e, 1.0f}};
  const test::AllocationCounter counter;
  EXPECT_EQ(run(ExpressionsJob{expressions, values, weights}), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  return weights;
}

using Weights = std::vector<float>;

TEST(expressions, binds_add_up) {
  EXPECT_EQ(weights_of({{.binds = {{0, 0.5f}, {1, 1.0f}}}, {.binds = {{0, 0.25f}}}}, {0.5f, 1.0f}),
            (Weights{0.5f, 0.5f}));
}

TEST(expressions, binary_ones_are_on_above_a_half) {
  EXPECT_EQ(weights_of({{.is_binary = true}, {.is_binary = true}}, {0.5f, 0.51f}), (Weights{0.0f, 1.0f}));
}

TEST(expressions, one_may_block_or_blend_parts_of_the_face) {
  const Expression blink{.part = Part::blink}, mouth{.part = Part::mouth}, look{.part = Part::look_at};
  const Expression happy{.blink = Override::block, .look_at = Override::blend};
  EXPECT_EQ(weights_of({blink, mouth, look, happy}, {1.0f, 1.0f, 0.5f, 0.25f}), (Weights{0.0f, 1.0f, 0.375f, 0.25f}));
  EXPECT_EQ(weights_of({blink, mouth, look, happy}, {1.0f, 1.0f, 0.5f, 0.0f}), (Weights{1.0f, 1.0f, 0.5f, 0.0f}));
  const Expression blends{.mouth = Override::blend};
  EXPECT_EQ(weights_of({mouth, blends, blends}, {1.0f, 0.75f, 0.75f}), (Weights{0.0f, 0.75f, 0.75f})) << "not below 0";
}

TEST(expressions, a_binary_one_that_is_held_back_is_off) {
  const Expression blink{.is_binary = true, .part = Part::blink}, happy{.blink = Override::blend};
  EXPECT_EQ(weights_of({blink, happy}, {1.0f, 0.25f}), (Weights{0.0f, 0.25f}));
}

TEST(expressions, presets_have_their_parts) {
  for (const auto& [name, part] : {std::pair{"blinkLeft", Part::blink}, std::pair{"lookUp", Part::look_at},
                                   std::pair{"ou", Part::mouth}, std::pair{"happy", Part::other}})
    EXPECT_EQ(part_of_preset(name), part) << name;
}

TEST(expressions, refuses_what_does_not_fit) {
  const std::vector<Expression> one{{.binds = {{1, 1.0f}}}};
  std::vector<float> values{0.5f}, weights(2);
  EXPECT_EQ(check(ExpressionsJob{one, values, weights}), ErrorCode::ok);
  EXPECT_EQ(check(ExpressionsJob{one, {}, weights}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(ExpressionsJob{one, values, std::span(weights).first(1)}), ErrorCode::index_out_of_range);
  for (const float bad : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()}) {
    values[0] = bad;
    EXPECT_EQ(check(ExpressionsJob{one, values, weights}), ErrorCode::not_a_fraction);
  }
}

}  // namespace
}  // namespace sinew
