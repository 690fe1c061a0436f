// SPDX-License-Identifier: MIT
// Options of the command line that choose clips, times and vertices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>

#include "importer/tool/clip_choice.h"
#include "importer/tool/poses/vertex_choice.h"
#include "importer/tool/sample_times.h"

namespace sinew::tool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene scene_with_clips(std::initializer_list<const char*> names) {
  Scene scene;
  for (const char* name : names) scene.animations.emplace_back().name = name;
  return scene;
}

TEST(clip_choice, without_a_wish_the_rest_pose_and_all_clips) {
  EXPECT_THAT(*choose_clips(scene_with_clips({"a", "b"}), std::nullopt), ElementsAre(kNone, 0u, 1u));
  EXPECT_THAT(*choose_clips(scene_with_clips({}), std::nullopt), ElementsAre(kNone));
}

TEST(clip_choice, a_number_is_an_index_first_and_a_name_second) {
  const Scene scene = scene_with_clips({"1", "walk", "walk", "77"});
  EXPECT_THAT(*choose_clips(scene, "1"), ElementsAre(1u));
  EXPECT_THAT(*choose_clips(scene, "77"), ElementsAre(3u));
  EXPECT_THAT(*choose_clips(scene, "walk"), ElementsAre(1u));
  EXPECT_THAT(*choose_clips(scene, "none"), ElementsAre(kNone));
}

TEST(clip_choice, a_name_and_a_number_find_clips_of_equal_empty_and_numeric_names) {
  const Scene scene = scene_with_clips({"walk", "", "walk", "0", "", "none", "run#2", "run", "run", "walk"});
  const std::pair<const char*, std::uint32_t> choices[] = {{"walk#1", 0}, {"walk#2", 2}, {"walk#3", 9}, {"", 1},
                                                           {"#1", 1},     {"#2", 4},     {"0", 0},      {"0#1", 3},
                                                           {"none#1", 5}, {"run#2", 6},  {"run#1", 7}};
  for (const auto& [text, clip] : choices) EXPECT_THAT(*choose_clips(scene, text), ElementsAre(clip)) << text;
  for (const char* wrong : {"walk#4", "walk#0", "walk#", "walk#02", "walk#+1", "walk#1x", "#3", "jump#1"})
    EXPECT_FALSE(choose_clips(scene, wrong)) << wrong;
}

TEST(clip_choice, what_is_not_there_is_answered_with_what_is) {
  const auto wrong = choose_clips(scene_with_clips({"walk", "run"}), "jump");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error(), HasSubstr("jump"));
  EXPECT_THAT(wrong.error(), HasSubstr("0 \"walk\", 1 \"run\""));
  EXPECT_FALSE(choose_clips(scene_with_clips({"walk"}), "1"));
  EXPECT_FALSE(choose_clips(scene_with_clips({"walk"}), "-1"));
  EXPECT_THAT(choose_clips(scene_with_clips({}), "0").error(), HasSubstr("no clips"));
}

TEST(sample_times, a_list_is_read_with_all_its_digits) {
  EXPECT_THAT(*parse_times("0,0.10339999943971634,2.5e1"), ElementsAre(0.0, 0.10339999943971634, 25.0));
  EXPECT_THAT(*parse_times("-1"), ElementsAre(-1.0));
}

TEST(sample_times, what_is_no_number_is_refused) {
  for (const char* wrong : {"", "1,", ",1", "1;2", "one", "nan", "inf", "1e999", "0x10", " 1"})
    EXPECT_FALSE(parse_times(wrong)) << '"' << wrong << '"';
}

TEST(sample_times, representative_times_hold_the_ends_some_keys_and_middles) {
  Animation animation;
  auto& bone = animation.bones.emplace_back();
  bone.translation.times_s = {0.5f, 1.0f, 2.0f};
  bone.scale.times_s = {1.0f, 4.0f};
  EXPECT_THAT(representative_times(animation), ElementsAre(0.0, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0));
  EXPECT_THAT(representative_times(Animation{}), ElementsAre(0.0));
}

TEST(sample_times, keys_of_every_kind_of_track_tell) {
  const std::vector<float> keys{1, 2, 3, 4, 5, 6, 7, 8, 9};
  const auto expect = [&](const std::function<void(Animation&)>& add) {
    Animation animation;
    add(animation);
    EXPECT_THAT(representative_times(animation), ElementsAre(0.0, 1.0, 1.5, 3.0, 3.5, 5.0, 5.5, 7.0, 7.5, 9.0));
  };
  expect([&](Animation& a) { a.bones.emplace_back().translation.times_s = keys; });
  expect([&](Animation& a) { a.bones.emplace_back().rotation.times_s = keys; });
  expect([&](Animation& a) { a.bones.emplace_back().scale.times_s = keys; });
  expect([&](Animation& a) { a.weights.emplace_back().weights.times_s = keys; });
}

TEST(sample_times, frames_run_to_the_end_and_include_it) {
  EXPECT_THAT(frame_times(1.0, 4.0), ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
  EXPECT_THAT(frame_times(0.9, 2.0), ElementsAre(0.0, 0.5, 0.9));
  EXPECT_THAT(frame_times(0.0, 30.0), ElementsAre(0.0));
}

Primitive primitive_of(std::size_t vertices) {
  Primitive primitive;
  primitive.positions.resize(vertices);
  return primitive;
}

TEST(vertex_choice, is_spread_evenly_with_both_ends) {
  EXPECT_THAT(choose_vertices(primitive_of(101), 5).in_file, ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(choose_vertices(primitive_of(3), 64).in_file, ElementsAre(0, 1, 2));
  EXPECT_THAT(choose_vertices(primitive_of(9), 1).in_file, ElementsAre(0));
  EXPECT_THAT(choose_vertices(primitive_of(9), 0).in_file, ElementsAre());
  EXPECT_THAT(choose_vertices(primitive_of(0), 64).in_file, ElementsAre());
}

TEST(vertex_choice, counts_in_the_files_numbers_and_a_split_vertex_once) {
  Primitive primitive = primitive_of(5);
  primitive.source_vertex = {2, 0, 1, 0, 2};
  const VertexChoice all = choose_vertices(primitive, kAllVertices);
  EXPECT_THAT(all.in_file, ElementsAre(0, 1, 2));
  EXPECT_THAT(all.in_primitive, ElementsAre(1, 2, 0));
}

TEST(vertex_choice, knows_the_influences_of_each_vertex) {
  Primitive primitive = primitive_of(4);
  primitive.influences.groups = {{0, 2, 1, 0}, {2, 2, 3, 2}};
  primitive.influences.joints.assign(8, 0);
  const VertexChoice all = choose_vertices(primitive, kAllVertices);
  ASSERT_EQ(all.influences.size(), 4u);
  EXPECT_EQ(all.influences[1].first, 1u);
  EXPECT_EQ(all.influences[1].count, 1u);
  EXPECT_EQ(all.influences[3].first, 5u);
  EXPECT_EQ(all.influences[3].count, 3u);
}

}  // namespace
}  // namespace sinew::tool
