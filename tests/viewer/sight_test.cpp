// SPDX-License-Identifier: MIT
#include "viewer/app/sight.h"

#include <algorithm>

#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

class sight_on_device : public DeviceTest {};

Needs viewer_needs() {
  Needs needs;
  needs.bounds = true, needs.max_layers = 1;
  return needs;
}

/// Three arms that bend: one at the origin and two far to either side, in the direction of the axis that they bend
/// about.
Scene three_arms() {
  Scene scene = test::arm_scene();
  Skin left = scene.skins[0], right = left;
  for (Affine& m : left.inverse_bind) m.row[2].w -= 40.0f;
  for (Affine& m : right.inverse_bind) m.row[2].w += 40.0f;
  scene.skins.push_back(left), scene.skins.push_back(right);
  for (const std::uint32_t skin : {1u, 2u}) {
    MeshInstance instance = scene.instances[0];
    instance.skin = skin;
    scene.instances.push_back(instance);
  }
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

View view_of_one() { return look_at({5.0, 1.0, 3.0}, {0.0, 1.0, 0.0}, 0.8, 0.05); }
View view_of_none() { return look_at({5.0, 1.0, 3.0}, {60.0, 1.0, 3.0}, 0.8, 0.05); }

TEST(sight, leaves_out_what_the_clip_never_brings_into_view) {
  const Scene scene = three_arms();
  Sight sight(scene, viewer_needs());
  EXPECT_EQ(sight.of(0, view_of_one(), 1.5), (Unseen{{0, 1, 1}, false}));
  EXPECT_EQ(sight.of(0, look_at({0.0, 1.0, 300.0}, {0.0, 1.0, 0.0}, 0.8, 0.05), 1.5), sight.nothing());
  EXPECT_EQ(sight.of(0, view_of_none(), 1.5), (Unseen{{1, 1, 1}, true}));
  EXPECT_EQ(sight.of(kNone, view_of_none(), 1.5), (Unseen{{1, 1, 1}, true}));
}

TEST(sight, of_a_scene_without_meshes_is_all) {
  Scene scene = test::arm_scene();
  scene.instances.clear(), scene.clips.clear();
  finish_scene(scene);
  EXPECT_FALSE(Sight(scene, viewer_needs()).of(0, view_of_none(), 1.5).all);
}

TEST(sight, what_comes_into_view_is_told_from_what_leaves_it) {
  const Unseen one{{0, 1, 1}, false}, other{{1, 0, 1}, false}, none{{0, 0, 0}, false};
  EXPECT_TRUE(one.hides_more_than(other));
  EXPECT_TRUE(one.hides_more_than(none));
  EXPECT_FALSE(none.hides_more_than(one));
  EXPECT_FALSE(one.hides_more_than(one));
}

TEST(sight, a_character_sleeps_only_while_nobody_watches_its_joints) {
  const Unseen all{{1}, true}, some{{1, 0}, false};
  FrameInput input;
  leave_out(all, false, input);
  EXPECT_TRUE(input.asleep);
  leave_out(all, true, input);
  EXPECT_FALSE(input.asleep);
  EXPECT_EQ(input.out_of_view.size(), 1u);
  leave_out(some, false, input);
  EXPECT_FALSE(input.asleep);
}

TEST_F(sight_on_device, pictures_have_the_same_bytes_and_cost_less) {
  const Scene scene = three_arms();
  const Plan plan = compile_plan(scene, viewer_needs());
  Sight sight(scene, plan.needs());
  FrameBuffer whole(plan), seen(plan);
  Headless renderer(*test_device(), scene, 96, 64);
  for (const View& view : {view_of_one(), look_at({1.0, 1.0, 90.0}, {0.0, 1.0, 0.0}, 0.8, 0.05), view_of_none()})
    for (const double time_s : {0.0, 0.3, 0.9}) {
      const ClipLayer layer{0, time_s};
      FrameInput input;
      input.layers = {&layer, 1};
      ASSERT_EQ(run_plan(plan, input, whole), ErrorCode::ok);
      const Unseen unseen = sight.of(0, view, 1.5);
      leave_out(unseen, false, input);
      ASSERT_EQ(run_plan(plan, input, seen), ErrorCode::ok);
      const Picture expected = renderer.render(whole.result(), view, {});
      const std::uint32_t out_of_view = renderer.report().out_of_view;
      EXPECT_EQ(renderer.render(seen.result(), view, {}).rgba, expected.rgba);
      EXPECT_EQ(renderer.report().out_of_view, out_of_view);
      EXPECT_EQ(renderer.report().hidden, 0u);
      const auto in_view =
          static_cast<std::uint64_t>(std::count(unseen.out_of_view.begin(), unseen.out_of_view.end(), 0));
      EXPECT_EQ(seen.result().work.vertices_skinned_linear, 4 * in_view);
      EXPECT_EQ(seen.result().work == WorkCounters{}, unseen.all);
    }
}

}  // namespace
}  // namespace sinew::viewer
