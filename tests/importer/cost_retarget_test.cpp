// SPDX-License-Identifier: MIT
// Retargeting errors that `sinew cost` reports, on a body whose numbers are known by hand.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "importer/tool/cost/other_body.h"
#include "tests/importer/cost_study.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

/// A body that glides half a metre forward in one second, with straight arms and legs.
Scene glider() {
  struct Joint {
    const char* name;
    std::uint32_t parent;
    glm::vec3 place;
  };
  const Joint joints[] = {
      {"Hips", kNone, {0, 1, 0}},       {"Spine", 0, {0, 0.4f, 0}},         {"LeftUpLeg", 0, {0.1f, 0, 0}},
      {"RightUpLeg", 0, {-0.1f, 0, 0}}, {"Neck", 1, {0, 0.2f, 0}},          {"LeftArm", 1, {0.2f, 0, 0}},
      {"RightArm", 1, {-0.2f, 0, 0}},   {"LeftLeg", 2, {0, -0.5f, 0}},      {"RightLeg", 3, {0, -0.5f, 0}},
      {"LeftForeArm", 5, {0.3f, 0, 0}}, {"RightForeArm", 6, {-0.3f, 0, 0}}, {"LeftFoot", 7, {0, -0.4f, 0}},
      {"RightFoot", 8, {0, -0.4f, 0}},  {"LeftHand", 9, {0.3f, 0, 0}},      {"RightHand", 10, {-0.3f, 0, 0}}};
  std::vector<std::uint32_t> parents;
  for (const Joint& joint : joints) parents.push_back(joint.parent);
  Scene scene;
  scene.skeleton = skeleton_of(parents);
  for (std::size_t j = 0; j < std::size(joints); ++j) {
    scene.skeleton.names[j] = joints[j].name;
    scene.skeleton.rest[j].translation = joints[j].place;
  }
  BoneAnimation hips;
  hips.joint = 0;
  hips.translation = {Interpolation::linear, {0, 1}, {{0, 1, 0}, {0, 1, 0.5f}}};
  scene.animations = {{"glide", 1.0, {hips}, {}}};
  finish_scene(scene);
  return scene;
}

TEST(cost_retargeting, the_other_body_has_other_proportions_and_stands_on_the_same_ground) {
  const Scene scene = glider();
  const auto body = cost::other_body(scene.skeleton);
  ASSERT_TRUE(body);
  EXPECT_THAT(body->hands, ElementsAre(13u, 14u));
  EXPECT_THAT(body->feet, ElementsAre(11u, 12u));
  EXPECT_FLOAT_EQ(body->skeleton.rest[9].translation.x, 0.3f * 0.75f * 1.1f);
  EXPECT_FLOAT_EQ(body->skeleton.rest[7].translation.y, -0.5f * 0.75f * 0.9f);
  EXPECT_FLOAT_EQ(body->skeleton.rest[4].translation.y, 0.2f * 0.75f);
  EXPECT_NEAR(body->skeleton.rest[0].translation.y, 0.1 + 0.9 * 0.75 * 0.9, 1e-6) << "feet at 0.1 m as before";
}

TEST(cost_retargeting, both_sides_of_the_other_body_are_alike) {
  const Scene scene = glider();
  const auto body = cost::other_body(scene.skeleton);
  ASSERT_TRUE(body);
  for (std::size_t left = 5; left < 15; left += 2) {
    const glm::vec3 &l = body->skeleton.rest[left].translation, &r = body->skeleton.rest[left + 1].translation;
    EXPECT_EQ(l, glm::vec3(-r.x, r.y, r.z)) << scene.skeleton.names[left];
  }
}

TEST(cost_retargeting, errors_of_a_gliding_body_follow_from_the_rule_for_its_hips) {
  const Scene scene = glider();
  const Study study = cost::study_retargeting(Subject(scene, 0, Effort::quick()));
  const Group& group = study.group;
  EXPECT_EQ(group.left_out, "");
  // The hips are 0.9 m above the feet, and 0.6075 m on the other body: the path is scaled by 0.675.
  const double path = 500.0 * 0.675;
  const double by_length = 500.0 * (0.1 + 0.6075), copied = 500.0;  // the bone of the hips begins at the ground
  const std::map<std::string, double> expected = {{"hips by height", 0.0},
                                                  {"hips by height, held feet", 0.0},
                                                  {"by length", by_length - path},
                                                  {"keep", path},
                                                  {"plain copy", copied - path}};
  std::map<std::string, const Point*> points;
  for (const Point& point : group.points) points[point.name] = &point;
  ASSERT_EQ(points.size(), 7u);
  for (const auto& [name, error] : expected) {
    const Point& point = *points.at(name);
    EXPECT_NEAR(point.error, error, 0.01) << name;
    // A copy also lifts the hips by the difference in height. A foot that stays too high does not slide.
    const double off = name == "plain copy" ? std::hypot(error, 1000.0 - 707.5) : error;
    EXPECT_NEAR(point.values[0].value, off, 0.01) << name << ", hands";
    EXPECT_NEAR(point.values[1].value, off, 0.01) << name << ", feet";
  }
  EXPECT_LT(points.at("by length, held feet")->error, 0.01) << "the feet do not slide, the hands do";
  EXPECT_NEAR(points.at("by length, held feet")->values[0].value, by_length - path, 0.01);
  EXPECT_TRUE(points.at("plain copy")->other_aim);
  EXPECT_TRUE(points.at("hips by height")->is_default);
  for (const cost::Work& work : study.works) {
    EXPECT_EQ(work.item_count, 16u * 15u) << "poses and joints";
    work.run();
  }
}

TEST(cost_retargeting, a_joint_that_carries_the_whole_body_goes_with_it) {
  const Scene plain = glider();
  Scene scene;
  std::vector<std::uint32_t> parents = {kNone};
  for (const std::uint32_t parent : plain.skeleton.parents) parents.push_back(parent == kNone ? 0 : parent + 1);
  scene.skeleton = skeleton_of(parents);
  scene.skeleton.names[0] = "root";
  for (std::size_t j = 0; j < plain.skeleton.names.size(); ++j) {
    scene.skeleton.names[j + 1] = plain.skeleton.names[j];
    scene.skeleton.rest[j + 1] = plain.skeleton.rest[j];
  }
  BoneAnimation root;
  root.joint = 0;
  root.translation = {Interpolation::linear, {0, 1}, {{0, 0, 0}, {0, 0, 0.5f}}};
  scene.animations = {{"glide", 1.0, {root}, {}}};
  finish_scene(scene);
  const Group group = cost::study_retargeting(Subject(scene, 0, Effort::quick())).group;
  ASSERT_EQ(group.left_out, "");
  const auto point =
      std::find_if(group.points.begin(), group.points.end(), [](const Point& p) { return p.name == "hips by height"; });
  ASSERT_NE(point, group.points.end());
  EXPECT_NEAR(point->error, 0.0, 0.01) << "the root is carried on, scaled";
}

TEST(cost_retargeting, what_is_no_human_body_or_has_no_clip_is_left_out) {
  Scene scene = glider();
  EXPECT_THAT(cost::study_retargeting(Subject(scene, kNone, Effort::quick())).group.left_out, HasSubstr("no clip"));
  scene.skeleton.names[13] = "Hook";
  const Group group = cost::study_retargeting(Subject(scene, 0, Effort::quick())).group;
  EXPECT_THAT(group.left_out, HasSubstr("human body"));
  EXPECT_TRUE(group.points.empty());
}

TEST(cost_retargeting, its_findings_put_the_numbers_into_words) {
  const Scene scene = glider();
  const Study study = cost::study_retargeting(Subject(scene, 0, Effort::quick()));
  Group group = study.group;
  for (Point& point : group.points) {
    point.time_ns = point.name == "plain copy" ? 0.5 : point.name.ends_with("held feet") ? 3.0 : 2.0;
    point.error = point.name == "hips by height" ? 25.0 : 1.0;
  }
  EXPECT_THAT(study.findings(group),
              ElementsAre("A pose on another body takes 2.00 ns a joint, 4.00 times a plain copy of its numbers; "
                          "holding the feet costs 1.00 ns a joint more.",
                          "Feet on the ground stray up to 25 mm from the source's paths, scaled by heights, and 1 mm "
                          "when they are held."));
}

}  // namespace
}  // namespace sinew::test
