// SPDX-License-Identifier: MIT
#include "runtime/pose_program/op_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using test::FixedRandom;

/// The truth: runs a program on numbers in place of poses. Each leaf is a number, and the rest pose is 0. All
/// operations are linear in them, so the result for a leaf of 1 among leaves of 0 is the leaf's share.
double value_of(PoseProgramSpan program, std::size_t leaf) {
  struct Operand {
    double value, weight;
  };
  std::vector<Operand> stack;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const PoseOp& op = program[i];
    const std::vector<Operand> of(stack.end() - static_cast<std::ptrdiff_t>(operands_of(op)), stack.end());
    stack.resize(stack.size() - of.size());
    double value = i == leaf ? 1.0 : 0.0;
    if (op.kind == PoseOpKind::mean) {
      double sum = 0.0, weights = 0.0;
      for (const Operand& one : of) {
        sum += one.weight * one.value;
        weights += one.weight;
      }
      value = of.empty() ? 0.0 : sum / (weights + std::max(0.0, op.time_s - weights));
    } else if (op.kind == PoseOpKind::overlay || op.kind == PoseOpKind::overlay_model) {
      const double w = std::min(1.0, of[1].weight);
      value = (1.0 - w) * of[0].value + w * of[1].value;
    } else if (op.kind == PoseOpKind::add_to_rest) {
      value = of[0].value + of[1].weight * of[1].value;
    } else if (op.kind == PoseOpKind::add) {
      value = of[0].value + of[1].weight * of[1].value;  // the reference is not a motion that plays
    } else if (!of.empty()) {
      value = of[0].value;
    }
    stack.push_back({value, static_cast<double>(op.weight)});
  }
  return stack.back().value;
}

PoseProgram random_program(FixedRandom& random) {
  PoseProgram program;
  std::size_t depth = 0;
  const auto weight = [&] { return 0.125f * static_cast<float>(1 + random.below(12)); };
  for (int i = 0; i < 30 || depth > 1; ++i) {
    const std::uint32_t what = i < 30 ? random.below(9) : 2;
    if (what < 2 || depth == 0) {
      program.sample(0, 0.1, weight());
      ++depth;
    } else if (what == 2) {
      const std::size_t count = 1 + random.below(static_cast<std::uint32_t>(std::min<std::size_t>(depth, 4)));
      program.mean(count, weight(), 0.25 * (1 + random.below(4)));
      depth -= count - 1;
    } else if (what == 3 && depth >= 2) {
      program.overlay(weight());
      --depth;
    } else if (what == 4 && depth >= 2) {
      program.overlay_model(weight());
      --depth;
    } else if (what == 5 && depth >= 2) {
      program.add_to_rest(weight());
      --depth;
    } else if (what == 6 && depth >= 3) {
      program.add(weight());
      depth -= 2;
    } else if (what == 7 && depth >= 5) {
      program.inertialize(0.5, 10, weight());
      depth -= 4;
    } else if (what == 8) {
      program.cached(weight());
    }
  }
  return program;
}

TEST(op_shares, agree_with_the_program_run_on_numbers) {
  FixedRandom random(11);
  for (int round = 0; round < 300; ++round) {
    const PoseProgram program = random_program(random);
    ASSERT_EQ(check(program.ops(), {.clips = 1, .slots = 255, .kept = 255}), ErrorCode::ok);
    std::vector<float> shares(program.ops().size(), -1.0f);
    find_op_shares(program.ops(), shares);
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (program.ops()[i].kind == PoseOpKind::sample) {
        EXPECT_NEAR(static_cast<double>(shares[i]), value_of(program.ops(), i), 1e-5) << round << " " << i;
      }
  }
}

TEST(op_shares, limits) {
  find_op_shares({}, {});
  float one = 0.0f;
  find_op_shares(PoseProgram().rest().ops(), {&one, 1});
  EXPECT_EQ(one, 1.0f);
  PoseProgram fade;
  fade.sample(0, 0.1, 0.75f).sample(1, 0.1, 0.25f).mean(2);
  float shares[3];
  find_op_shares(fade.ops(), shares);
  EXPECT_EQ(shares[0], 0.75f);
  EXPECT_EQ(shares[1], 0.25f);
}

}  // namespace
}  // namespace sinew
