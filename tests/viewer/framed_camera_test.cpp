// SPDX-License-Identifier: MIT
// The user's camera while its subject moves, the clip changes, or the file changes.
#include "viewer/app/camera/framed_camera.h"

#include <glm/geometric.hpp>

#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "tests/viewer/cache_scene.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/reload/replace_shown_scene.h"

namespace sinew::viewer {
namespace {

constexpr double kAspect = 1.6;

/// A box that glides 4 m along x in each of these clips, which begin at these places.
LoadedScene gliding(std::initializer_list<float> begins_m) {
  showcase::SceneBuilder scene;
  const std::uint32_t joint = scene.add_joint("box", kNone, {});
  scene.add_instance(joint, scene.add_mesh({"box", {showcase::box({0, 0, 0}, glm::vec3(0.5f))}, {}, {}}));
  int number = 0;
  for (const float begin : begins_m) {
    BoneAnimation bone;
    bone.joint = joint;
    bone.translation.times_s = {0.0f, 2.0f};
    bone.translation.values = {{begin, 0.0f, 0.0f}, {begin + 4.0f, 0.0f, 0.0f}};
    scene.add_animation({"glide " + std::to_string(++number), 2.0, {bone}, {}});
  }
  LoadedScene loaded;
  loaded.scene = scene.finish();
  return loaded;
}

std::unique_ptr<ShownScene> show(const LoadedScene& loaded, const Evaluation& evaluation) {
  return std::make_unique<ShownScene>(*test_device(), loaded, evaluation, 2, TextureFilter{});
}

class framed_camera : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    if (!IsSkipped()) shown_ = show(loaded_, {});
    camera_.orbit.yaw_rad = camera_.orbit.pitch_rad = 0.0;  // along -z, so that the middle of the box is the target
  }
  void TearDown() override {
    shown_.reset();
    DeviceTest::TearDown();
  }
  void follow_at(double time_s) {
    shown_->playback().seek(time_s);
    camera_.follow(*shown_, kAspect);
  }
  void change_to(LoadedScene changed) {
    ASSERT_TRUE(replace_shown_scene(*test_device(), std::move(changed), loaded_, shown_, show));
    camera_.keep_following(*shown_);
  }
  const glm::dvec3& target() const { return camera_.orbit.target; }

  LoadedScene loaded_ = gliding({0.0f, 10.0f});
  std::unique_ptr<ShownScene> shown_;
  FramedCamera camera_;
};

TEST_F(framed_camera, goes_along_from_where_the_user_moved_it) {
  camera_.frame(Framing::follow, *shown_, kAspect);
  EXPECT_NEAR(target().x, 0.0, 1e-6);
  follow_at(1.0);
  EXPECT_NEAR(target().x, 2.0, 1e-6);
  camera_.orbit.target.x += 1.0;
  follow_at(1.5);
  EXPECT_NEAR(target().x, 4.0, 1e-6);
}

TEST_F(framed_camera, frames_what_it_follows_wherever_that_is_now) {
  camera_.frame(Framing::follow, *shown_, kAspect);
  for (const double time_s : {1.0, 0.5}) {
    follow_at(time_s);
    camera_.orbit.target.x += 1.0;
    camera_.frame(Framing::follow, *shown_, kAspect);
    EXPECT_NEAR(target().x, 2.0 * time_s, 1e-6);
  }
}

TEST_F(framed_camera, frames_another_clip_anew) {
  camera_.frame(Framing::follow, *shown_, kAspect);
  camera_.orbit.target.x += 1.0;
  shown_->playback().choose(1);
  follow_at(0.5);
  EXPECT_NEAR(target().x, 11.0, 1e-6);
}

TEST_F(framed_camera, frames_another_clip_in_what_is_free_of_the_picture) {
  const FreePart free{-0.2, 1.0};
  camera_.frame(Framing::follow, *shown_, kAspect, free);
  const double aside = camera_.orbit.aside, distance_m = camera_.orbit.distance_m;
  EXPECT_GT(aside, 0.1);
  shown_->playback().choose(1);
  follow_at(0.5);
  EXPECT_EQ(camera_.orbit.aside, aside);
  EXPECT_NEAR(camera_.orbit.distance_m, distance_m, 1e-5);
}

TEST_F(framed_camera, frames_and_follows_a_geometry_cache_where_it_is) {
  const Bytes bytes = gliding_cache();
  shown_.reset();
  loaded_ = scene_of_cache_file(bytes);
  shown_ = show(loaded_, {});
  const double end_s = loaded_.cache->duration_s();
  shown_->playback().seek(end_s);
  camera_.frame(Framing::pose, *shown_, kAspect);
  EXPECT_NEAR(target().x, 4.5, 0.01);
  camera_.frame(Framing::follow, *shown_, kAspect);
  EXPECT_NEAR(target().x, 4.5, 0.01);
  follow_at(0.5 * end_s);
  EXPECT_NEAR(target().x, 2.5, 0.01);
  shown_.reset();  // must be destroyed before the bytes
}

TEST_F(framed_camera, keeps_its_place_beside_what_it_follows_when_the_file_changes) {
  camera_.frame(Framing::follow, *shown_, kAspect);
  camera_.orbit.target.x += 1.0;
  follow_at(1.0);
  ASSERT_NEAR(target().x, 3.0, 1e-6);
  change_to(gliding({5.0f, 10.0f}));
  EXPECT_NEAR(target().x, 8.0, 1e-6);
  const glm::dvec3 there = target();
  follow_at(1.0);
  EXPECT_EQ(target(), there) << "it is there already";
  follow_at(1.5);
  EXPECT_NEAR(target().x, 9.0, 1e-6);
}

TEST_F(framed_camera, keeps_its_place_when_the_clip_is_gone) {
  shown_->playback().choose(1);
  camera_.frame(Framing::follow, *shown_, kAspect);
  camera_.orbit.target.x += 1.0;
  const double distance_m = camera_.orbit.distance_m *= 2.0;
  change_to(gliding({3.0f}));
  camera_.follow(*shown_, kAspect);
  EXPECT_NEAR(target().x, 4.0, 1e-6) << "the first clip plays from its start";
  EXPECT_EQ(camera_.orbit.distance_m, distance_m);
}

TEST_F(framed_camera, that_follows_nothing_stays_where_it_is) {
  for (const Framing framing : {Framing::clip, Framing::pose}) {
    camera_.frame(Framing::follow, *shown_, kAspect);
    camera_.frame(framing, *shown_, kAspect);
    const glm::dvec3 there = target();
    follow_at(1.0);
    EXPECT_EQ(target(), there);
    change_to(gliding({5.0f, 10.0f}));
    EXPECT_EQ(target(), there);
    change_to(gliding({0.0f, 10.0f}));
  }
}

}  // namespace
}  // namespace sinew::viewer
