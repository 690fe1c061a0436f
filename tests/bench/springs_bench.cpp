// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/procedures/springs/springs_job.h"
#include "tests/bench/measure.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

constexpr std::uint32_t kChains = 32, kLong = 4;

/// A head with 32 hairs of four joints each, and two spheres that hang on it.
class Hair {
 public:
  Hair(bool collides, bool lagging) : skeleton_(make_skeleton()), pose_(skeleton_.joint_count()) {
    SpringSetup setup;
    setup.groups.resize(1);
    setup.colliders = {{.joint = 0, .radius_m = 0.1}, {.joint = 0, .offset = {0.0, -0.4, 0.0}, .radius_m = 0.2}};
    if (collides) setup.groups[0].colliders = {0, 1};
    for (std::uint32_t j = 1; j <= kChains * kLong; ++j)
      setup.joints.push_back({.joint = j, .tail_m = {0.0, -0.1, 0.0}, .hit_radius_m = 0.02, .lagging_length = lagging});
    springs_ = compile_springs(skeleton_, setup).value();
    state_.resize(springs_.state_bytes() / 8);
    scratch_.resize(springs_.scratch_bytes() / 8);
    for (std::size_t j = 0; j < skeleton_.joint_count(); ++j) pose_.span().set(j, skeleton_.rest[j]);
  }

  std::size_t joint_count() const { return springs_.joint_count(); }

  /// One frame of 1/60 s; the root moves to and fro, or stays.
  void frame(bool moves) {
    Affined root;
    if (moves) root.row[0].w = 0.01 * static_cast<double>(++count_ % 64);
    run_unchecked({.springs = &springs_,
                   .skeleton = &skeleton_,
                   .pose = pose_.span(),
                   .root = root,
                   .dt_s = 1.0 / 60.0,
                   .state = std::as_writable_bytes(std::span(state_)),
                   .scratch = std::as_writable_bytes(std::span(scratch_))});
  }

 private:
  static Skeleton make_skeleton() {
    std::vector<std::uint32_t> parents{kNone};
    for (std::uint32_t j = 0; j < kChains * (kLong + 1); ++j) parents.push_back(j < kChains ? 0 : j - kChains + 1);
    Skeleton skeleton = test::skeleton_of(std::move(parents));
    for (std::uint32_t j = 1; j < skeleton.joint_count(); ++j) {
      const float around = 0.2f * static_cast<float>(j);
      skeleton.rest[j].translation = j <= kChains ? glm::vec3(0.1f * std::cos(around), 0.1f, 0.1f * std::sin(around))
                                                  : glm::vec3(0.0f, -0.1f, 0.0f);
    }
    return skeleton;
  }

  Skeleton skeleton_;
  Springs springs_;
  test::PoseBuffer pose_;
  std::vector<std::uint64_t> state_, scratch_;
  std::uint32_t count_ = 0;
};

void add_hair(const std::string& name, bool collides, bool lagging, bool moves) {
  const auto hair = std::make_shared<Hair>(collides, lagging);
  if (!moves)
    for (int frame = 0; frame < 2000; ++frame) hair->frame(false);  // until it sleeps
  add("springs/sinew/" + name, hair->joint_count(), [hair, moves] { hair->frame(moves); });
}

}  // namespace

void add_springs() {
  add_hair("free", false, false, true);
  add_hair("vrm", false, true, true);
  add_hair("two_spheres", true, false, true);
  add_hair("asleep", true, false, false);
}

}  // namespace sinew::bench
