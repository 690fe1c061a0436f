// SPDX-License-Identifier: MIT
#include "viewer/app/update_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {
namespace {

View seen_from(double distance_m) { return look_at({0.0, 1.0, distance_m}, {0.0, 1.0, 0.0}, 0.8, 0.05); }

Plan plan_for(const Scene& scene, Updates updates) {
  Needs needs;
  needs.out.bounds = true;
  needs.in.max_layers = 1;
  needs.in.between_updates = updates == Updates::interpolated;
  return compile_plan(lend(scene), needs);
}

/// Plays 24 frames of a character that is seen from a distance.
struct Watched {
  Watched(const Scene& scene, Updates updates) : plan(plan_for(scene, updates)), frame(plan), levels(plan, updates) {}

  const FrameResult& show(std::uint64_t number, const View& view, bool exactly = false) {
    if (number == 0 || exactly)
      levels.begin_exact_frame("a test");
    else
      levels.begin_frame(size_in_picture(frame.result(), view), 0.01);
    const ClipLayer layer{0, 0.01 * static_cast<double>(number)},
        ahead{0, 0.01 * static_cast<double>(number + levels.frames_to_update())};
    FrameInput now;
    now.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan, levels.input(now, {&ahead, 1}), frame), ErrorCode::ok);
    return frame.result();
  }

  Plan plan;
  FrameBuffer frame;
  UpdateLevels levels;
};

TEST(update_levels, a_mesh_is_as_large_as_the_ball_around_its_box) {
  const Scene scene = test::arm_scene();
  const Plan plan = plan_for(scene, Updates::every);
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  const double radius_m = 0.5 * std::sqrt(0.25 + 4.0);
  EXPECT_NEAR(size_in_picture(frame.result(), seen_from(10.0)), radius_m / (10.0 * std::tan(0.4)), 1e-6);
  EXPECT_EQ(size_in_picture(frame.result(), seen_from(0.5)), INFINITY);
  View flat = seen_from(10.0);
  flat.half_height_m = 5.0;
  EXPECT_NEAR(size_in_picture(frame.result(), flat), radius_m / 5.0, 1e-6);
  EXPECT_EQ(size_in_picture(FrameResult{}, flat), 0.0);
  InstanceResult unseen = frame.result().instances[0];
  unseen.visible = false;
  FrameResult other = frame.result();
  other.instances = {&unseen, 1};
  EXPECT_EQ(size_in_picture(other, flat), 0.0) << "what is not shown has no size";
}

TEST(update_levels, P19_small_characters_are_sampled_at_the_share_of_their_level) {
  const Scene scene = test::arm_scene();
  for (const Updates updates : {Updates::every, Updates::interpolated, Updates::held})
    for (const double distance_m : {5.0, 20.0, 100.0}) {
      Watched watched(scene, updates);
      std::uint64_t sampled = 0, skinned = 0;
      for (std::uint64_t number = 0; number < 48; ++number) {
        const WorkCounters& work = watched.show(number, seen_from(distance_m)).work;
        sampled += work.tracks_sampled;
        skinned += work.vertices_skinned_linear > 0;
      }
      const std::uint64_t period = updates == Updates::every || distance_m < 10.0 ? 1 : distance_m < 50.0 ? 2 : 4;
      EXPECT_NEAR(static_cast<double>(sampled), 48.0 / static_cast<double>(period), 2.0)
          << name_of(updates) << " at " << distance_m;
      EXPECT_NEAR(static_cast<double>(skinned), updates == Updates::held ? 48.0 / static_cast<double>(period) : 48.0,
                  2.0);
    }
}

TEST(update_levels, an_exact_frame_shows_what_is_asked_for) {
  const Scene scene = test::arm_scene();
  for (const Updates updates : {Updates::interpolated, Updates::held}) {
    Watched watched(scene, updates), exact(scene, Updates::every);
    for (std::uint64_t number = 0; number < 20; ++number) {
      const bool exactly = number == 6 || number == 13;
      const auto shown = watched.show(number, seen_from(100.0), exactly).primitives[0].positions;
      const auto truth = exact.show(number, seen_from(100.0)).primitives[0].positions;
      if (exactly) {
        EXPECT_TRUE(std::equal(shown.begin(), shown.end(), truth.begin(), truth.end())) << number;
      }
    }
  }
}

TEST(update_levels, say_what_they_are_and_why) {
  const Scene scene = test::arm_scene();
  const auto reason = [&](Updates updates, double size) {
    UpdateLevels levels(plan_for(scene, updates), updates);
    levels.begin_frame(size, 0.01);
    return levels.reason();
  };
  EXPECT_EQ(reason(Updates::every, 0.03), "every frame, as asked");
  EXPECT_EQ(reason(Updates::interpolated, 0.031),
            "every 4th frame, interpolated in between: 3.1 % of the picture's height");
  EXPECT_EQ(reason(Updates::held, 0.15), "every 2nd frame, held in between: 15 % of the picture's height");
  EXPECT_EQ(reason(Updates::held, 0.5), "every frame: 50 % of the picture's height");
  EXPECT_EQ(reason(Updates::held, 3.0), "every frame: meshes fill the picture's height");
  EXPECT_EQ(reason(Updates::interpolated, 0.0), "every 4th frame, interpolated in between: no mesh is in view");
  UpdateLevels levels(plan_for(scene, Updates::held), Updates::held);
  levels.begin_frame(0.03, 0.04);
  EXPECT_EQ(levels.reason(), "every 2nd frame, held in between: 3 % of the picture's height");
  levels.begin_frame(0.03, 0.2);
  EXPECT_EQ(levels.reason(), "every frame: pictures are too far apart to leave any out");
  levels.begin_frame(0.08, 0.01);
  EXPECT_EQ(levels.level(), UpdateLevel::every_fourth) << "slow pictures did not make it a larger one";
  levels.begin_exact_frame("the time stands still");
  EXPECT_EQ(levels.reason(), "every frame: the time stands still");
}

TEST(update_levels, the_plan_knows_frames_between_updates_only_where_they_are_interpolated) {
  for (const Updates updates : {Updates::every, Updates::interpolated, Updates::held})
    EXPECT_EQ(plan_for(test::arm_scene(), updates).runs(Stage::interpolate), updates == Updates::interpolated);
}

}  // namespace
}  // namespace sinew::viewer
