// SPDX-License-Identifier: MIT
// Weighted means of layers. ozz takes weights below 0 as 0, which sinew refuses: such cases run with 0.
#include "tests/ozz_numbers/soa_pose.h"

namespace sinew::ozz {
namespace {

constexpr Axes kOnes{{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};

std::vector<SoaPose> moved(std::initializer_list<Axes> translations) {
  std::vector<SoaPose> poses;
  for (const Axes& translation : translations) poses.push_back({.translation = translation});
  return poses;
}

/// Runs a blend that sinew must refuse because of a weight below 0.
void expect_refused(const SoaBlend& blend) {
  std::vector<SoaPose> unused;
  EXPECT_EQ(run(blend, unused), ErrorCode::negative_weight);
}

}  // namespace

Tally blend_weights_group() {
  SoaBlend blend;
  blend.layers = {{moved({rising(0), rising(12)})}, {moved({rising(-0.0f, -1), rising(-12, -1)})}};
  blend.rest = {{.scale = rising(0)}, {.scale = rising(0, 2)}};
  const struct {
    float first, second;
    SoaNumbers expected;
  } cases[] = {{0, 1, {{rising(0, -1), rising(-12, -1)}, {kOnes, kOnes}, {}}},
               {1, 1e-27f, {{rising(0), rising(12)}, {kOnes, kOnes}, {}}},
               {0.5f, 0.5f, {{Axes{}, Axes{}}, {kOnes, kOnes}, {}}}};
  blend.layers[0].weight = -0.07f;
  expect_refused(blend);
  Tally tally;
  for (const auto& c : cases) {
    blend.layers[0].weight = c.first;
    blend.layers[1].weight = c.second;
    tally += tally_of(blend, c.expected);
  }
  return tally;
}

Tally blend_joint_weights_group() {
  SoaBlend blend;
  blend.layers = {{moved({rising(0), rising(12)}), 1, {1, 1, 0, 0, 1, 0, 1, 1}},
                  {moved({rising(0, -1), rising(-12, -1)}), 1, {1, 1, 1, 0, 0, 1, 1, 1}}};
  blend.rest = {{.translation = rising(10), .scale = rising(0)}, {.scale = rising(0, 2)}};
  blend.layers[0].weight = blend.layers[1].weight = 0.5f;
  Tally tally = tally_of(blend, {{{{{0, 0, -2, 13}, {0, 0, -6, 17}, {0, 0, -10, 21}}},
                                  {{{12, -13, 0, 0}, {16, -17, 0, 0}, {20, -21, 0, 0}}}},
                                 {{{{1, 1, 1, 3}, {1, 1, 1, 7}, {1, 1, 1, 11}}}, kOnes},
                                 {}});
  blend.layers[0].weight = 0.0f;
  blend.layers[1].weight = 1.0f;
  tally +=
      tally_of(blend, {{{{{0, -1, -2, 13}, {-4, -5, -6, 17}, {-8, -9, -10, 21}}},
                        {{{0, -13, -14, -15}, {0, -17, -18, -19}, {0, -21, -22, -23}}}},
                       {{{{1, 1, 1, 3}, {1, 1, 1, 7}, {1, 1, 1, 11}}}, {{{0, 1, 1, 1}, {8, 1, 1, 1}, {16, 1, 1, 1}}}},
                       {}});
  return tally;
}

Tally blend_normalised_group() {
  const float h = 0.70710677f;
  SoaPose first, second;
  first.rotation = {{{h, 0, 0, 0.382683432f}, {0, 0, h, 0}, {}, {h, 1, h, 0.9238795f}}};
  second.rotation = {{{0, h, -h, -0.382683432f}, {}, {0, 0, -h, 0}, {1, h, 0, -0.9238795f}}};
  const std::array<Four, 4> mean{{{0.30507791f, 0.45761687f, -0.58843851f, 0.38268352f},
                                  {0, 0, 0.39229235f, 0},
                                  {0, 0, -0.58843851f, 0},
                                  {0.95224595f, 0.88906217f, 0.39229235f, 0.92387962f}}};
  SoaBlend blend;
  blend.rest = {{.scale = rising(0)}};
  first.translation = rising(2);
  second.translation = rising(3);
  blend.layers = {{{first}, 0.2f}, {{second}, 0.3f}};
  Tally tally = tally_of(blend, {{rising(2.6f)}, {kOnes}, {mean}});

  first.translation = rising(5, 5);
  second.translation = rising(10, 5);
  blend.layers = {{{first}, 2}, {{second}, 3}};
  tally += tally_of(blend, {{rising(8, 5)}, {kOnes}, {mean}});

  blend.layers[1].joint_weights = {1, -1, 2, 0.1f};
  expect_refused(blend);
  blend.layers[1].joint_weights[1] = 0;
  tally += tally_of(
      blend,
      {{{{{8, 10, 150.0f / 8, 47.5f / 2.3f}, {28, 30, 310.0f / 8, 93.5f / 2.3f}, {48, 50, 470.0f / 8, 139.5f / 2.3f}}}},
       {kOnes},
       {}});
  return tally;
}

Tally blend_threshold_group() {
  SoaBlend blend;
  blend.rest = {{.scale = rising(0)}};
  blend.layers = {{moved({rising(2)}), 0.04f}, {moved({rising(3)}), 0.06f}};
  Tally tally = tally_of(blend, {{rising(2.6f)}, {kOnes}, {SoaPose{}.rotation}});
  blend.layers[0].weight = 1e-27f;
  blend.layers[1].weight = 0.0f;
  tally += tally_of(blend, {{Axes{}}, {rising(0)}, {SoaPose{}.rotation}});
  return tally;
}

}  // namespace sinew::ozz
