// SPDX-License-Identifier: MIT
// The first screen of `sinew cost`: the frame's parts, the choices that are shown, and the command that they lead to.
#include "importer/tool/cost/overview/choices.h"

#include <limits>
#include <numeric>

#include "importer/tool/cost/overview/frame_parts.h"
#include "importer/tool/cost/overview/make_overview.h"
#include "importer/tool/cost/report_json.h"
#include "tests/importer/cost_study.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {
using cost::Choice;
using cost::FramePart;

constexpr double kSize_m = 2.0;  // 0.2 mm is a ten-thousandth of it, 2 mm a thousandth

Point way(const char* name, double error, double time_ns) {
  Point point;
  point.name = name;
  point.error = error;
  point.time_ns = time_ns;
  point.pareto = true;
  return point;
}

Group group_of(const char* name, const char* error_unit, std::vector<Point> points) {
  Group group;
  group.name = name;
  group.error_unit = error_unit;
  group.points = std::move(points);
  group.points.front().is_default = true;
  return group;
}

Group skinning_apart_by(double mm) {
  Group group = group_of("skinning", "%", {way("linear", 25.0, 4.0), way("dual quaternion", 0.2, 5.0)});
  group.points[1].values = {{"apart from linear here", mm, "mm"}};
  return group;
}

Group storage_with_error(double mm) {
  Group group = group_of("storage", "mm", {way("keys as they are", 0.0, 3.0), way("budget 0.1 mm", mm, 6.0)});
  group.size_unit = "bytes";
  group.points[0].size = 500.0;
  group.points[1].size = 100.0;
  return group;
}

const std::vector<FramePart> kParts = {{cost::kSamplePart, 3.0}, {cost::kSkinPart, 8.0}};

TEST(cost_choices, change_their_part_of_the_frame_as_their_group_changes) {
  const std::vector<Group> groups = {skinning_apart_by(0.5), storage_with_error(0.1)};
  const std::vector<Choice> choices = cost::find_choices(groups, kParts, kSize_m);
  ASSERT_EQ(choices.size(), 2u);
  EXPECT_EQ(choices[0].group, "skinning");
  EXPECT_DOUBLE_EQ(choices[0].us_change, 8.0 * 0.25);
  EXPECT_EQ(choices[0].error_unit, "% of a limb's volume");
  EXPECT_EQ(choices[1].group, "storage");
  EXPECT_DOUBLE_EQ(choices[1].us_change, 3.0);
  EXPECT_DOUBLE_EQ(choices[1].size_ratio.value(), 0.2);
  EXPECT_DOUBLE_EQ(choices[1].budget.value(), 0.005) << "0.1 mm of 2 m";
  EXPECT_DOUBLE_EQ(choices[1].error_other, 0.005) << "0.1 mm of 2 m, in percent";
}

TEST(cost_choices, take_dual_quaternions_where_the_kinds_differ_by_more_than_a_thousandth_of_the_model) {
  const auto takes = [](double apart_mm) {
    const std::vector<Group> groups = {skinning_apart_by(apart_mm)};
    return cost::find_choices(groups, kParts, kSize_m)[0];
  };
  EXPECT_FALSE(takes(2.0).takes_other);
  EXPECT_THAT(takes(2.0).why, HasSubstr("at most 0.100 % of the model"));
  EXPECT_TRUE(takes(2.01).takes_other);
}

TEST(cost_choices, take_the_smallest_budget_that_is_hardly_seen) {
  std::vector<Group> groups = {storage_with_error(0.2)};
  groups[0].points.push_back(way("budget 1 mm", 0.21, 6.0));
  groups[0].points.back().size = 50.0;
  EXPECT_TRUE(cost::find_choices(groups, kParts, kSize_m)[0].takes_other);
  EXPECT_EQ(cost::find_choices(groups, kParts, kSize_m)[0].other, "budget 0.1 mm");
  groups[0].points[1].error = 0.21;
  EXPECT_TRUE(cost::find_choices(groups, kParts, kSize_m).empty()) << "no budget is left, and no way to compare with";
  groups[0].points.push_back(way("16 bits", 0.3, 6.0));
  groups[0].points.back().size = 60.0;
  const Choice kept = cost::find_choices(groups, kParts, kSize_m)[0];
  EXPECT_EQ(kept.other, "16 bits");
  EXPECT_FALSE(kept.takes_other);
}

TEST(cost_choices, show_of_all_others_the_one_that_changes_the_frame_most) {
  std::vector<Group> groups = {group_of("rotation", "mm", {way("exact slerp", 0.0, 2.0), way("nlerp", 0.1, 1.0)}),
                               group_of("influences", "mm", {way("all", 0.0, 4.0), way("one", 9.0, 3.0)})};
  EXPECT_EQ(cost::find_choices(groups, kParts, kSize_m)[0].group, "influences") << "2 us of skinning, 1.5 of sampling";
  EXPECT_FALSE(cost::find_choices(groups, kParts, kSize_m)[0].takes_other) << "9 mm are seen";
  groups[1].points[1].time_ns = 3.9;
  const Choice rotation = cost::find_choices(groups, kParts, kSize_m)[0];
  EXPECT_EQ(rotation.group, "rotation");
  EXPECT_TRUE(rotation.takes_other);
  EXPECT_DOUBLE_EQ(rotation.us_change, -1.5);
}

TEST(cost_choices, lead_to_a_command_with_a_budget_in_percent_of_the_model) {
  const std::vector<Group> groups = {skinning_apart_by(5.0), storage_with_error(0.1)};
  const auto choices = cost::find_choices(groups, kParts, kSize_m);
  EXPECT_EQ(cost::recommended_command(choices, groups, "a b/fox.glb"),
            "sinew compile 'a b/fox.glb' --budget 0.00500% -o fox.sinew\n"
            "sinew-viewer fox.sinew --skinning dual-quaternion");
  EXPECT_EQ(cost::recommended_command({}, {}, "fox.glb"), "sinew compile fox.glb --budget 0 -o fox.sinew");
}

TEST(cost_frame, has_the_stages_that_run_and_no_others) {
  const Scene arm = arm_scene();
  const std::vector<FramePart> parts = cost::evaluation_parts(arm, 0, Effort::quick());
  std::vector<std::string> names;
  for (const FramePart& part : parts) {
    names.push_back(part.name);
    EXPECT_GT(part.us, 0.0) << part.name;
    EXPECT_LT(part.us, 1e5) << part.name;
  }
  EXPECT_THAT(names, testing::IsSupersetOf({cost::kSamplePart, "joint matrices", cost::kSkinPart}));
  EXPECT_THAT(names, testing::Not(testing::Contains(cost::kMorphPart)));
  EXPECT_TRUE(cost::evaluation_parts(arm, kNone, Effort::quick()).empty());
}

TEST(cost_frame, joins_passes_of_the_live_plan_and_leaves_out_the_rest) {
  const std::vector<FramePart> parts = cost::drawing_parts(
      "evaluation, on the CPU\n"
      "  sample                   on          21        6.9 us  3 clips\n"
      "\n"
      "drawing, on the CPU\n"
      "  upload                   on           1        6.5 us  41472 bytes\n"
      "modes of the picture\n"
      "  samples                  on           4                edges are smooth\n"
      "passes, on the GPU\n"
      "  ssao                     on       27650       20.0 us  ambient occlusion is on\n"
      "  blur_vertical            on       27650        5.0 us  smooths 8 us\n"
      "  outline                  off          0                outlines are part of Gooch shading\n"
      "  ground                   on           1        3.0 us  darkens what is behind\n");
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].name, "upload");
  EXPECT_DOUBLE_EQ(parts[0].us, 6.5);
  EXPECT_EQ(parts[1].name, "ambient occlusion");
  EXPECT_DOUBLE_EQ(parts[1].us, 25.0);
  EXPECT_EQ(parts[2].name, "ground");
  EXPECT_TRUE(cost::drawing_parts("").empty());
}

TEST(cost_overview, says_why_nothing_is_drawn_and_where_the_unit_is_odd) {
  Scene arm = arm_scene();
  const Subject metres(arm, 0, Effort::quick());
  const cost::Overview builtin = cost::make_overview({}, metres, "");
  EXPECT_FALSE(builtin.odd_unit);
  EXPECT_EQ(builtin.command, "");
  EXPECT_EQ(builtin.not_drawn, "this is a built-in scene");
  const cost::Overview missing = cost::make_overview({}, metres, "no such file.glb");
  EXPECT_NE(missing.not_drawn, "") << "no viewer is beside the tests, or it does not find the file";
  for (Primitive& primitive : arm.meshes[0].primitives)
    for (glm::vec3& position : primitive.positions) position *= 100.0f;
  EXPECT_TRUE(cost::make_overview({}, Subject(arm, 0, Effort::quick()), "").odd_unit);
}

TEST(cost_overview, has_its_pictures_on_the_page_and_not_in_the_json_file) {
  cost::Report report;
  report.overview.emplace().choices.push_back({.group = "skinning", .picture = "PNG"});
  EXPECT_THAT(cost::report_json(report).dump(), testing::Not(HasSubstr("UE5H")));
  EXPECT_THAT(cost::report_page(report), HasSubstr("data:image/png;base64,UE5H"));
}

}  // namespace
}  // namespace sinew::test
