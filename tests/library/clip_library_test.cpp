// SPDX-License-Identifier: MIT
#include "runtime/library/clip_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "tests/library/named_scene.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

bool is_same_handle(const Clip& a, const Clip& b) { return &a.layout() == &b.layout(); }

/// Number of key arrays that two clips share, and number of those in the first.
std::pair<std::size_t, std::size_t> shared_rows(const Clip& a, const Clip& b) {
  std::size_t shared = 0, all = 0;
  for (std::size_t g = 0; g < a.layout().groups.size(); ++g)
    for (std::size_t i = 0; i < a.layout().groups[g].blocks.size(); ++i, ++all)
      shared += a.layout().groups[g].blocks[i].rows.shares_with(b.layout().groups[g].blocks[i].rows);
  return {shared, all};
}

TEST(clip_library, clips_of_the_same_skeleton_and_model_are_the_same_handles) {
  const Scene scene = named_scene(1);
  ClipLibrary library(scene.skeleton);
  EXPECT_TRUE(library.add(scene).empty());
  const BoundClips bound = clips_for(library, scene);
  ASSERT_EQ(bound.clips.size(), scene.clips.size());
  for (std::size_t c = 0; c < scene.clips.size(); ++c) {
    EXPECT_TRUE(is_same_handle(library[c], scene.clips[c]));
    EXPECT_TRUE(is_same_handle(bound.clips[c], scene.clips[c]));
  }
  EXPECT_EQ(library.signature(), skeleton_signature(scene.skeleton));
}

TEST(clip_library, scenes_of_one_skeleton_share_the_keys) {
  const Scene scene = named_scene(3);
  ClipLibrary library(scene.skeleton);
  library.add(scene);
  Scene small = scene;  // with another rest pose and other rest weights
  for (Transform& rest : small.skeleton.rest) rest.translation *= 0.5f;
  for (MeshInstance& instance : small.instances) instance.rest_weights.assign(3, 0.125f);
  small.animations.clear();
  finish_scene(small);
  const BoundClips bound = clips_for(library, small);
  EXPECT_TRUE(bound.unbound.empty());
  for (std::size_t c = 0; c < library.size(); ++c) {
    const auto [shared, all] = shared_rows(library[c], bound.clips[c]);
    EXPECT_EQ(shared, all);
    EXPECT_GT(all, 0u);
    EXPECT_EQ(bound.clips[c].layout().base_pose.rest(), bound.clips[0].layout().base_pose.rest());
  }
}

TEST(clip_library, clips_of_another_file_bind_by_name_and_keep_their_bits) {
  const Scene scene = named_scene(4), file = reordered(scene);
  ClipLibrary library(scene.skeleton);
  EXPECT_TRUE(library.add(file).empty());
  const BoundClips bound = clips_for(library, scene);
  EXPECT_TRUE(bound.unbound.empty());
  for (std::size_t c = 0; c < scene.clips.size(); ++c)
    for (double t = 0.0; t < scene.clips[c].duration_s(); t += 0.07) {
      const Sample from_file = sample(bound.clips[c], t), own = sample(scene.clips[c], t);
      EXPECT_TRUE(same_bits<Transform>(from_file.pose, own.pose)) << t;
      EXPECT_TRUE(same_bits<float>(from_file.weights, own.weights)) << t;
    }
}

TEST(clip_library, refuse_adds_nothing_where_something_does_not_bind) {
  const Scene arm = arm_scene();
  Scene other = arm;
  other.skeleton.names[2] = "forearm";
  ClipLibrary library(arm.skeleton);
  EXPECT_THAT(library.add(other, IfUnbound::refuse).missing, ElementsAre("forearm"));
  EXPECT_EQ(library.size(), 0u);
  EXPECT_THAT(library.add(other).missing, ElementsAre("forearm"));
  EXPECT_EQ(library.size(), 1u);
  EXPECT_TRUE(library.add(arm, IfUnbound::refuse).empty());
  EXPECT_EQ(library.size(), 2u);
}

TEST(clip_library, a_clip_is_found_by_its_name_where_it_is_the_only_one) {
  const Scene scene = named_scene(5);
  ClipLibrary library(scene.skeleton);
  library.add(scene);
  EXPECT_EQ(library.find("clip 1"), 1u);
  EXPECT_EQ(library.find("clip 2"), std::nullopt);
  library.add(scene);
  EXPECT_EQ(library.find("clip 1"), std::nullopt) << "two clips have the name";
}

TEST(clip_library, each_file_keeps_the_names_of_its_own_weights) {
  Scene face = face_scene(), mask = face_scene();
  mask.meshes[0].name = "mask";
  ClipLibrary library(face.skeleton);
  EXPECT_TRUE(library.add(face).empty());
  EXPECT_TRUE(library.add(mask).empty());
  const BoundClips for_face = clips_for(library, face), for_mask = clips_for(library, mask);
  EXPECT_THAT(sample(for_face.clips[0], 1.0).weights, ElementsAre(1.0f, 2.0f));
  EXPECT_THAT(sample(for_face.clips[1], 1.0).weights, ElementsAre(0.25f, 0.0f));  // rest value
  EXPECT_THAT(sample(for_mask.clips[1], 1.0).weights, ElementsAre(1.0f, 2.0f));
  EXPECT_THAT(for_face.unbound.missing, ElementsAre("mask/lift", "mask/spread"));
}

}  // namespace
}  // namespace sinew::test
