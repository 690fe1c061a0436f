// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "runtime/procedures/springs/springs_job.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// A chain of bones of one metre that hangs down from joint 0, and springs for joints 1 and on.
struct HangingChain {
  Skeleton skeleton;
  SpringSetup setup;

  explicit HangingChain(std::uint32_t springs = 4) : skeleton(chain_skeleton(springs + 2)) {
    for (std::uint32_t j = 1; j < springs + 2; ++j) skeleton.rest[j].translation = {0.0f, -1.0f, 0.0f};
    setup.groups.resize(1);
    for (std::uint32_t j = 1; j <= springs; ++j)
      setup.joints.push_back({.joint = j, .tail_m = {0.0, -1.0, 0.0}, .stiffness = 1.0, .drag = 0.4});
  }
};

/// The figure of eight of one second on which springs are compared.
inline Vec3<double> figure_of_eight(double t_s) {
  constexpr double kPi = std::numbers::pi;
  return {0.5 * std::sin(2.0 * kPi * t_s), 0.0, 0.25 * std::sin(4.0 * kPi * t_s)};
}

/// A character with springs, its state and its memory. Each frame starts from `pose`, the animated pose.
class SpringStage {
 public:
  SpringStage(const Skeleton& skeleton, const SpringSetup& setup, const SpringSettings& settings = {})
      : skeleton_(skeleton), springs_(compile_springs(skeleton, setup, settings).value()), pose_(skeleton.rest.size()) {
    pose.assign(skeleton.rest.begin(), skeleton.rest.end());
    tails.resize(setup.joints.size());
    state.resize(springs_.state_bytes() / 8 + 1, 0);
    scratch_.resize(springs_.scratch_bytes() / 8 + 1, 0);
  }

  std::vector<Transform> pose;
  Affined root;
  SpringEvent event = SpringEvent::none;
  float weight = 1.0f;
  std::vector<Vec3<double>> tails;
  SpringCounts counts;
  std::vector<std::uint64_t> state;

  SpringsJob job(double dt_s) {
    for (std::size_t j = 0; j < pose.size(); ++j) pose_.span().set(j, pose[j]);
    return {.springs = &springs_,
            .skeleton = &skeleton_,
            .pose = pose_.span(),
            .root = root,
            .dt_s = dt_s,
            .state = std::as_writable_bytes(std::span(state)),
            .scratch = std::as_writable_bytes(std::span(scratch_)),
            .event = event,
            .weight = weight,
            .tails = tails,
            .counts = &counts};
  }
  void frame(double dt_s) {
    const SpringsJob step = job(dt_s);
    ASSERT_EQ(run(step), ErrorCode::ok);
    event = SpringEvent::none;
  }
  void move_root(const Vec3<double>& to) {
    for (int r = 0; r < 3; ++r) root.row[r].w = to[r];
  }
  glm::quat rotation(std::size_t joint) { return pose_.span().get(joint).rotation; }
  const Springs& springs() const { return springs_; }

 private:
  const Skeleton& skeleton_;
  Springs springs_;
  PoseBuffer pose_;
  std::vector<std::uint64_t> scratch_;
};

}  // namespace sinew::test
