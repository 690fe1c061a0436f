// SPDX-License-Identifier: MIT
// Requests of the window to the job thread: the pose of the current time, with culling, but never without a mesh that
// comes into view.
#include "viewer/app/shown_scene.h"

#include <chrono>
#include <cmath>
#include <thread>

#include <glm/geometric.hpp>

#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/viewer/cache_scene.h"
#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

/// A box that glides 4 m along x in 2 s. `camera` puts a camera on it. `others` is a number of joints without a mesh
/// that move alike.
LoadedScene gliding_box(bool camera, std::uint32_t others = 0) {
  showcase::SceneBuilder builder;
  const std::uint32_t joint = builder.add_joint("box", kNone, {});
  builder.add_instance(joint, builder.add_mesh({"box", {showcase::box({0, 0, 0}, glm::vec3(0.5f))}, {}, {}}));
  BoneAnimation bone;
  bone.joint = joint;
  bone.translation.times_s = {0.0f, 2.0f};
  bone.translation.values = {{0, 0, 0}, {4, 0, 0}};
  std::vector<BoneAnimation> bones = {bone};
  for (std::uint32_t i = 0; i < others; ++i) {
    bone.joint = builder.add_joint("other", kNone, {});
    bones.push_back(bone);
  }
  builder.add_animation({"glide", 2.0, bones, {}});
  LoadedScene loaded;
  loaded.scene = builder.finish();
  if (camera) loaded.scene.cameras = {{.name = "on box", .joint = joint}};
  return loaded;
}

const View kAhead = look_at({2.0, 1.0, 9.0}, {2.0, 0.0, 0.0}, 0.8, 0.05),
           kAway = look_at({2.0, 1.0, 9.0}, {2.0, 0.0, 40.0}, 0.8, 0.05),
           kFar = look_at({2.0, 0.0, 900.0}, {2.0, 0.0, 0.0}, 0.8, 0.05),
           kFloor = look_at({-2.0, -3.0, 6.0}, {-2.0, -3.5, -1.8}, 0.3, 0.05);

class shown_scene : public DeviceTest {
 protected:
  void show(LoadedScene loaded, const Evaluation& evaluation = {}) {
    shown_.reset();
    loaded_ = std::move(loaded);
    shown_ = std::make_unique<ShownScene>(*test_device(), loaded_, evaluation, 2, TextureFilter{});
    shown_->playback().pause();
  }
  void TearDown() override {
    shown_.reset();
    DeviceTest::TearDown();
  }
  void submit(const View& view, bool joints_needed = false) { shown_->submit(view, false, 1.5, joints_needed); }
  /// Waits until the newest pose is the last requested one.
  const FrameResult& settled() {
    for (int i = 0; i < 4000; ++i) {
      shown_->newest();
      if (shown_->settled()) return shown_->newest();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ADD_FAILURE() << "the pose does not come";
    return shown_->newest();
  }
  /// Plays a box so far away that it is not evaluated in every frame.
  void play_far_away() {
    show(gliding_box(false), {.updates = Updates::held});
    shown_->playback().toggle();
    for (int i = 0; i < 12; ++i) {
      shown_->playback().advance(0.004);
      submit(kFar);
      shown_->newest();
    }
    ASSERT_NE(shown_->update_levels().level(), UpdateLevel::every);
  }
  /// Position of the box; negative if no joint was evaluated.
  double place_m() {
    const auto& model = shown_->newest().model;
    return model.empty() ? -1.0 : static_cast<double>(model[0].row[0].w);
  }

  LoadedScene loaded_;
  std::unique_ptr<ShownScene> shown_;
};

TEST_F(shown_scene, is_settled_with_the_pose_of_its_time_and_no_other) {
  show(gliding_box(false));
  for (const double time_s : {0.5, 1.5}) {
    shown_->playback().seek(time_s);
    EXPECT_FALSE(shown_->settled()) << "nobody asked for it";
    submit(kAhead);
    settled();
    EXPECT_NEAR(place_m(), 2.0 * time_s, 1e-6);
    EXPECT_TRUE(shown_->resting());
  }
  shown_->playback().toggle();
  EXPECT_FALSE(shown_->resting()) << "it plays";
  shown_->playback().choose(kNone);
  submit(kAhead);
  settled();
  EXPECT_NEAR(place_m(), 0.0, 1e-6) << "the rest pose";
}

TEST_F(shown_scene, the_first_pose_of_another_plan_is_drawn_and_not_the_first_of_the_last_one) {
  show(gliding_box(false));
  const auto drawn_m = [&] {
    return shown_->upload(0, kNone).frame->vertices(0).instances[0].world_from_mesh.row[0].w;
  };
  EXPECT_NEAR(drawn_m(), 0.0f, 1e-6f);
  for (const double time_s : {1.0, 0.5}) {
    shown_->playback().seek(time_s);
    shown_->plan_for({.stage_times = time_s > 0.7});
    EXPECT_NEAR(drawn_m(), static_cast<float>(2.0 * time_s), 1e-6f);
  }
}

TEST_F(shown_scene, leaves_out_what_is_out_of_view_and_waits_for_what_comes_into_it) {
  show(gliding_box(false));
  shown_->playback().seek(0.5);
  submit(kAway);
  EXPECT_FALSE(settled().instances[0].visible);
  shown_->playback().seek(1.0);
  submit(kAhead);
  EXPECT_TRUE(shown_->newest().instances[0].visible) << "in this very frame";
  EXPECT_NEAR(place_m(), 2.0, 1e-6);
}

TEST_F(shown_scene, waits_for_what_comes_into_view_where_the_worker_is_busy_too) {
  show(gliding_box(false, 20'000));
  for (int round = 0; round < 4; ++round) {
    for (const double time_s : {0.1, 0.2, 0.3}) {  // one frame runs, one waits, and there is no room for another
      shown_->playback().seek(time_s);
      submit(kAway, true);
    }
    shown_->playback().seek(1.0);
    submit(kAhead, true);
    EXPECT_TRUE(shown_->newest().instances[0].visible) << "in this very frame";
    EXPECT_NEAR(place_m(), 2.0, 1e-6);
    EXPECT_TRUE(shown_->settled());
  }
}

TEST_F(shown_scene, evaluates_what_casts_a_shadow_into_view) {
  show(gliding_box(false));
  for (const bool shadows : {false, true}) {
    shown_->set_shadows(shadows);
    shown_->playback().seek(shadows ? 0.2 : 0.1);
    submit(kFloor);
    EXPECT_EQ(settled().instances[0].visible, shadows);
  }
}

TEST_F(shown_scene, joints_move_out_of_view_while_somebody_watches_them) {
  for (const bool camera : {false, true})
    for (const bool watched : {false, true}) {
      show(gliding_box(camera));
      submit(kAway, watched);
      settled();
      shown_->playback().seek(1.0);
      submit(kAway, watched);
      settled();
      EXPECT_EQ(std::abs(place_m() - 2.0) < 1e-6, camera || watched) << camera << watched;
    }
}

TEST_F(shown_scene, joints_that_sleep_wake_as_soon_as_somebody_watches_them) {
  show(gliding_box(false));
  shown_->playback().seek(1.0);
  submit(kAway);
  settled();
  EXPECT_NE(place_m(), 2.0) << "nobody watches";
  submit(kAway, true);
  EXPECT_NEAR(place_m(), 2.0, 1e-6) << "in this very frame, though the time stands still";
}

TEST_F(shown_scene, what_is_out_of_view_is_that_of_the_kind_of_skinning_that_is_evaluated) {
  LoadedScene arm;
  arm.scene = test::arm_scene();
  const auto beside = [](double x) { return look_at({x, 1.0, 10.0}, {x, 1.0, 0.0}, 0.1, 0.05); };
  FrustumCulling linear(arm.scene, needs_of(arm, {})),
      other(arm.scene, needs_of(arm, {.skinning = Skinning::dual_quaternion}));
  double x = 0.0;  // where only the other kind may reach
  while (x < 9.0 && linear.of(0, beside(x), 1.5).every_instance == other.of(0, beside(x), 1.5).every_instance) x += 0.1;
  ASSERT_LT(x, 9.0);
  show(std::move(arm));
  for (const Skinning skinning : {Skinning::dual_quaternion, Skinning::linear, Skinning::dual_quaternion}) {
    shown_->plan_for({.skinning = skinning});
    shown_->playback().seek(shown_->playback().time_s() + 0.1);
    submit(beside(x));
    EXPECT_EQ(settled().instances[0].visible, skinning != Skinning::linear);
  }
}

TEST_F(shown_scene, the_coming_view_of_a_camera_is_the_view_of_the_pose_that_comes) {
  show(gliding_box(true));
  EXPECT_TRUE(shown_->is_moved(0));
  shown_->playback().seek(1.0);
  const View coming = shown_->coming_view_of(0, 1.5);
  submit(coming);
  settled();
  EXPECT_EQ(eye_of(shown_->view_of(0, 1.5)), eye_of(coming));
  EXPECT_NEAR(eye_of(coming).x, 2.0, 1e-6);
}

TEST_F(shown_scene, each_camera_has_a_view_of_its_own_as_the_clip_animates_it) {
  LoadedScene loaded = gliding_box(true);
  Scene& scene = loaded.scene;
  scene.cameras.push_back({.name = "wide", .joint = scene.cameras[0].joint, .fov_y_rad = 1.2f});
  WeightTrack zoom;
  zoom.interpolation = Interpolation::linear;
  zoom.target_count = 1;
  zoom.times_s = {0.0f, 2.0f};
  zoom.values = {0.5f, 1.0f};
  scene.animations[0].properties.push_back({{PropertyKind::camera_fov_y, 0}, zoom});
  scene.clips.clear();
  finish_scene(scene);
  show(std::move(loaded));
  shown_->playback().seek(1.0);
  submit(kAhead);
  settled();
  for (const std::uint32_t camera : {0u, 1u, 0u}) {
    EXPECT_NEAR(shown_->view_of(camera, 1.5).fov_y_rad, camera == 0 ? 0.75 : 1.2, 1e-6);
    EXPECT_NEAR(shown_->coming_view_of(camera, 1.5).fov_y_rad, camera == 0 ? 0.75 : 1.2, 1e-6);
  }
}

TEST_F(shown_scene, the_extent_is_that_of_the_clip_or_of_the_rest_pose) {
  show(gliding_box(false));
  for (const std::uint32_t clip : {0u, kNone, 0u}) {
    shown_->playback().choose(clip);
    EXPECT_EQ(shown_->bounds().reached.upper, clip_extent(loaded_.scene, clip).reached.upper);
  }
}

TEST_F(shown_scene, another_weight_of_the_cache_is_asked_for_while_the_time_stands_still) {
  const Bytes bytes = flag_bytes();
  show(scene_of_cache_file(bytes));
  shown_->playback().seek(0.5);
  const auto corner = [&](float weight) {
    shown_->set_cache_weight(weight);
    EXPECT_FALSE(shown_->settled()) << "nobody asked for it";
    submit(kAhead);
    return glm::dvec3(settled().primitives[0].positions.back());
  };
  const glm::dvec3 whole = corner(1.0f), half = corner(0.5f), quarter = corner(0.25f);
  EXPECT_GT(glm::length(whole - half), 0.01);
  EXPECT_LT(glm::length(whole - half - 2.0 * (half - quarter)), 1e-5);
  shown_.reset();  // must be destroyed before the bytes
}

TEST_F(shown_scene, says_of_a_damaged_cache_what_is_wrong_wherever_it_is_asked) {
  const Bytes bytes = with_damage(flag_bytes(), 10);
  show(scene_of_cache_file(bytes));
  shown_->playback().seek(0.1);
  submit(kAhead);
  settled();
  EXPECT_EQ(shown_->cache_facts()->fault, "");
  shown_->playback().seek(0.4);
  submit(kAhead);
  settled();
  EXPECT_NE(shown_->cache_fault().find("flag: cache-checksum: "), std::string::npos);
  EXPECT_EQ(shown_->cache_facts()->fault, shown_->cache_fault());
  shown_->playback().seek(0.1);
  submit(kAhead);
  settled();
  EXPECT_EQ(shown_->cache_fault(), "") << "this frame is whole";
  shown_.reset();  // must be destroyed before the bytes
}

TEST_F(shown_scene, what_is_small_is_evaluated_less_often_but_not_while_the_time_stands_still) {
  play_far_away();
  for (int frame = 0; frame < 4; ++frame) {  // whether the last pose was a held one or not
    shown_->playback().advance(0.004);
    submit(kFar);
    shown_->playback().pause();
    for (int i = 0; i < 4000 && !shown_->settled(); ++i) {  // while the worker is busy, nothing is requested
      submit(kFar);
      shown_->newest();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_NEAR(place_m(), 2.0 * shown_->playback().time_s(), 1e-5) << frame;
    EXPECT_EQ(shown_->update_levels().reason(), "every frame: the time stands still");
    shown_->playback().toggle();
  }
  shown_->submit(kFar, true, 1.5, false);
  EXPECT_EQ(shown_->update_levels().reason(), "every frame: the camera moves with the clip");
}

TEST_F(shown_scene, catches_up_with_a_time_that_was_set_however_small_it_is_seen) {
  play_far_away();
  for (int frame = 0; frame < 8; ++frame) {  // whether the last pose was a held one or not
    const double time_s = 0.3 + 0.2 * frame;
    shown_->playback().seek(time_s);
    shown_->catch_up();
    EXPECT_NEAR(place_m(), 2.0 * time_s, 1e-5) << frame;
    shown_->playback().advance(0.004);
    submit(kFar);
  }
}

TEST_F(shown_scene, vertices_have_the_ambient_visibility_of_the_time) {
  LoadedScene loaded = gliding_box(false);
  VertexVisibility visibility;
  visibility.clip = 0;
  visibility.times_s = {0.0, 2.0};
  visibility.values = {{std::vector<float>(2 * loaded.scene.meshes[0].primitives[0].positions.size(), 0.5f)}};
  for (const bool has_visibility : {true, false}) {
    loaded.visibility = has_visibility ? std::make_shared<const VertexVisibility>(visibility) : nullptr;
    show(loaded);
    shown_->playback().seek(0.5);
    const DrawnScene drawn = shown_->upload(0, kNone);
    EXPECT_EQ(drawn.visibility, (has_visibility ? VisibilityBlend{0, 1, 0.25f} : VisibilityBlend{}));
    const PrimitiveBuffers& buffers = drawn.scene->meshes().primitive(0, 0);
    EXPECT_EQ(buffers.attributes[static_cast<std::size_t>(Attribute::visibility)] != kAbsent, has_visibility);
  }
}

}  // namespace
}  // namespace sinew::viewer
