// SPDX-License-Identifier: MIT
#include "runtime/plan/check_needs.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "runtime/plan/compile_plan.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

/// Needs that break one rule of the arm, which has three joints and one instance.
struct BadNeeds {
  std::string field;
  ErrorCode error;
  std::function<void(Needs&)> change;
};

std::vector<BadNeeds> bad_needs() {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto mask = [](std::vector<float> weights) { return [=](Needs& needs) { needs.in.masks = {weights}; }; };
  const auto room = [](std::uint32_t PoseProgramRoom::*member, std::uint32_t count) {
    return [=](Needs& needs) { needs.in.program.*member = count; };
  };
  const auto cached = [](std::vector<std::uint32_t> named) {
    return [=](Needs& needs) { needs.in.cached_instances = named; };
  };
  return {
      {"in.max_layers", ErrorCode::unsupported, [](Needs& needs) { needs.in.max_layers = 0; }},
      {"in.masks", ErrorCode::size_mismatch, mask({1.0f, 1.0f})},
      {"in.masks", ErrorCode::not_finite, mask({1.0f, 1.0f, kNan})},
      {"in.masks", ErrorCode::not_finite, mask({-0.5f, 1.0f, 1.0f})},
      {"in.masks", ErrorCode::unsupported,
       [](Needs& needs) { needs.in.masks.assign(256, std::vector<float>(3, 1.0f)); }},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::ops, 256)},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::slots, 1)},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::masks, 256)},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::externals, 65536)},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::overrides, 65536)},
      {"in.program", ErrorCode::unsupported, room(&PoseProgramRoom::procedures, 65536)},
      {"in.cached_instances", ErrorCode::index_out_of_range, cached({1})},
      {"in.cached_instances", ErrorCode::index_out_of_range, cached({0, 0})},
      {"in.mirror", ErrorCode::size_mismatch,
       [](Needs& needs) { needs.in.mirror = std::make_shared<const MirrorMap>(); }},
      {"out.skeleton_lod", ErrorCode::size_mismatch, [](Needs& needs) { needs.out.skeleton_lod.kept.assign(2, true); }},
      {"out.skeleton_lod", ErrorCode::size_mismatch,
       [](Needs& needs) { needs.out.skeleton_lod.held.assign(4, Transform{}); }},
      {"skin.per_instance", ErrorCode::size_mismatch,
       [](Needs& needs) { needs.skin.per_instance.assign(2, Skinning::linear); }}};
}

TEST(check_needs, names_the_member_that_breaks_a_rule) {
  const Scene scene = arm_scene();
  EXPECT_EQ(find_fault({}, scene).error, ErrorCode::ok);
  for (const BadNeeds& bad : bad_needs()) {
    Needs needs;
    bad.change(needs);
    const Refusal fault = find_fault(needs, scene);
    EXPECT_EQ(fault.error, bad.error) << bad.field;
    ASSERT_NE(fault.field, nullptr) << bad.field;
    EXPECT_EQ(fault.field, bad.field);
    EXPECT_DEATH(compile_plan(lend(scene), needs), "contract broken: .*" + bad.field);
  }
}

TEST(check_needs, accepts_the_largest_that_a_scene_can_have) {
  const Scene scene = arm_scene();
  Needs needs;
  needs.in.masks.assign(255, std::vector<float>(3, 0.0f));
  needs.in.program = {.ops = 255,
                      .slots = 255,
                      .externals = 65535,
                      .overrides = 65535,
                      .masks = 255,
                      .procedures = 65535,
                      .overridden_joints = 1,
                      .overlays_in_model_space = true};
  needs.in.cached_instances = {0};
  needs.skin.per_instance = {Skinning::dual_quaternion};
  needs.out.skeleton_lod = {.kept = {true, true, false}, .held = std::vector<Transform>(3)};
  EXPECT_EQ(find_fault(needs, scene).error, ErrorCode::ok);
}

}  // namespace
}  // namespace sinew::test
