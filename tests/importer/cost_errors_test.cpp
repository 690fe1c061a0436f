// SPDX-License-Identifier: MIT
// The errors that `sinew cost` reports are the largest over all poses, weights and frames it samples. Its other numbers
// are those that their names say.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/cost/make_report.h"
#include "importer/tool/cost/occlusion_group.h"
#include "tests/importer/cost_study.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

glm::quat about_z(double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  return {static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half))};
}

/// An arm that swings far at first and little at the end, or the reverse.
Scene swinging_arm(bool backwards) {
  Scene scene = arm_scene();
  BoneAnimation& bone = scene.animations[0].bones[0];
  bone.rotation = {Interpolation::linear, {0.0f, 0.25f, 1.0f}, {about_z(70), about_z(120), about_z(5)}};
  bone.scale = {Interpolation::linear, {0.0f, 1.0f}, {{1, 3, 1}, {1, 1, 1}}};
  if (backwards) {
    bone.rotation = {Interpolation::linear, {0.0f, 0.75f, 1.0f}, {about_z(5), about_z(120), about_z(70)}};
    bone.scale.values = {{1, 1, 1}, {1, 3, 1}};
  }
  finish_scene(scene);
  return scene;
}

Scene changing_face(bool backwards) {
  Scene scene = face_scene();
  WeightTrack& track = scene.animations[0].weights[0].weights;
  track.values = {0.04f, 0.045f, 0.002f, 0.003f};
  if (backwards) track.values = {0.002f, 0.003f, 0.04f, 0.045f};
  finish_scene(scene);
  return scene;
}

void expect_same_errors(const Group& forwards, const Group& backwards) {
  ASSERT_EQ(forwards.points.size(), backwards.points.size()) << forwards.left_out;
  for (std::size_t p = 0; p < forwards.points.size(); ++p) {
    const Point &there = forwards.points[p], &back = backwards.points[p];
    const std::string what = forwards.name + ": " + there.name;
    if (what.starts_with("geometry_cache: sinew")) continue;  // frames depend on earlier ones
    EXPECT_NEAR(there.error, back.error, 1e-4 * there.error) << what;
    for (std::size_t v = 0; v < there.values.size() && forwards.size_unit.empty(); ++v)
      EXPECT_NEAR(there.values[v].value, back.values[v].value, 1e-4 * std::abs(there.values[v].value)) << what;
  }
}

TEST(cost_errors, are_the_largest_of_all_moments_in_whatever_order_they_come) {
  const Scene arm = swinging_arm(false), arm_back = swinging_arm(true);
  const Scene face = changing_face(false), face_back = changing_face(true);
  const Subject moving(arm, 0, Effort{}), moving_back(arm_back, 0, Effort{});
  for (const auto study : {cost::study_influences, cost::study_skinning, cost::study_skinned_normals,
                           static_cast<Study (*)(const Subject&)>(cost::study_geometry)})
    expect_same_errors(study(moving).group, study(moving_back).group);
  expect_same_errors(cost::study_morphing(Subject(face, 0, Effort{})).group,
                     cost::study_morphing(Subject(face_back, 0, Effort{})).group);
}

TEST(cost_errors, of_weights_that_move_one_by_one_are_those_of_weights_that_move_together) {
  const Scene together = changing_face(false);
  Scene apart = together;
  const WeightTrack whole = apart.animations[0].weights[0].weights;
  apart.animations[0].weights.clear();
  for (const std::uint32_t t : {0u, 1u})
    apart.animations[0].weights.push_back(
        {0, {whole.interpolation, whole.times_s, {whole.values[t], whole.values[2 + t]}, 1}, t});
  finish_scene(apart);
  const Group one = cost::study_morphing(Subject(together, 0, Effort{})).group,
              other = cost::study_morphing(Subject(apart, 0, Effort{})).group;
  EXPECT_EQ(one.about, other.about);
  expect_same_errors(one, other);
}

TEST(cost_errors, beside_those_of_stored_keys_stand_the_bytes_of_the_file_and_of_memory) {
  const Scene arm = arm_scene();
  const Group group = cost::study_storage(Subject(arm, 0, Effort::quick())).group;
  const Clip clip = compile_clip(arm.animations[0], arm.skeleton, {}, {}, {});
  EXPECT_EQ(group.points.at(0).values.at(1).name, "in memory");
  EXPECT_DOUBLE_EQ(group.points.at(0).values.at(1).value * 1024.0, static_cast<double>(clip.byte_size()));
  EXPECT_NE(group.points.at(0).values.at(0).value, group.points.at(0).values.at(1).value);
}

TEST(cost_errors, tracks_that_never_turn_do_not_say_what_is_usual) {
  Scene arm = arm_scene();
  BoneAnimation still;
  still.rotation = {Interpolation::step, {0.0f, 1.0f}, {about_z(0), about_z(0)}};
  for (const std::uint32_t joint : {0u, 1u}) {
    still.joint = joint;
    arm.animations[0].bones.push_back(still);
  }
  finish_scene(arm);
  for (const Point& point : cost::study_rotation(Subject(arm, 0, Effort::quick())).group.points)
    EXPECT_EQ(point.is_default, point.name == "exact slerp") << point.name;
}

TEST(cost_errors, the_interpolation_of_most_tracks_is_the_usual_one) {
  Scene arm = arm_scene();
  BoneAnimation turning;
  const glm::quat none(0, 0, 0, 0);  // zero tangents
  turning.rotation = {Interpolation::cubic_spline, {0.0f, 1.0f}, {none, about_z(0), none, none, about_z(30), none}};
  for (const std::uint32_t joint : {0u, 1u}) {
    turning.joint = joint;
    arm.animations[0].bones.push_back(turning);
  }
  finish_scene(arm);
  for (const Point& point : cost::study_rotation(Subject(arm, 0, Effort::quick())).group.points)
    EXPECT_EQ(point.is_default, point.name == "cubic") << point.name;
}

/// A measurement file with two trials of the same method at different sample counts, at half size and blurred, and
/// `other`.
nlohmann::json occlusion_with(nlohmann::json other) {
  const nlohmann::json usual{{"name", "24"},    {"note", ""},         {"method", "gtao"},
                             {"samples", 24},   {"full_size", false}, {"blur", true},
                             {"default", true}, {"error", 0.05},      {"milliseconds", {2.0}}};
  nlohmann::json more = usual;
  more.update({{"name", "48"}, {"samples", 48}, {"default", false}, {"error", 0.049}});
  nlohmann::json trials{usual, more};
  if (!other.empty()) {
    nlohmann::json odd = more;
    odd.update({{"name", "odd"}, {"samples", 99}, {"error", 0.001}});
    odd.update(other);
    trials.push_back(odd);
  }
  return {{"device", "a device"}, {"width", 100},         {"height", 50},    {"pixels", 3000},
          {"radius_m", 0.5},      {"error_without", 0.2}, {"trials", trials}};
}

TEST(cost_errors, of_occlusion_weigh_only_what_differs_from_the_usual_in_its_samples) {
  const auto verdict = [](const nlohmann::json& other) {
    return cost::occlusion_group(occlusion_with(other).dump()).findings.back();
  };
  const std::string plain = verdict({});
  EXPECT_THAT(plain, testing::StartsWith("24 samples are worth it here"));
  EXPECT_NE(verdict({{"note", "the same method"}}), plain);
  for (const nlohmann::json& other :
       {nlohmann::json{{"method", "ssao"}}, nlohmann::json{{"full_size", true}}, nlohmann::json{{"blur", false}}})
    EXPECT_EQ(verdict(other), plain) << other;
}

TEST(cost_errors, are_those_of_the_clip_that_was_chosen) {
  Scene arm = arm_scene();
  arm.animations.push_back(arm.animations[0]);
  arm.animations[1].name = "still";
  arm.animations[1].bones[0].rotation = {Interpolation::linear, {0.0f, 1.0f}, {about_z(0), about_z(1)}};
  finish_scene(arm);
  const Effort brief{1, 1e-4, 4, 100};
  const auto show = [](const char*, double) {};
  for (const std::uint32_t clip : {0u, 1u}) {
    const auto groups = cost::make_report({&arm, &arm, &arm}, clip, brief, show).groups;
    for (const Group& group : groups) {
      if (group.name != "rotation" && group.name != "storage") continue;
      EXPECT_THAT(group.about, HasSubstr("the clip \"" + arm.animations[clip].name + "\"")) << group.name;
    }
  }
}

TEST(cost_studies, say_what_a_clip_or_a_skin_lacks) {
  Scene arm = arm_scene();
  arm.meshes[0].primitives[0].normals.clear();
  arm.animations[0].bones[0].rotation.values[1] = arm.animations[0].bones[0].rotation.values[0];
  arm.animations.push_back({"nothing", 1.0, {}, {}});
  finish_scene(arm);
  const auto why = [&](const auto& study, std::uint32_t clip) {
    return study(cost::Subject(arm, clip, cost::Effort::quick())).group.left_out;
  };
  EXPECT_EQ(why(cost::study_skinned_normals, 0), "the largest skinned primitive has no normals");
  EXPECT_THAT(why(cost::study_rotation, 0), HasSubstr("\"bend\" turns no joint from one key to another"));
  EXPECT_EQ(why(cost::study_storage, 0), "");
  EXPECT_THAT(why(cost::study_storage, 1), HasSubstr("\"nothing\" moves no joints"));
}

TEST(cost_occlusion, says_what_went_wrong_with_the_program_that_measures) {
  const cost::Group group = cost::look_at_occlusion({"--no-such-option"});
  EXPECT_EQ(group.name, "occlusion");
  EXPECT_THAT(group.left_out, HasSubstr("sinew-occlusion-study"));
  EXPECT_TRUE(group.points.empty());
}

}  // namespace
}  // namespace sinew::test
