// SPDX-License-Identifier: MIT
#include "viewer/app/scene_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

Scene scene_with(std::initializer_list<const char*> names) {
  Scene scene;
  for (const char* name : names) scene.animations.emplace_back().name = name;
  return scene;
}

TEST(scene_choice, of_a_clip_takes_an_index_a_name_or_none) {
  const Scene scene = scene_with({"Walk", "", "Run", "Run"});
  EXPECT_EQ(choose_clip(scene, "0"), 0u);
  EXPECT_EQ(choose_clip(scene, "3"), 3u);
  EXPECT_EQ(choose_clip(scene, "Run"), 2u);  // the first of that name
  EXPECT_EQ(choose_clip(scene, "Run#2"), 3u);
  EXPECT_EQ(choose_clip(scene, "#1"), 1u);
  EXPECT_EQ(choose_clip(scene, "Run#3"), std::nullopt);
  EXPECT_EQ(choose_clip(scene, "none"), kNone);
}

TEST(scene_choice, a_name_made_of_digits_is_found_when_no_index_fits) {
  const Scene scene = scene_with({"1", "007", "9"});
  EXPECT_EQ(choose_clip(scene, "1"), 1u);
  EXPECT_EQ(choose_clip(scene, "9"), 2u);
  EXPECT_EQ(choose_clip(scene, "007"), 1u);  // no clip has index 7
}

TEST(scene_choice, finds_nothing_for_what_is_not_there) {
  const Scene scene = scene_with({"Walk"});
  for (const char* text : {"1", "walk", "-1", "0x0", " 0", "99999999999999999999"})
    EXPECT_EQ(choose_clip(scene, text), std::nullopt) << text;
  EXPECT_EQ(choose_clip(Scene{}, "0"), std::nullopt);
  EXPECT_EQ(choose_clip(Scene{}, "none"), kNone);
}

TEST(scene_choice, the_message_names_the_clips_that_there_are) {
  EXPECT_EQ(describe_missing_clip(scene_with({"Walk", ""}), "Fly"),
            "--clip Fly: no such clip; the scene has 0 \"Walk\", 1 \"\"");
  EXPECT_EQ(describe_missing_clip(Scene{}, "Fly"), "--clip Fly: no such clip; the scene has none");
}

TEST(scene_choice, the_message_names_twelve_clips_and_tells_whether_there_are_more) {
  for (const std::uint32_t count : {11u, 12u, 13u}) {
    Scene scene;
    std::string named;
    for (std::uint32_t i = 0; i < count; ++i) {
      scene.animations.emplace_back().name = "c";
      if (i < 12) named += (i > 0 ? ", " : "") + std::to_string(i) + " \"c\"";
    }
    EXPECT_EQ(describe_missing_clip(scene, "Fly"),
              "--clip Fly: no such clip; the scene has " + named + (count > 12 ? ", ..." : ""));
  }
}

TEST(scene_choice, labels_are_never_empty) {
  const Scene scene = scene_with({"Walk", ""});
  EXPECT_EQ(clip_label(scene, 0), "Walk");
  EXPECT_FALSE(clip_label(scene, 1).empty());
  EXPECT_EQ(clip_label(scene, kNone), "rest pose");
}

Scene scene_with_cameras_and_variants() {
  Scene scene;
  scene.cameras = {{.name = "front", .joint = 0}, {.name = "unplaced"}, {.name = "7", .joint = 1}};
  scene.variants = {"day", "night"};
  return scene;
}

TEST(scene_choice, of_a_camera_takes_an_index_or_a_name_when_a_node_carries_it) {
  const Scene scene = scene_with_cameras_and_variants();
  EXPECT_EQ(choose_camera(scene, "0"), 0u);
  EXPECT_EQ(choose_camera(scene, "front"), 0u);
  EXPECT_EQ(choose_camera(scene, "2"), 2u);
  EXPECT_EQ(choose_camera(scene, "7"), 2u) << "a name of digits";
  EXPECT_FALSE(choose_camera(scene, "1"));
  EXPECT_FALSE(choose_camera(scene, "unplaced"));
  EXPECT_FALSE(choose_camera(scene, ""));
  EXPECT_THAT(describe_missing_camera(scene, "left"),
              HasSubstr("--camera left: no such camera; the scene has 0 \"front\", 2 \"7\""));
  EXPECT_THAT(describe_missing_camera(Scene{}, "left"), HasSubstr("has none"));
  EXPECT_EQ(camera_label(scene, kNone), "free");
}

TEST(scene_choice, of_a_variant_takes_an_index_or_a_name) {
  const Scene scene = scene_with_cameras_and_variants();
  EXPECT_EQ(choose_variant(scene, "night"), 1u);
  EXPECT_EQ(choose_variant(scene, "0"), 0u);
  EXPECT_FALSE(choose_variant(scene, "2"));
  EXPECT_THAT(describe_missing_variant(scene, "dusk"), HasSubstr("1 \"night\""));
  EXPECT_EQ(variant_label(scene, kNone), "as in the file");
}

TEST(scene_choice, finds_a_clip_again_by_its_name) {
  const auto before = clip_names(scene_with({"Walk", "Run", "", "Run", "Run", ""}));
  const Scene now = scene_with({"Run", "", "Walk", "Run"});
  EXPECT_EQ(same_clip(before, 0, now), 2u);
  EXPECT_EQ(same_clip(before, 1, now), 0u) << "the first of that name";
  EXPECT_EQ(same_clip(before, 3, now), 3u) << "the second of that name";
  EXPECT_EQ(same_clip(before, 4, now), std::nullopt) << "there is no third one";
  EXPECT_EQ(same_clip(before, 2, now), 1u) << "the first without a name";
  EXPECT_EQ(same_clip(before, 5, now), std::nullopt);
  EXPECT_EQ(same_clip(before, kNone, now), kNone) << "the rest pose stays";
  EXPECT_EQ(same_clip({}, kNone, Scene{}), kNone);
  EXPECT_EQ(same_clip({}, 0, now), std::nullopt);
}

TEST(scene_choice, finds_cameras_and_variants_again_by_their_names) {
  Scene before, now;
  before.cameras.resize(3);
  for (Camera& camera : before.cameras) camera.joint = 0;
  before.cameras[0].name = before.cameras[2].name = "wide";
  now.cameras.resize(2);
  now.cameras[0].name = now.cameras[1].name = "wide";
  now.cameras[1].joint = 0;
  EXPECT_EQ(same_camera(before, 0, now), 1u) << "a camera on no node does not count";
  EXPECT_EQ(same_camera(before, 1, now), std::nullopt);
  EXPECT_EQ(same_camera(before, 2, now), std::nullopt);
  EXPECT_EQ(same_camera(before, kNone, now), kNone);
  before.variants = {"red", "blue"};
  now.variants = {"blue"};
  EXPECT_EQ(same_variant(before, 1, now), 0u);
  EXPECT_EQ(same_variant(before, 0, now), std::nullopt);
  EXPECT_EQ(same_variant(before, kNone, now), kNone);
}

}  // namespace
}  // namespace sinew::viewer
