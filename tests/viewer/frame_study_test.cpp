// SPDX-License-Identifier: MIT
#include "viewer/study/frame_study.h"

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

class frame_study : public DeviceTest {};

constexpr FrameEffort kSmall{.width = 64, .height = 36, .repetitions = 2};

TEST_F(frame_study, draws_as_often_as_it_says_both_ways) {
  for (const std::uint32_t draws : {19u, 115u}) {
    const DrawTrial trial = study_draws(*test_device(), draws, kSmall);
    EXPECT_EQ(trial.draws, draws) << "all are in view";
    EXPECT_EQ(trial.without.opaque_ms.size(), 2u) << "the first picture does not count";
    EXPECT_EQ(trial.with.opaque_ms.size(), 2u);
  }
}

TEST_F(frame_study, takes_whole_frames_of_a_doll_and_of_a_hundred_thousand_triangles) {
  const std::vector<FrameTrial> trials = study_built_in_frames(*test_device(), kSmall);
  ASSERT_EQ(trials.size(), 2u);
  EXPECT_EQ(trials[0].draws, 19u);
  EXPECT_EQ(trials[0].triangles, 43776u);
  EXPECT_EQ(trials[1].draws, 1u);
  EXPECT_EQ(trials[1].triangles, 100352u);
  for (const FrameTrial& trial : trials)
    for (const PictureTimes* times : {&trial.base, &trial.full}) {
      ASSERT_EQ(times->all_ms.size(), 2u);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(times->all_ms[i], times->opaque_ms[i]) << "of all passes";
    }
}

}  // namespace
}  // namespace sinew::viewer
