// SPDX-License-Identifier: MIT
#include "runtime/library/bind_clips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/rebind_clip.h"
#include "tests/library/named_scene.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BoundClips bind(const Scene& from, const Scene& to) {
  return bind_clips(from.clips, clip_channels(from), clip_channels(to));
}

TEST(bind_clips, joints_bind_by_name_and_keep_their_bits) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = named_scene(seed), other = reordered(scene);
    const std::vector<std::uint32_t> places = reordered_joints(scene.skeleton);
    const BoundClips bound = bind(scene, other);
    EXPECT_TRUE(bound.unbound.empty());
    for (std::size_t c = 0; c < scene.clips.size(); ++c)
      for (double t = -0.1; t < scene.clips[c].duration_s() + 0.2; t += 0.05) {
        const Sample before = sample(scene.clips[c], t), after = sample(bound.clips[c], t);
        for (std::size_t j = 0; j < places.size(); ++j)
          EXPECT_TRUE(same_bits(after.pose[places[j]], before.pose[j])) << "joint " << j << " at " << t;
        EXPECT_TRUE(same_bits<float>(after.weights, before.weights)) << t;
        EXPECT_TRUE(same_bits(after.pose[0], Transform{}));
      }
  }
}

TEST(bind_clips, joints_that_a_clip_does_not_move_rest_where_it_is_bound_to) {
  const Scene scene = named_scene(1);
  Scene larger = scene;
  for (Transform& rest : larger.skeleton.rest) rest.translation *= 1.5f;
  finish_scene(larger);
  const BoundClips bound = bind(scene, larger);
  const ClipChannels channels = clip_channels(scene);
  std::size_t resting = 0;
  for (std::size_t c = 0; c < scene.clips.size(); ++c) {
    const std::vector<bool> moved = motion_of(scene.clips[c], channels.rest).joints;
    const Sample before = sample(scene.clips[c], 0.3), after = sample(bound.clips[c], 0.3);
    for (std::size_t j = 0; j < moved.size(); ++j) {
      EXPECT_TRUE(same_bits(after.pose[j].rotation, before.pose[j].rotation)) << j;
      if (moved[j]) continue;
      ++resting;
      EXPECT_TRUE(same_bits(after.pose[j].translation, larger.skeleton.rest[j].translation)) << j;
    }
  }
  EXPECT_GT(resting, 0u);
}

TEST(bind_clips, what_is_moved_and_not_found_is_listed_once) {
  const Scene scene = named_scene(2);
  Scene other = scene;
  const std::vector<bool> moved = motion_of(scene.clips[0], clip_channels(scene).rest).joints;
  const auto joint = static_cast<std::size_t>(std::find(moved.begin(), moved.end(), true) - moved.begin());
  other.skeleton.names[joint] = "tail";
  const std::uint32_t mesh = scene.instances[scene.animations[0].weights[0].instance].mesh;
  other.meshes[mesh].target_names[2] = "wink";
  const Unbound unbound = bind(scene, other).unbound;
  EXPECT_THAT(unbound.missing, ElementsAre(scene.skeleton.names[joint], scene.meshes[mesh].name + "/blink"));
  EXPECT_THAT(unbound.ambiguous, IsEmpty());
}

TEST(bind_clips, names_of_several_joints_and_clips_are_listed_once) {
  const Scene arm = arm_scene();
  Scene other = arm;
  other.skeleton.names = {"tail", "hook", "tail"};
  const auto turning = [](const char* name, std::vector<std::uint32_t> joints) {
    Animation animation{name, 1.0, {}, {}};
    for (const std::uint32_t joint : joints) {
      BoneAnimation bone;
      bone.joint = joint;
      bone.rotation = {Interpolation::linear, {0, 1}, {{1, 0, 0, 0}, {0, 1, 0, 0}}};
      animation.bones.push_back(bone);
    }
    return animation;
  };
  other.animations = {turning("both", {0, 2}), turning("one", {1})};
  finish_scene(other);
  Unbound unbound = bind(other, arm).unbound;
  EXPECT_THAT(unbound.missing, ElementsAre("tail", "hook"));
  unbound.add({{"hook", "fin"}, {"fin"}});
  EXPECT_THAT(unbound.missing, ElementsAre("tail", "hook", "fin"));
  EXPECT_THAT(unbound.ambiguous, ElementsAre("fin"));
}

TEST(bind_clips, names_that_are_double_here_or_there_are_not_guessed) {
  const Scene arm = arm_scene();  // its clip moves "lower"
  Scene there = arm, here = arm;
  there.skeleton.names = {"lower", "holder", "lower"};
  EXPECT_THAT(bind(arm, there).unbound.ambiguous, ElementsAre("lower"));
  EXPECT_TRUE(same_bits(sample(bind(arm, there).clips[0], 1.0).pose[2], arm.skeleton.rest[2]));

  here.skeleton.names = {"lower", "holder", "lower"};
  EXPECT_THAT(bind(here, arm).unbound.ambiguous, ElementsAre("lower"));
  EXPECT_THAT(bind(here, arm).unbound.missing, IsEmpty());
  EXPECT_TRUE(bind(here, there).unbound.empty()) << "skeletons of one signature bind joint by joint";
}

TEST(bind_clips, what_has_no_name_is_described) {
  Scene nameless = arm_scene();
  nameless.skeleton.names[2].clear();
  EXPECT_THAT(bind(nameless, arm_scene()).unbound.missing, ElementsAre("joint 2 without a name"));
  Scene face = face_scene();
  face.meshes[0].name.clear();
  for (std::string& name : face.skeleton.names) name.clear();
  EXPECT_THAT(bind(face, face).unbound.missing,
              ElementsAre("morph weight 0 without a name", "morph weight 1 without a name"));
}

TEST(bind_clips, morph_weights_bind_by_mesh_and_target) {
  const Scene face = face_scene();
  Scene other = face;  // with another order and one more mesh
  other.meshes[0].target_names = {"spread", "lift"};
  other.meshes.insert(other.meshes.begin(), face.meshes[0]);
  other.meshes[0].name = "hat";
  other.instances = {{0, 0, kNone, {0.5f, 0.5f}}, {0, 1, kNone, {0.0f, 0.0f}}};
  other.animations.clear();
  finish_scene(other);
  const BoundClips bound = bind(face, other);
  EXPECT_TRUE(bound.unbound.empty());
  EXPECT_THAT(sample(bound.clips[0], 0.5).weights, ElementsAre(0.5f, 0.5f, 1.0f, 0.5f));

  other.meshes[0].name = "face";  // now two meshes have this name
  EXPECT_THAT(bind(face, other).unbound.ambiguous, ElementsAre("face/lift", "face/spread"));
}

TEST(bind_clips, properties_bind_to_the_thing_of_their_name) {
  const auto colored = [](std::vector<std::string> materials, std::uint32_t moved) {
    Scene scene = arm_scene();
    for (std::string& name : materials) scene.materials.push_back(Material{.name = std::move(name)});
    scene.animations[0].properties = {
        {{PropertyKind::emissive, moved}, {Interpolation::linear, {0, 1}, {0, 0, 0, 1, 2, 3}, 3}}};
    finish_scene(scene);
    return scene;
  };
  const Scene from = colored({"skin"}, 0);
  EXPECT_THAT(sample(bind(from, colored({"cloth", "skin"}, 1)).clips[0], 1.0).numbers, ElementsAre(1, 2, 3));
  EXPECT_THAT(bind(from, colored({"cloth"}, 0)).unbound.missing,
              ElementsAre("material skin/emissive/0", "material skin/emissive/1", "material skin/emissive/2"));
}

}  // namespace
}  // namespace sinew::test
