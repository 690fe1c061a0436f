// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <new>
#include <numeric>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/procedures/chain_ik.h"
#include "tests/procedures/posed.h"

namespace sinew::test {

/// A job with its memory.
struct ChainRun {
  Posed& posed;
  ChainGoal goal;

  IkResult operator()() {
    IkResult result;
    const std::size_t bytes = chain_ik_bytes(posed.skeleton, goal);
    const std::unique_ptr<std::byte, void (*)(std::byte*)> memory(
        static_cast<std::byte*>(::operator new (bytes, std::align_val_t{64})),
        [](std::byte* p) { ::operator delete (p, std::align_val_t{64}); });
    EXPECT_EQ(run(ChainIkJob{&posed.skeleton, posed.pose.span(), goal, {memory.get(), bytes}, &result}), ErrorCode::ok);
    return result;
  }
};

inline constexpr ChainSolver kSolvers[] = {ChainSolver::ccd, ChainSolver::fabrik, ChainSolver::damped};

/// Joints 0 to count - 1 of a chain.
inline std::vector<ChainIkJoint> all_joints(std::uint32_t count, std::uint32_t limit = kNone) {
  std::vector<ChainIkJoint> joints(count);
  for (std::uint32_t i = 0; i < count; ++i) joints[i] = {.joint = i, .limit = limit};
  return joints;
}

/// A chain of `count` bones that is 1 m long, slightly bent by random turns.
inline Posed random_chain(FixedRandom& random, std::uint32_t count, double most_bend_rad = 0.4) {
  Posed posed(chain_skeleton(count + 1));
  for (std::uint32_t j = 0; j <= count; ++j)
    posed.set(j, {.translation = {0, j == 0 ? 0.0f : 1.0f / static_cast<float>(count), 0},
                  .rotation = random.rotation_by<float>(random.in(0.0, most_bend_rad))});
  return posed;
}

}  // namespace sinew::test
