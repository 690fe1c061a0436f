// SPDX-License-Identifier: MIT
#include "tests/study/frame_study.h"

#include <gmock/gmock.h>

#include <utility>

#include "tests/viewer/device_fixture.h"
#include "tests/study/study_scenes.h"

namespace sinew::viewer {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

class frame_study : public DeviceTest {};

constexpr FrameEffort kSmall{.width = 64, .height = 36, .repetitions = 2};

TEST_F(frame_study, draws_as_often_as_it_says_both_ways) {
  for (const std::uint32_t draws : {19u, 115u}) {
    const DrawTrial trial = study_draws(*test_device(), draws, kSmall);
    EXPECT_EQ(trial.draws, draws) << "all are in view";
    EXPECT_EQ(trial.without.opaque_ms.size(), 2u) << "the first picture does not count";
    EXPECT_EQ(trial.with.opaque_ms.size(), 2u);
    EXPECT_THAT(trial.with.ran, Contains(name_of(Pass::ssao)));
    EXPECT_THAT(trial.without.ran, Not(Contains(name_of(Pass::ssao))));
  }
}

TEST_F(frame_study, takes_whole_frames_of_a_doll_and_of_a_hundred_thousand_triangles) {
  const std::vector<FrameTrial> trials = study_built_in_frames(*test_device(), kSmall);
  ASSERT_EQ(trials.size(), 2u);
  EXPECT_EQ(trials[0].draws, 19u);
  EXPECT_EQ(trials[0].triangles, 43776u);
  EXPECT_EQ(trials[1].draws, 1u);
  EXPECT_EQ(trials[1].triangles, 100352u);
  for (const FrameTrial& trial : trials) {
    EXPECT_THAT(trial.base.ran, AllOf(Contains(name_of(Pass::ssao)), Not(Contains(name_of(Pass::shadow)))));
    EXPECT_THAT(trial.full.ran, AllOf(Contains(name_of(Pass::ssao)), Contains(name_of(Pass::shadow))));
    for (const PictureTimes* times : {&trial.base, &trial.full}) {
      ASSERT_EQ(times->all_ms.size(), 2u);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(times->all_ms[i], times->opaque_ms[i]) << "of all passes";
    }
  }
}

TEST_F(frame_study, counts_triangles_and_no_lines) {
  Scene scene = sheet_of_balls(2);
  scene.meshes[scene.instances[1].mesh].primitives[0].topology = Topology::lines;
  const Still still(std::move(scene));
  const FrameTrial trial =
      study_frame(*test_device(), "a ball and lines", still.scene, still.buffer.result(), still.bounds, kSmall);
  EXPECT_EQ(trial.triangles, 256u);
  EXPECT_EQ(trial.draws, 2u);
  EXPECT_EQ(trial.name, "a ball and lines");
}

TEST(frame_looks, are_those_that_the_study_says) {
  ClipExtent bounds;
  bounds.reached = {{-3, -1, -1}, {3, 1, 1}};
  bounds.largest = {{-1, -1, -1}, {1, 1, 1}};
  const RenderOptions base = base_look(bounds), full = full_look(bounds);
  for (const RenderOptions& look : {base, full}) {
    EXPECT_TRUE(look.ao.on);
    EXPECT_EQ(look.ao.radius_m, ambient_occlusion_for(bounds.largest).radius_m);
    EXPECT_EQ(look.ground.look, GroundLook::none);
  }
  EXPECT_FALSE(base.shadows.on || base.smooth_edges);
  EXPECT_EQ(base.lighting.environment, RenderOptions{}.lighting.environment) << "the gradient";
  EXPECT_TRUE(full.shadows.on && full.smooth_edges);
  EXPECT_EQ(full.shadows.bounds.upper, bounds.reached.upper);
  EXPECT_EQ(full.lighting.environment, studio_environment());
  EXPECT_EQ(full.backdrop, Backdrop::blurred);
}

TEST(picture_times, are_those_of_all_passes_and_of_the_opaque_one) {
  PictureTimes times;
  times.add({});
  EXPECT_TRUE(times.all_ms.empty()) << "without timestamps there are none";
  const std::vector<PassTime> first = {{name_of(Pass::shadow), 1.0}, {name_of(Pass::opaque), 2.0}, {"other", 4.0}};
  times.add(first);
  times.add(std::span(first).first(2));
  EXPECT_THAT(times.all_ms, ElementsAre(7.0, 3.0));
  EXPECT_THAT(times.opaque_ms, ElementsAre(2.0, 2.0));
  EXPECT_THAT(times.ran, ElementsAre(name_of(Pass::shadow), name_of(Pass::opaque)));
}

}  // namespace
}  // namespace sinew::viewer
