// SPDX-License-Identifier: MIT
// `sinew cost` as its users see it: errors of known size, the files it writes, and inputs it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "importer/tool/cost/occlusion_group.h"
#include "importer/tool/cost/report_json.h"
#include "importer/tool/cost/run_beside.h"
#include "importer/tool/cost/studies.h"
#include "importer/tool/cost/write_report.h"
#include "runtime/clip/clip_file.h"
#include "runtime/math/interpolate.h"
#include "tests/importer/tool_model.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/file_text.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

const cost::Point& point_named(const cost::Group& group, const std::string& name) {
  for (const cost::Point& point : group.points)
    if (point.name == name) return point;
  throw std::runtime_error("no point " + name);
}

TEST(cost_studies, N04_nlerp_loses_what_its_closed_form_says) {
  const Scene arm = arm_scene();  // a quarter turn between two keys; the farthest vertex is a metre from the joint
  const cost::Subject subject(arm, 0, cost::Effort::quick());
  const cost::Study study = cost::study_rotation(subject);
  constexpr double kWorst = 0.919 * 0.017453292519943295;
  const cost::Point& nlerp = point_named(study.group, "nlerp");
  EXPECT_NEAR(nlerp.values[0].value, kWorst, 0.002 * kWorst);
  EXPECT_NEAR(nlerp.error, 1e3 * 2.0 * std::sin(0.5 * kWorst), 0.04);
  EXPECT_NEAR(point_named(study.group, "corrected nlerp").values[0].value, 0.003 * 0.01745, 3e-5);
  for (const char* exact : {"exact slerp", "polynomial slerp", "incremental slerp"})
    EXPECT_LT(point_named(study.group, exact).error, 1e-3) << exact;
  EXPECT_NEAR(point_named(study.group, "step").values[0].value, 0.7887 * 1.5707963, 1e-3)
      << "at the last moment looked at";
  EXPECT_TRUE(point_named(study.group, "exact slerp").is_default);
}

TEST(cost_studies, cubic_files_are_compared_with_their_own_curve) {
  Scene arm = arm_scene();
  QuatTrack& track = arm.animations[0].bones[0].rotation;
  const glm::quat none(0.0f, 0.0f, 0.0f, 0.0f), first = track.values[0], second = track.values[1];
  track = {Interpolation::cubic_spline, track.times_s, {none, first, none, none, second, none}};
  const cost::Subject subject(arm, 0, cost::Effort::quick());
  const cost::Study study = cost::study_rotation(subject);
  EXPECT_TRUE(point_named(study.group, "cubic").is_default);
  EXPECT_LT(point_named(study.group, "cubic").error, 1e-3);
  EXPECT_GT(point_named(study.group, "exact slerp").error, 10.0) << "ease in and out is not slerp";
  EXPECT_FALSE(point_named(study.group, "cubic").other_aim);
}

TEST(cost_studies, resampling_between_keys_loses_a_straight_line_nothing_and_a_corner_something) {
  Scene arm = arm_scene();
  arm.animations[0].bones[0].rotation = {};
  arm.animations[0].bones[0].translation = {
      Interpolation::linear, {0.0f, 0.49f, 1.0f}, {{0, 1, 0}, {1, 1, 0}, {0, 1, 0}}};
  arm.clips[0] = compile_clip(arm.animations[0], arm.skeleton, {}, {}, {});
  const cost::Subject subject(arm, 0, cost::Effort::quick());
  const cost::Study study = cost::study_storage(subject);
  EXPECT_LT(point_named(study.group, "keys as they are").error, 1e-3);
  // At 24 Hz there are keys at 11/24 and 12/24. The corner at 0.49 is cut by less than the motion between these keys.
  const double cut = point_named(study.group, "24 Hz").error;
  EXPECT_GT(cut, 1.0);
  EXPECT_LT(cut, 1e3 / 24.0 / 0.49);
  EXPECT_GT(*point_named(study.group, "120 Hz").size, *point_named(study.group, "24 Hz").size);
}

TEST(cost_studies, clips_within_a_budget_keep_it_and_are_smaller) {
  Scene arm = arm_scene();
  QuatTrack& track = arm.animations[0].bones[0].rotation;
  const QuatTrack ends = track;
  track.times_s.clear();
  track.values.clear();
  for (int k = 0; k <= 100; ++k) {  // keys on the slerp between the end keys, so that the end keys suffice
    track.times_s.push_back(static_cast<float>(k) / 100.0f);
    track.values.push_back(
        glm::quat(slerp_short_arc(quat_cast<double>(ends.values[0]), quat_cast<double>(ends.values[1]), k / 100.0)));
  }
  const cost::Subject subject(arm, 0, cost::Effort::quick());
  const cost::Study study = cost::study_storage(subject);
  const cost::Point& whole = study.group.points[0];
  double before = *whole.size;
  for (const auto& [name, budget_mm] :
       {std::pair("budget 10 um", 0.01), std::pair("budget 0.1 mm", 0.1), std::pair("budget 1 mm", 1.0)}) {
    const cost::Point& point = point_named(study.group, name);
    EXPECT_LE(point.error, budget_mm) << name;
    EXPECT_LT(*point.size, 0.5 * *whole.size) << name;
    EXPECT_LE(*point.size, before) << name;
    before = *point.size;
  }
  EXPECT_DOUBLE_EQ(whole.values[0].value * 1024.0,
                   static_cast<double>(saved_bytes(compile_clip(arm.animations[0], arm.skeleton, {}, {}, {}))));
  EXPECT_DOUBLE_EQ(*whole.size, whole.values[0].value * 1024.0 / arm.animations[0].duration_s);
}

TEST(cost_studies, keys_in_fewer_bits_are_smaller_and_farther_off_by_what_bits_are_worth) {
  Scene arm = arm_scene();
  arm.animations[0].bones[0].rotation = {};
  Vec3Track& track = arm.animations[0].bones[0].translation;
  track = {Interpolation::linear, {}, {}};
  for (int k = 0; k <= 200; ++k) {
    track.times_s.push_back(static_cast<float>(k) / 200.0f);
    const double x = k;
    track.values.push_back(glm::vec3(std::sin(x), std::cos(x), std::sin(2.0 * x)));
  }
  arm.clips[0] = compile_clip(arm.animations[0], arm.skeleton, {}, {}, {});
  const cost::Study study = cost::study_storage(cost::Subject(arm, 0, cost::Effort::quick()));
  double before = *study.group.points[0].size;
  for (const auto& [name, bits] : {std::pair("16 bits", 16), std::pair("12 bits", 12), std::pair("8 bits", 8)}) {
    const cost::Point& point = point_named(study.group, name);
    const double half_step_mm = 1e3 * 0.5 * 2.0 / std::exp2(bits);
    EXPECT_LE(point.error, 1.2 * std::sqrt(3.0) * half_step_mm) << name;
    EXPECT_GE(point.error, 0.8 * half_step_mm) << name << ": no bit too many";
    EXPECT_LT(*point.size, before) << name;
    before = *point.size;
  }
}

TEST(cost_studies, keys_of_curves_are_not_rounded) {
  Scene arm = arm_scene();
  QuatTrack& track = arm.animations[0].bones[0].rotation;
  const glm::quat none(0.0f, 0.0f, 0.0f, 0.0f), first = track.values[0], second = track.values[1];
  track = {Interpolation::cubic_spline, track.times_s, {none, first, none, none, second, none}};
  const cost::Study study = cost::study_storage(cost::Subject(arm, 0, cost::Effort::quick()));
  EXPECT_TRUE(std::none_of(study.group.points.begin(), study.group.points.end(),
                           [](const cost::Point& p) { return p.name == "16 bits"; }));
}

TEST(cost_studies, one_influence_puts_a_shared_vertex_where_its_heaviest_joint_does) {
  const Scene arm = arm_scene();
  const cost::Subject subject(arm, 0, cost::Effort::quick());
  const cost::Study study = cost::study_influences(subject);
  EXPECT_LT(point_named(study.group, "all influences").error, 1e-3);
  // The vertices at (+-0.25, 1) are half and half. The last pose turns by 15/16 of a quarter turn: half its chord at
  // 0.25 m.
  EXPECT_NEAR(point_named(study.group, "one influence").error, 1e3 * 0.25 * std::sin(0.5 * 15.0 / 16.0 * 1.5707963),
              0.1);
}

TEST(cost_studies, dual_quaternions_keep_the_volume_that_linear_blending_loses) {
  const Scene arm = arm_scene();
  const cost::Study study = cost::study_skinning(cost::Subject(arm, 0, cost::Effort::quick()));
  EXPECT_GT(point_named(study.group, "linear").error, 15.0);
  EXPECT_LT(point_named(study.group, "dual quaternion").error, 1.0);
  EXPECT_LT(point_named(study.group, "center of rotation").error, 1.0);
}

TEST(cost_studies, normals_of_a_stretched_joint_need_the_cofactor_rule) {
  Scene arm = arm_scene();
  arm.animations[0].bones[0].scale = {Interpolation::step, {0.0f}, {{1.0f, 1.0f, 2.0f}}};
  const float half = std::sqrt(0.5f);
  arm.meshes[0].primitives[0].normals[1] = {0.0f, half, half};  // the others stay along the stretched axis
  const cost::Study study = cost::study_skinned_normals(cost::Subject(arm, 0, cost::Effort::quick()));
  constexpr double kOff = 36.86989764584402;  // from (0, 1, 1/2), which is right, to (0, 1, 2)
  EXPECT_NEAR(point_named(study.group, "blended matrix").error, kOff, 1e-4);
  EXPECT_NEAR(point_named(study.group, "blended matrix").values[0].value, kOff / 4.0, 1e-4);
  EXPECT_LT(point_named(study.group, "cofactor matrix").error, 1e-4);
}

TEST(cost_studies, thresholds_of_morph_weights_lose_what_they_leave_out) {
  Scene face = face_scene();
  face.animations[0].weights[0].weights.values = {0.0f, 0.04f, 0.0f, 0.04f};  // "spread" moves two vertices by a metre
  const cost::Study study = cost::study_morphing(cost::Subject(face, 0, cost::Effort::quick()));
  const auto off_mm = [&](const char* name) { return point_named(study.group, name).values[0].value; };
  for (const char* exact : {"all targets", "active targets", "weights from 0.01"})
    EXPECT_LT(off_mm(exact), 1e-3) << exact;
  EXPECT_NEAR(off_mm("weights from 0.05"), 40.0, 1e-3);
}

TEST(cost_studies, normals_not_made_unit_again_count_as_wrong) {
  Scene face = face_scene();
  face.animations[0].weights[0].weights.values = {1.0f, 0.0f, 1.0f, 0.0f};  // "lift" adds a unit vector to a normal
  const cost::Study study = cost::study_morphing(cost::Subject(face, 0, cost::Effort::quick()));
  EXPECT_LT(point_named(study.group, "active targets").error, 1e-4);
  // A normal of length sqrt(2) instead of 1 counts as the angle of that chord.
  EXPECT_NEAR(point_named(study.group, "normals as summed").error,
              2.0 * 57.29578 * std::asin(0.5 * (std::sqrt(2.0) - 1.0)), 1e-3);
}

TEST(cost_studies, say_why_they_have_nothing_to_say) {
  const Scene prop = prop_scene();
  const cost::Subject subject(prop, kNone, cost::Effort::quick());
  for (const auto study : {cost::study_rotation, cost::study_storage, cost::study_influences, cost::study_skinning,
                           cost::study_skinned_normals, cost::study_morphing}) {
    const cost::Study nothing = study(subject);
    EXPECT_FALSE(nothing.group.left_out.empty()) << nothing.group.name;
    EXPECT_TRUE(nothing.group.points.empty() && nothing.works.empty()) << nothing.group.name;
  }
  EXPECT_FALSE(cost::study_arithmetic(subject).group.points.empty()) << "skins a limb of its own";
}

/// Output of the measuring program: up to 14 samples the error falls; the time always rises.
std::string occlusion_answer() {
  Json trials = Json::array();
  const auto add = [&](const char* name, int samples, bool full, bool blur, double error, double ms) {
    trials.push_back({{"name", name},
                      {"note", "as said"},
                      {"method", std::string(name).find("slice") == std::string::npos ? "ssao" : "gtao"},
                      {"samples", samples},
                      {"full_size", full},
                      {"blur", blur},
                      {"default", std::string(name) == "2 slices of 12"},
                      {"error", error},
                      {"milliseconds", {ms, 1.01 * ms, 0.99 * ms}}});
  };
  add("14 samples", 14, false, true, 0.065, 1.9);
  add("64 samples", 64, false, true, 0.03, 6.0);
  add("1 slice of 8", 8, false, true, 0.08, 1.0);
  add("2 slices of 12", 24, false, true, 0.05, 2.0);
  add("8 slices of 16", 128, false, true, 0.049, 6.0);
  add("2 slices of 12 full size", 24, true, true, 0.048, 8.0);
  add("2 slices of 12 no blur", 24, false, false, 0.07, 1.2);
  return Json{{"device", "a device"}, {"width", 100},         {"height", 50},    {"pixels", 3000},
              {"radius_m", 0.5},      {"error_without", 0.2}, {"trials", trials}}
      .dump();
}

TEST(cost_occlusion, says_how_many_samples_are_worth_it_and_on_what_device) {
  const cost::Group group = cost::occlusion_group(occlusion_answer());
  ASSERT_EQ(group.points.size(), 7u) << group.left_out;
  EXPECT_DOUBLE_EQ(point_named(group, "2 slices of 12").error, 5.0);
  EXPECT_DOUBLE_EQ(point_named(group, "2 slices of 12").time_ns, 2e6 / 5000.0);
  EXPECT_DOUBLE_EQ(point_named(group, "2 slices of 12").values[0].value, 2.0);
  EXPECT_TRUE(point_named(group, "2 slices of 12").is_default && point_named(group, "2 slices of 12").pareto);
  EXPECT_TRUE(point_named(group, "2 slices of 12 no blur").pareto);
  EXPECT_THAT(group.findings.front(),
              testing::AllOf(HasSubstr("20.0 %"), HasSubstr("5.0 %"), HasSubstr("2 ms"), HasSubstr("a device")));
  EXPECT_THAT(group.findings[1], HasSubstr("14 of them, leave 6.5 %"));
  EXPECT_THAT(group.findings[2], HasSubstr("4.8 %"));
  EXPECT_THAT(group.findings[3], HasSubstr("7.0 %"));
  EXPECT_THAT(group.findings.back(), HasSubstr("24 samples are worth it here: they leave 5.0 %, any number up to 128"));
  EXPECT_THAT(group.findings.back(), HasSubstr("3.00 times as long"));
  EXPECT_THAT(group.about, HasSubstr("3000 pixels"));
}

TEST(cost_occlusion, says_why_it_has_nothing_to_say) {
  EXPECT_EQ(cost::occlusion_group(R"({"left_out": "there is no Vulkan device: none fits"})").left_out,
            "there is no Vulkan device: none fits");
  EXPECT_THAT(cost::occlusion_group(R"({"device": )").left_out, HasSubstr("did not finish"));
  Json without_clock = Json::parse(occlusion_answer());
  for (Json& trial : without_clock["trials"]) trial["milliseconds"] = Json::array();
  const cost::Group group = cost::occlusion_group(without_clock.dump());
  EXPECT_THAT(group.left_out, HasSubstr("no clock"));
  EXPECT_TRUE(group.points.empty());
  without_clock = Json::parse(occlusion_answer());
  without_clock["trials"].back()["milliseconds"] = Json::array();
  EXPECT_TRUE(cost::occlusion_group(without_clock.dump()).points.empty()) << "those before it do not stay";
}

TEST(run_beside, hands_over_what_a_program_prints_and_says_what_went_wrong) {
  const auto missing = cost::output_of_program_beside("no-such-program", {});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error(), HasSubstr("no program no-such-program"));
  const std::string beside = "../../../../../../../../../../../bin/";  // path from the test program to /bin
  EXPECT_EQ(cost::output_of_program_beside(beside + "echo", {"two words", "$HOME"}).value_or("nothing"),
            "two words $HOME\n");
  EXPECT_THAT(cost::output_of_program_beside(beside + "false", {}).error(), HasSubstr("ended with status 1"));
  EXPECT_EQ(cost::output_of_program_beside(beside + "seq", {"100000"}).value_or("").size(), 588895u)
      << "more than a pipe holds";
}

cost::Report small_report() {
  cost::Report report;
  report.subject = "a \"quoted\" </script><!-- name";
  report.machine = {{"processor", "one"}};
  report.command = "sinew cost";
  cost::Group group;
  group.name = "rotation";
  group.title = "Rotation";
  group.question = "Which?";
  group.error_unit = "mm";
  group.item = "joint";
  cost::Point point;
  point.name = "slow, but \"exact\"";
  point.error = std::numeric_limits<double>::infinity();
  point.time_ns = 2.5;
  point.values = {{"angle", 0.5, "rad"}};
  group.points = {point, point};
  report.groups = {group};
  return report;
}

TEST(cost_report, page_holds_the_report_whatever_the_names_are) {
  const std::string page = cost::report_page(small_report());
  const std::string open = "<script type=\"application/json\" id=\"report\">";
  const std::size_t begin = page.find(open) + open.size();
  const Json inside = Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(inside["subject"], small_report().subject);
  EXPECT_TRUE(inside["groups"][0]["points"][0]["error"].is_null()) << "JSON has no infinity";
  EXPECT_EQ(page.find("@REPORT@"), std::string::npos);
}

TEST(cost_report, page_needs_nothing_from_elsewhere) {
  const std::string page = cost::report_page(small_report());
  for (const char* outside : {"src=", "<link", "@import", "url(", "fetch(", "https://"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(cost_report, csv_quotes_what_has_commas) {
  EXPECT_THAT(cost::report_csv(small_report()), HasSubstr("rotation,\"slow, but \"\"exact\"\"\",inf,mm,2.5,ns/joint,"));
}

TEST(cost_report, csv_has_each_number_in_the_column_of_its_name) {
  cost::Report report = small_report();
  cost::Group& group = report.groups[0];
  group.size_unit = "bytes";
  group.points.assign(
      4,
      {"slow", 0.5, 2.5, 0.25, false, false, false, true, 64.0, {{"angle", 0.5, "rad"}, {"joints", 3, ""}}, "a note"});
  for (const std::size_t i : {1u, 2u, 3u}) group.points[i].pareto = false;
  group.points[1].noisy = group.points[2].is_default = group.points[3].other_aim = true;
  group.points[3].size.reset();
  const std::string values = "angle=0.5 rad; joints=3,a note\n";
  EXPECT_EQ(
      cost::report_csv(report),
      "group,name,error,error_unit,time,time_unit,spread,noisy,pareto,default,other_aim,size,size_unit,values,note\n"
      "rotation,slow,0.5,mm,2.5,ns/joint,0.25,false,true,false,false,64,bytes," +
          values + "rotation,slow,0.5,mm,2.5,ns/joint,0.25,true,false,false,false,64,bytes," + values +
          "rotation,slow,0.5,mm,2.5,ns/joint,0.25,false,false,true,false,64,bytes," + values +
          "rotation,slow,0.5,mm,2.5,ns/joint,0.25,false,false,false,true,,bytes," + values);
}

/// Runs the command once; all tests check its result.
class CostCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = std::make_unique<ToolModelFile>();
    outcome_ = run_tool({"cost", model_->path(), "--quick", "-o", folder().string()});
  }
  static void TearDownTestSuite() { model_.reset(); }
  static fs::path folder() { return model_->beside("costs"); }
  static std::size_t rows_of_csv() {
    std::istringstream csv(text_of_file(folder() / "report.csv"));
    std::size_t lines = 0;
    for (std::string line; std::getline(csv, line);) ++lines;
    return lines - 1;
  }

  static inline std::unique_ptr<ToolModelFile> model_;
  static inline CommandOutcome outcome_;
};

TEST_F(CostCommand, writes_three_files_and_says_where) {
  ASSERT_EQ(outcome_.status, 0) << outcome_.err;
  EXPECT_THAT(outcome_.out, HasSubstr("report.html"));
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder())) names.insert(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre("report.csv", "report.html", "report.json"));
}

TEST_F(CostCommand, json_has_the_agreed_form) {
  const Json report = Json::parse(text_of_file(folder() / "report.json"));
  EXPECT_TRUE(report["machine"].is_object() && report["machine"].contains("processor"));
  EXPECT_THAT(report["command"].get<std::string>(), HasSubstr("--quick -o "));
  std::set<std::string> names;
  std::size_t points = 0;
  for (const Json& group : report["groups"]) {
    points += group["points"].size();
    names.insert(group["name"]);
    ASSERT_TRUE(group["points"].is_array());
    EXPECT_EQ(group["points"].empty(), group.contains("left_out")) << group["name"];
    int defaults = 0;
    bool any_front = group["points"].empty();
    for (const Json& point : group["points"]) {
      for (const char* number : {"error", "time", "spread"}) EXPECT_TRUE(point[number].is_number()) << number;
      for (const char* text : {"name", "error_unit", "time_unit", "note"}) EXPECT_TRUE(point[text].is_string()) << text;
      for (const char* flag : {"pareto", "default", "noisy", "other_aim"})
        EXPECT_TRUE(point[flag].is_boolean()) << flag;
      EXPECT_GT(point["time"].get<double>(), 0.0) << point["name"];
      EXPECT_EQ(point["noisy"].get<bool>(), point["spread"].get<double>() > report["noisy_from"].get<double>());
      defaults += point["default"].get<bool>() ? 1 : 0;
      any_front = any_front || point["pareto"].get<bool>();
    }
    EXPECT_EQ(defaults, group["points"].empty() ? 0 : 1) << group["name"];
    EXPECT_TRUE(any_front) << group["name"];
    EXPECT_EQ(group["findings"].empty(), group["points"].empty());
  }
  EXPECT_EQ(rows_of_csv(), points) << "CSV has a row for every point";
  EXPECT_THAT(names, testing::IsSupersetOf({"rotation", "storage", "influences", "skinning", "normals", "morphing",
                                            "arithmetic", "retargeting", "geometry_cache", "inverse kinematics",
                                            "springs", "occlusion"}));
}

TEST_F(CostCommand, says_what_it_looked_at_and_how_to_look_again) {
  const Json report = Json::parse(text_of_file(folder() / "report.json"));
  EXPECT_EQ(report["subject"], "model.gltf: 4 joints, 2 clips, 1 skin, 3 m large");
  EXPECT_EQ(report["command"], "sinew cost " + model_->path() + " --quick -o " + folder().string());
  EXPECT_THAT(report["groups"][0]["about"].get<std::string>(), HasSubstr("of the clip \"bend\"")) << "the busiest one";
}

TEST(cost_command, takes_a_geometry_cache_and_compares_the_ways_to_keep_its_frames) {
  const ToolModelFile model;
  const std::string cache = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "--normals", "--budget", "1mm", "-o", cache}).status, 0);
  const fs::path out = model.beside("costs");
  ASSERT_EQ(run_tool({"cost", cache, "--quick", "-o", out.string()}).status, 0);
  const Json report = Json::parse(text_of_file(out / "report.json"));
  ASSERT_EQ(report["groups"].size(), 1u);
  std::map<std::string, Json> points;
  for (const Json& point : report["groups"][0]["points"]) points[point["name"]] = point;
  EXPECT_EQ(points.size(), 9u);
  EXPECT_EQ(points.at("floats")["size"].get<double>(), 12.0);
  EXPECT_EQ(points.at("floats")["error"].get<double>(), 0.0);
  EXPECT_EQ(points.at("halves")["size"].get<double>(), 6.0);
  EXPECT_NEAR(points.at("halves")["error"].get<double>(), 1.0, 0.999) << "some; less than a step of a half at 2 m";
  EXPECT_LE(points.at("sinew 1 mm")["error"].get<double>(), 1.0);
  EXPECT_TRUE(points.at("sinew 1 mm")["default"].get<bool>()) << "the budget that the cache was made with";
  for (const char* exact : {"zstd -19", "meshopt", "zstd -19, residuals", "meshopt, residuals"})
    EXPECT_LE(points.at(exact)["error"].get<double>(), 1.0) << exact << " has the numbers of the cache";
  EXPECT_EQ(run_tool({"cost", cache, "--quick", "--clip", "0", "-o", out.string()}).status, 2);
}

TEST(cost_command, replaces_an_older_report_whole) {
  const ToolModelFile model;
  const fs::path out = model.beside("again/");
  ASSERT_FALSE(cost::write_report(small_report(), out));
  cost::Report other = small_report();
  other.subject = "newer";
  ASSERT_FALSE(cost::write_report(other, out));
  EXPECT_EQ(Json::parse(text_of_file(out / "report.json"))["subject"], "newer");
  for (const auto& entry : fs::directory_iterator(out.parent_path().parent_path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with("again.")) << entry;
}

}  // namespace
}  // namespace sinew::test
