// SPDX-License-Identifier: MIT
#include "viewer/app/camera/frustum_culling.h"

#include <algorithm>

#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/viewer/device_fixture.h"
#include "tests/viewer/flyer.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

class frustum_culling_on_device : public DeviceTest {};

Needs viewer_needs() {
  Needs needs;
  needs.out.bounds = true;
  needs.in.max_layers = 1;
  return needs;
}

/// Three arms that bend about z: one at the origin, the others 40 m to both sides along z.
Scene three_arms() {
  Scene scene = test::arm_scene();
  Skin left = scene.skins[0], right = left;
  for (Affine& m : left.inverse_bind) m.row[2].w -= 40.0f;
  for (Affine& m : right.inverse_bind) m.row[2].w += 40.0f;
  scene.skins.push_back(left);
  scene.skins.push_back(right);
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

TEST(frustum_culling, leaves_out_what_the_clip_never_brings_into_view) {
  const Scene scene = three_arms();
  FrustumCulling culling(scene, viewer_needs());
  EXPECT_EQ(culling.of(0, view_of_one(), 1.5), (CulledInstances{{0, 1, 1}, false}));
  EXPECT_EQ(culling.of(0, look_at({0.0, 1.0, 300.0}, {0.0, 1.0, 0.0}, 0.8, 0.05), 1.5), culling.all_in_view());
  EXPECT_EQ(culling.of(0, view_of_none(), 1.5), (CulledInstances{{1, 1, 1}, true}));
  EXPECT_EQ(culling.of(kNone, view_of_none(), 1.5), (CulledInstances{{1, 1, 1}, true}));
}

TEST(frustum_culling, each_clip_and_the_rest_pose_reach_as_far_as_they_do) {
  Scene scene = flyer(true);  // its rest pose is 3 m above its first clip
  scene.animations.push_back(scene.animations[0]);
  for (glm::vec3& place : scene.animations[1].bones[0].translation.values) place = {0.0f, 6.0f, 0.0f};
  scene.clips.clear();
  finish_scene(scene);
  FrustumCulling culling(scene, viewer_needs());
  const std::uint32_t clips[] = {0, 1, kNone};
  const double heights_m[] = {0.5, 6.5, 3.5};
  for (const std::size_t seen : {2u, 0u, 1u})
    for (const std::size_t played : {0u, 2u, 1u}) {
      const View view = look_at({0.5, heights_m[seen], 4.0}, {0.5, heights_m[seen], 0.0}, 0.4, 0.05);
      EXPECT_EQ(culling.of(clips[played], view, 1.5).every_instance, seen != played) << seen << played;
    }
}

TEST(frustum_culling, keeps_what_casts_a_shadow_into_view) {
  const Scene scene = three_arms();
  FrustumCulling culling(scene, viewer_needs());
  EXPECT_EQ(culling.of(0, view_of_one(), 1.5, glm::vec3(0.0f, 0.0f, 60.0f)).out_of_view,
            (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_EQ(culling.of(0, view_of_one(), 1.5, glm::vec3(0.0f, 0.0f, -60.0f)).out_of_view,
            (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(culling.of(0, view_of_one(), 1.5, glm::vec3(0.0f, 0.0f, 10.0f)).out_of_view,
            (std::vector<std::uint8_t>{0, 1, 1}));
}

TEST(frustum_culling, shadows_fall_away_from_the_key_light_or_anywhere) {
  Scene scene = three_arms();
  const Aabb reached{glm::vec3(-3.0f, 0.0f, 0.0f), glm::vec3(0.0f, 4.0f, 0.0f)};
  EXPECT_EQ(shadow_sweep(scene, false, reached), glm::vec3(0.0f));
  EXPECT_EQ(shadow_sweep(scene, true, {}), glm::vec3(0.0f));
  const auto way = shadow_sweep(scene, true, reached);
  ASSERT_TRUE(way);
  EXPECT_NEAR(-way->y, 5.0f, 1e-5f) << "from the highest point to the ground";
  EXPECT_NEAR(glm::dot(glm::normalize(*way), glm::normalize(Lighting{}.to_key)), -1.0f, 1e-6f);
  Environment room;
  room.key = KeyLight{{3.0f, 4.0f, 0.0f}, glm::vec3(1.0f)};
  EXPECT_LT(glm::length(*shadow_sweep(scene, true, reached, &room) - glm::vec3(-3.75f, -5.0f, 0.0f)), 1e-5f);
  room.key->irradiance = glm::vec3(0.0f);
  EXPECT_EQ(shadow_sweep(scene, true, reached, &room), glm::vec3(0.0f)) << "an overcast sky has no key light";
  scene.lights.push_back({.kind = Light::Kind::point});
  EXPECT_EQ(shadow_sweep(scene, true, reached), glm::vec3(0.0f)) << "a point light casts none";
  scene.lights.push_back({.kind = Light::Kind::spot});
  EXPECT_FALSE(shadow_sweep(scene, true, reached)) << "a spot light does";
  scene.lights.back().kind = Light::Kind::directional;
  EXPECT_FALSE(shadow_sweep(scene, true, reached)) << "the pose tells where from it shines";
  FrustumCulling culling(scene, viewer_needs());
  EXPECT_EQ(culling.of(0, view_of_none(), 1.5, std::nullopt), culling.all_in_view());
}

TEST(frustum_culling, a_scene_without_meshes_culls_nothing) {
  Scene scene = test::arm_scene();
  scene.instances.clear();
  scene.clips.clear();
  finish_scene(scene);
  EXPECT_FALSE(FrustumCulling(scene, viewer_needs()).of(0, view_of_none(), 1.5).every_instance);
}

TEST(frustum_culling, what_comes_into_view_is_told_from_what_leaves_it) {
  const CulledInstances one{{0, 1, 1}, false}, other{{1, 0, 1}, false}, none{{0, 0, 0}, false};
  EXPECT_TRUE(one.culls_more_than(other));
  EXPECT_TRUE(one.culls_more_than(none));
  EXPECT_FALSE(none.culls_more_than(one));
  EXPECT_FALSE(one.culls_more_than(one));
}

TEST(frustum_culling, a_character_sleeps_only_while_nobody_watches_its_joints) {
  const CulledInstances all{{1}, true}, some{{1, 0}, false};
  FrameInput input;
  apply_culling(all, false, input);
  EXPECT_TRUE(input.asleep);
  apply_culling(all, true, input);
  EXPECT_FALSE(input.asleep);
  EXPECT_EQ(input.out_of_view.size(), 1u);
  apply_culling(some, false, input);
  EXPECT_FALSE(input.asleep);
}

TEST_F(frustum_culling_on_device, pictures_have_the_same_bytes_and_cost_less) {
  const Scene scene = three_arms();
  const Plan plan = compile_plan(lend(scene), viewer_needs());
  FrustumCulling culling(scene, plan.needs());
  FrameBuffer whole(plan), seen(plan);
  Headless renderer(*test_device(), scene, 96, 64);
  for (const View& view : {view_of_one(), look_at({1.0, 1.0, 90.0}, {0.0, 1.0, 0.0}, 0.8, 0.05), view_of_none()})
    for (const double time_s : {0.0, 0.3, 0.9}) {
      const ClipLayer layer{0, time_s};
      FrameInput input;
      input.layers = {&layer, 1};
      ASSERT_EQ(run_plan(plan, input, whole), ErrorCode::ok);
      const CulledInstances culled = culling.of(0, view, 1.5);
      apply_culling(culled, false, input);
      ASSERT_EQ(run_plan(plan, input, seen), ErrorCode::ok);
      const Picture expected = renderer.render(whole.result(), view, {});
      const std::uint32_t out_of_view = renderer.report().out_of_view;
      EXPECT_EQ(renderer.render(seen.result(), view, {}).rgba, expected.rgba);
      EXPECT_EQ(renderer.report().out_of_view, out_of_view);
      EXPECT_EQ(renderer.report().hidden, 0u);
      const auto in_view =
          static_cast<std::uint64_t>(std::count(culled.out_of_view.begin(), culled.out_of_view.end(), 0));
      EXPECT_EQ(seen.result().work.vertices_skinned_linear, 4 * in_view);
      EXPECT_EQ(seen.result().work == WorkCounters{}, culled.every_instance);
    }
}

}  // namespace
}  // namespace sinew::viewer
