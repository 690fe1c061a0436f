// SPDX-License-Identifier: MIT
// Additive layers in the joint's frame, over the rest pose. A weight below 0 subtracts, in ozz as in sinew.
#include "tests/ozz_numbers/soa_pose.h"

namespace sinew::ozz {
namespace {

constexpr float kH = 0.70710677f;

Axes times(Axes axes, float by) {
  for (Four& four : axes)
    for (float& number : four) number *= by;
  return axes;
}

Axes squares(float first) {
  Axes axes = rising(first);
  for (Four& four : axes)
    for (float& number : four) number *= number;
  return axes;
}

Axes cubes(float first) {
  Axes axes = rising(first);
  for (Four& four : axes)
    for (float& number : four) number *= number * number;
  return axes;
}

SoaPose added_pose() {
  return {rising(0), {{{kH, 0, 0, 0.382683432f}, {0, 0, kH, 0}, {}, {kH, 1, -kH, 0.9238795f}}}, rising(12)};
}

SoaPose opposite_pose() {
  SoaPose pose = added_pose();
  pose.translation = times(pose.translation, -1);
  pose.scale = times(pose.scale, -1);
  for (std::size_t c = 0; c < 3; ++c)
    for (float& number : pose.rotation[c]) number = -number;
  return pose;
}

}  // namespace

Tally additive_group() {
  const SoaPose rest{times(rising(0), -1),
                     {{{0, 0, kH, 0}, {kH, 0, 0, 0.382683432f}, {kH, 1, -kH, 0.9238795f}, {}}},
                     times(rising(12), -1)};
  const SoaNumbers of_rest{{rest.translation}, {rest.scale}, {rest.rotation}};
  const std::array<Four, 4> half{
      {{0, 0, 0.3826834f, 0}, {0.9238795f, 0, 0, 0.555570245f}, {0.3826834f, 1, -0.9238795f, 0.831469595f}, {}}};
  const Axes half_scale{{{-78, -91, -105, -120}, {-136, -153, -171, -190}, {-210, -231, -253, -276}}};
  SoaBlend blend;
  blend.rest = {rest};
  blend.additive = {{{added_pose()}}};
  const struct {
    float weight;
    SoaNumbers expected;
  } cases[] = {{0.0f, of_rest},
               {0.5f, {{times(rising(0), -0.5f)}, {half_scale}, {half}}},
               {1.0f, {{Axes{}}, {times(squares(12), -1)}, {{{{}, {1, 0, 0, kH}, {0, 1, -1, kH}, {}}}}}}};
  Tally tally;
  for (const auto& c : cases) {
    blend.additive[0].weight = c.weight;
    tally += tally_of(blend, c.expected);
  }
  blend.additive = {{{added_pose()}, 0.0f}, {{opposite_pose()}, 1.0f}};
  tally += tally_of(blend, {{times(rising(0), -2)}, {squares(12)}, {{{{0, 0, 1, 0}, {}, {1, 1, 0, 1}, {}}}}});
  blend.additive[0].weight = 1.0f;
  tally += tally_of(blend, {{rest.translation}, {cubes(12)}, {rest.rotation}});
  blend.additive = {{{added_pose()}, 0.5f}, {{added_pose()}, -0.5f}};
  tally += tally_of(blend, of_rest);
  return tally;
}

Tally additive_joint_weights_group() {
  SoaBlend blend;
  blend.rest = {{}};
  blend.additive = {{{added_pose()}, 1.0f, {1, 0.5f, 0, -1}}};
  std::vector<SoaPose> unused;
  EXPECT_EQ(run(blend, unused), ErrorCode::negative_weight) << "ozz takes joint weights below 0 as 0";
  blend.additive[0].joint_weights[3] = 0;
  const auto turned = [](float x, float w) { return std::array<Four, 4>{{{x}, {}, {}, {w, 1, 1, 1}}}; };
  const struct {
    float weight;
    SoaNumbers expected;
  } cases[] = {{0.0f, {{Axes{}}, {SoaPose{}.scale}, {SoaPose{}.rotation}}},
               {0.5f,
                {{{{{0, 0.25f, 0, 0}, {2, 1.25f, 0, 0}, {4, 2.25f, 0, 0}}}},
                 {{{{6.5f, 4, 1, 1}, {8.5f, 5, 1, 1}, {10.5f, 6, 1, 1}}}},
                 {turned(0.3826834f, 0.9238795f)}}},
               {1.0f,
                {{{{{0, 0.5f, 0, 0}, {4, 2.5f, 0, 0}, {8, 4.5f, 0, 0}}}},
                 {{{{12, 7, 1, 1}, {16, 9, 1, 1}, {20, 11, 1, 1}}}},
                 {turned(kH, kH)}}},
               {-1.0f,
                {{{{{0, -0.5f, 0, 0}, {-4, -2.5f, 0, 0}, {-8, -4.5f, 0, 0}}}},
                 {{{{1.0f / 12, 1.0f / 7, 1, 1}, {1.0f / 16, 1.0f / 9, 1, 1}, {1.0f / 20, 1.0f / 11, 1, 1}}}},
                 {turned(-kH, kH)}}}};
  Tally tally;
  for (const auto& c : cases) {
    blend.additive[0].weight = c.weight;
    tally += tally_of(blend, c.expected);
  }
  return tally;
}

}  // namespace sinew::ozz
