// SPDX-License-Identifier: MIT
// The findings of `sinew cost`: which methods it compares, which is sinew's own, and the sentences made from errors and
// times. The numbers here are invented; cost_report_test.cpp checks real errors.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "importer/tool/bake/bake_scene.h"
#include "importer/tool/cost/limb.h"
#include "importer/tool/cost/occlusion_group.h"
#include "importer/tool/cost/true_pose.h"
#include "tests/importer/cost_study.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {
using testing::StartsWith;

/// Error, time and size of a point, in the units of its group.
struct Cost {
  double error = 0.0, time_ns = 0.0, size = 0.0;
};

/// The findings of a study with these costs; unnamed points cost more than all others.
std::vector<std::string> said(const Study& study, const std::map<std::string, Cost>& costs) {
  Group group = study.group;
  for (Point& point : group.points) {
    const auto found = costs.find(point.name);
    const Cost cost = found == costs.end() ? Cost{1e3, 1e3, 1e3} : found->second;
    point.error = cost.error;
    point.time_ns = cost.time_ns;
    if (point.size) point.size = cost.size;
  }
  return study.findings(group);
}

std::vector<std::string> names(const Group& group) {
  std::vector<std::string> out;
  for (const Point& point : group.points) out.push_back(point.name + (point.is_default ? " *" : ""));
  return out;
}

/// An arm with three keys, so that every storage method applies.
Scene arm() {
  Scene scene = arm_scene();
  scene.animations[0].name = "wave";
  return scene;
}

TEST(cost_findings, every_group_has_a_name_of_its_own_and_says_what_it_measured) {
  const Scene scene = arm(), face = face_scene();
  const Subject moving(scene, 0, Effort::quick()), morphed(face, 0, Effort::quick());
  std::set<std::string> seen;
  for (const Study& study :
       {cost::study_rotation(moving), cost::study_storage(moving), cost::study_influences(moving),
        cost::study_skinning(moving), cost::study_skinned_normals(moving), cost::study_morphing(morphed),
        cost::study_arithmetic(moving), cost::study_geometry(moving)}) {
    const Group& group = study.group;
    EXPECT_TRUE(seen.insert(group.name).second) << group.name;
    for (const std::string& text :
         {group.name, group.title, group.question, group.about, group.error_name, group.error_unit, group.item})
      EXPECT_FALSE(text.empty()) << group.name;
    EXPECT_EQ(group.left_out, "");
    EXPECT_EQ(group.points.size(), study.works.size());
    EXPECT_EQ(std::count_if(group.points.begin(), group.points.end(), [](const Point& p) { return p.is_default; }), 1)
        << group.name;
    for (const Point& point : group.points) {
      EXPECT_FALSE(point.note.empty()) << group.name << ": " << point.name;
      EXPECT_EQ(point.size.has_value(), !group.size_unit.empty()) << point.name;
    }
  }
  EXPECT_THAT(seen, ElementsAre("arithmetic", "geometry_cache", "influences", "morphing", "normals", "rotation",
                                "skinning", "storage"));
}

TEST(cost_findings, errors_that_are_rounding_count_as_equal) {
  const Scene scene = arm();
  const Subject subject(scene, 0, Effort::quick());
  for (const Study& study : {cost::study_rotation(subject), cost::study_storage(subject)})
    for (const Point& point : study.group.points)
      if (point.is_default) {
        EXPECT_GT(point.error, 0.0);
        EXPECT_DOUBLE_EQ(study.group.rounding, 1.5 * point.error) << study.group.name;
      }
}

TEST(cost_findings, of_rotations) {
  const Scene scene = arm();
  const Study study = cost::study_rotation(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("step", "nlerp", "corrected nlerp", "polynomial slerp",
                                              "incremental slerp", "exact slerp *", "squad", "cubic"));
  EXPECT_THAT(study.group.about, StartsWith("1 rotation tracks of the clip \"wave\", every variant"));
  const std::map<std::string, Cost> dear{{"exact slerp", {5e-4, 10.0}}, {"nlerp", {25.0, 4.0}}};
  const auto keep = said(study, dear);
  ASSERT_EQ(keep.size(), 4u);
  EXPECT_EQ(keep[0],
            "Exact slerp, what the file asks for and sinew plays, takes 10.0 ns a joint and stays within 0.5 um of the "
            "truth at the skin.");
  EXPECT_THAT(keep[1], StartsWith("Nlerp loses up to 25 mm at the skin (0.9"));
  EXPECT_THAT(keep[1], HasSubstr(" degrees at a joint) and saves 6.00 ns a joint."));
  EXPECT_THAT(keep[2], StartsWith("Corrected nlerp loses up to 1 m at the skin ("));
  EXPECT_EQ(keep[3],
            "Use exact slerp: nothing clearly cheaper stays within 0.2 mm, a ten-thousandth of the model's size.");
  std::map<std::string, Cost> cheap = dear;
  cheap["corrected nlerp"] = {0.1, 6.0};
  EXPECT_EQ(said(study, cheap).back(),
            "Corrected nlerp will do for this clip: it stays within 0.2 mm, a ten-thousandth of the model's size, and "
            "saves 4.00 ns a joint. Where every digit counts, use exact slerp.");
}

TEST(cost_findings, of_stored_keys) {
  const Scene scene = arm();
  const Study study = cost::study_storage(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("keys as they are *", "16 bits", "12 bits", "8 bits", "budget 10 um",
                                              "budget 0.1 mm", "budget 1 mm", "24 Hz", "30 Hz", "60 Hz", "120 Hz"));
  EXPECT_THAT(study.group.about, StartsWith("The 1 animated joints of the clip \"wave\", compiled"));
  std::map<std::string, Cost> costs{
      {"keys as they are", {5e-4, 10.0, 40.0}}, {"30 Hz", {3.0, 6.0, 80.0}}, {"60 Hz", {0.5, 10.0, 160.0}}};
  EXPECT_THAT(
      said(study, costs),
      ElementsAre("The keys as they are take 40.0 saved bytes a joint and second; sampling them takes 10.0 ns a joint "
                  "and is within 0.5 um of the truth.",
                  "Resampled at 30 Hz they take 2.00 times the size and are off by up to 3 mm; sampling saves 4.00 ns "
                  "a joint.",
                  "Resampled at 60 Hz they take 4.00 times the size and are off by up to 0.5 mm; sampling takes as "
                  "long.",
                  "Keep the keys as they are: nothing smaller stays within 0.2 mm, a ten-thousandth of the model's "
                  "size."));
  costs["12 bits"] = {0.1, 15.0, 10.0};
  EXPECT_EQ(said(study, costs).back(),
            "12 bits is the smallest that stays within 0.2 mm, a ten-thousandth of the model's size: 0.250 times the "
            "size, off by up to 0.1 mm; sampling costs 5.00 ns a joint more.");
}

TEST(cost_findings, of_influences) {
  const Scene scene = arm();
  const Study study = cost::study_influences(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("one influence", "all influences *", "16-bit weights", "8-bit weights"));
  const auto found = said(study, {{"one influence", {80.0, 5.0}},
                                  {"all influences", {0.0, 10.0}},
                                  {"16-bit weights", {0.01, 8.0}},
                                  {"8-bit weights", {2.0, 8.0}}});
  EXPECT_THAT(found, ElementsAre("All influences with float weights take 10.0 ns a vertex.",
                                 "One influence: vertices are up to 80 mm elsewhere; saves 5.00 ns a vertex.",
                                 "16-bit weights: vertices are up to 10 um elsewhere; saves 2.00 ns a vertex.",
                                 "8-bit weights: vertices are up to 2 mm elsewhere; saves 2.00 ns a vertex.",
                                 "The cheapest that stays within 0.2 mm, a ten-thousandth of the model's size: 16-bit "
                                 "weights."));
  EXPECT_DOUBLE_EQ(study.group.points[1].values[0].value, 9.0) << "six influences of six bytes for four vertices";
  EXPECT_DOUBLE_EQ(study.group.points[3].values[0].value, 4.5);
}

TEST(cost_findings, of_kinds_of_skinning) {
  const Scene scene = arm();
  Study study = cost::study_skinning(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("linear *", "dual quaternion", "center of rotation"));
  EXPECT_THAT(study.group.about, testing::Not(HasSubstr("stretch")));
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t v = 0; v < 3; ++v) study.group.points[p].values[v].value = static_cast<double>(90 + 3 * p + v);
  std::map<std::string, Cost> costs{
      {"linear", {30.0, 10.0}}, {"dual quaternion", {1.0, 15.0}}, {"center of rotation", {1.5, 25.0}}};
  EXPECT_THAT(
      said(study, costs),
      ElementsAre("Linear blending takes 10.0 ns a vertex and keeps 90.0 % of the limb bent by 90 degrees, 91.0 % of "
                  "it twisted by 150.",
                  "Dual quaternion skinning costs 5.00 ns a vertex more here, 1.50 times as much; it keeps 93.0 % bent "
                  "and 94.0 % twisted, and puts vertices of this file up to 95 mm elsewhere.",
                  "Center of rotation skinning costs 15.0 ns a vertex more here, 2.50 times as much; it keeps 96.0 % "
                  "bent and 97.0 % twisted, and puts vertices of this file up to 98 mm elsewhere.",
                  "Where limbs bend or twist far, use dual quaternion: the cheapest that changes a limb's volume by "
                  "less than 2 %. Elsewhere linear blending will do."));
  Scene stretched = arm();
  stretched.skeleton.rest[2].scale = {1.0f, 2.0f, 1.0f};
  EXPECT_THAT(cost::study_skinning(Subject(stretched, 0, Effort::quick())).group.about,
              HasSubstr("Joints of this file stretch"));
}

TEST(cost_findings, of_normals) {
  const Scene scene = arm();
  Study study = cost::study_skinned_normals(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("blended matrix *", "cofactor matrix"));
  EXPECT_EQ(study.group.points[0].note, "right when joints are rigid or scaled evenly");
  EXPECT_EQ(study.group.points[1].note, "right under any scale");
  EXPECT_EQ(study.group.about,
            "Linear blending of positions and normals of the largest primitive: 4 vertices with up to 2 influences, in "
            "8 poses of the clip \"wave\". Truth is the cofactor matrix of the blended matrix in double precision.");
  const std::map<std::string, Cost> costs{{"blended matrix", {12.5, 10.0}}, {"cofactor matrix", {5e-5, 13.0}}};
  study.group.points[0].values[0].value = 1.5;
  study.group.points[1].values[0].value = 0.25;
  EXPECT_THAT(said(study, costs),
              ElementsAre("Turning normals with the blended matrix itself, as shaders do, is off by 1.50 degrees on "
                          "average and by up to 12.5 degrees here.",
                          "The cofactor matrix is right under any scale, within 0.0001 degrees, and costs 3.00 ns a "
                          "vertex more.",
                          "An average above a degree is seen in shading: for this file the exact rule "
                          "(Needs::skin.normal_rule = cofactor) is worth its time."));
  study.group.points[0].values[0].value = 0.99;
  EXPECT_EQ(said(study, costs).back(),
            "For this file the matrix itself will do: an average below a degree is not seen in shading.");
}

TEST(cost_findings, of_morph_targets) {
  const Scene face = face_scene();
  Study study = cost::study_morphing(Subject(face, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("all targets", "active targets *", "weights from 0.001",
                                              "weights from 0.01", "weights from 0.05", "normals as summed"));
  EXPECT_EQ(study.group.about,
            "4 vertices with 2 targets, 2.00 of them active on average, at 16 moments of the clip \"smile\". Truth is "
            "the sum of all targets in double precision.");
  EXPECT_EQ(study.group.error_unit, "degrees");
  for (Point& point : study.group.points) point.values[0].value = 2.0;
  const auto found = said(study, {{"all targets", {0.5, 20.0}}, {"active targets", {0.5, 10.0}}});
  ASSERT_EQ(found.size(), 7u);
  EXPECT_EQ(found[0],
            "Adding only the targets whose weight is not zero takes 10.0 ns a vertex and is within 0.500 degrees of "
            "the truth.");
  EXPECT_EQ(found[1],
            "All targets: vertices are up to 2 mm off, normals up to 0.500 degrees; costs 10.0 ns a vertex more.");
  EXPECT_EQ(found[6],
            "Leaving out targets of weight 0 loses nothing and saves 10.0 ns a vertex; thresholds above 0 are for "
            "those who accept the errors above.");
  Scene flat = face_scene();
  flat.meshes[0].primitives[0].morphs.targets[0].normals = {};
  Study by_distance = cost::study_morphing(Subject(flat, kNone, Effort::quick()));
  EXPECT_EQ(by_distance.group.error_unit, "mm");
  EXPECT_THAT(by_distance.group.about, HasSubstr("one in four at weight 0.5, for want of a clip"));
  by_distance.group.points[0].values[0].value = 2.0;
  EXPECT_THAT(said(by_distance, {{"all targets", {2.0, 20.0}}, {"active targets", {0.0, 10.0}}})[1],
              testing::StrEq("All targets: vertices are up to 2 mm off; costs 10.0 ns a vertex more."));
}

TEST(cost_findings, of_geometry_caches) {
  const Scene scene = arm();
  const Study study = cost::study_geometry(Subject(scene, 0, Effort::quick()));
  EXPECT_THAT(names(study.group), ElementsAre("sinew 0.1 mm *", "sinew 10 um", "sinew 1 mm", "floats", "halves",
                                              "zstd -19", "meshopt", "zstd -19, residuals", "meshopt, residuals"));
  EXPECT_THAT(study.group.about, StartsWith("4 points in 1 primitive, of 16 frames at 30 a second. "));
  EXPECT_THAT(said(study, {{"sinew 0.1 mm", {0.05, 4.0, 3.0}},
                           {"zstd -19", {0.05, 5.0, 6.0}},
                           {"meshopt", {0.05, 6.0, 7.5}},
                           {"zstd -19, residuals", {0.05, 7.0, 9.0}},
                           {"meshopt, residuals", {0.05, 8.0, 10.5}}}),
              ElementsAre("The cache takes 3.00 bytes a point and frame, 25.0 % of floats, and decodes in 4.00 ns a "
                          "point, within 50 um.",
                          "Of the same numbers zstd -19 takes 2.00 times its bytes, and 5.00 ns a point to decode; "
                          "meshopt takes 2.50 times its bytes, and 6.00 ns a point to decode.",
                          "Of residuals zstd -19, residuals takes 3.00 times its bytes, and 7.00 ns a point to decode; "
                          "meshopt, residuals takes 3.50 times its bytes, and 8.00 ns a point to decode."));
}

TEST(cost_findings, of_geometry_caches_the_budget_follows_models_of_another_size_than_usual) {
  const auto budget_of = [](double times) {
    Scene scene = arm();
    const auto factor = static_cast<float>(times);
    for (glm::vec3& point : scene.meshes[0].primitives[0].positions) point *= factor;
    for (Transform& rest : scene.skeleton.rest) rest.translation *= factor;
    for (Affine& bind : scene.skins[0].inverse_bind)
      for (glm::vec4& row : bind.row) row.w *= factor;
    finish_scene(scene);
    const Subject subject(scene, 0, Effort::quick());
    EXPECT_NEAR(subject.hardly_seen_mm(), 0.2 * times, 0.02 * times);
    const Study study = cost::study_geometry(subject);
    return study.group.points.empty() ? study.group.left_out : names(study.group)[0];
  };
  EXPECT_EQ(budget_of(1.0), "sinew 0.1 mm *");
  EXPECT_EQ(budget_of(20.0), "sinew 0.1 mm *");
  EXPECT_EQ(budget_of(100.0), "sinew 10 mm *");
  EXPECT_EQ(budget_of(1000.0), "sinew 100 mm *");
  EXPECT_EQ(budget_of(1e-3), "sinew 0.1 um *");
}

TEST(cost_findings, a_geometry_cache_is_as_large_as_its_file_without_the_faces) {
  const Scene scene = arm();
  auto bent = tool::bake_scene(scene, 0, 30.0, {}, 16);
  ASSERT_TRUE(bent);
  bent->take.meshes[0].between.clear();
  bent->take.meshes[0].streams.resize(1);
  bent->take.meshes[0].streams[0].budget = 1e-4;
  bent->take.meshes[0].streams[0].frames.resize(16);
  const auto file = encode_geometry_cache(bent->take, {.keep_triangles = false});
  ASSERT_TRUE(file);
  const Group group = cost::study_geometry(Subject(scene, 0, Effort::quick())).group;
  EXPECT_DOUBLE_EQ(*group.points.at(0).size, static_cast<double>(file->size()) / (16 * 4));
}

TEST(cost_findings, of_arithmetic) {
  const Scene scene = arm();
  const Study study = cost::study_arithmetic(Subject(scene, 0, Effort::quick()));
  const auto own =
      std::find_if(study.group.points.begin(), study.group.points.end(), [](const Point& p) { return p.is_default; });
  ASSERT_NE(own, study.group.points.end());
  for (const Point& point : study.group.points) {
    const bool is_double = point.name == "plain double";
    EXPECT_GT(point.error, is_double ? -1.0 : 0.01) << point.name << ": points of a bent arm are no whole floats";
    EXPECT_LT(point.error, is_double ? 0.51 : 8.0) << point.name;
  }
  EXPECT_THAT(said(study, {{own->name, {0.5, 2.0}}, {"plain float", {0.5, 9.0}}, {"plain double", {0.0, 11.0}}}),
              ElementsAre("The widest lanes of this machine, " + own->name +
                              ", take 2.00 ns a vertex and are off by 0.500 steps of float in the last place.",
                          "Double precision in plain code costs 5.50 times as much, plain float 4.50 times."));
}

TEST(cost_findings, timed_moments_lie_one_in_each_sixteenth_of_a_clip_and_on_no_usual_key) {
  std::vector<double> moments = cost::timed_moments(4.0);
  EXPECT_FALSE(std::is_sorted(moments.begin(), moments.end())) << "a clip that only plays forwards finds keys sooner";
  std::sort(moments.begin(), moments.end());
  ASSERT_EQ(moments.size(), 16u);
  for (std::size_t i = 0; i < moments.size(); ++i)
    EXPECT_NEAR(moments[i], (static_cast<double>(i) + 0.37) / 4.0, 1e-12);
}

TEST(cost_findings, rays_at_vertices_have_a_sentence_for_each_number_of_them) {
  const auto answer = [](const std::string& at_vertices) {
    return R"({"device": "a device", "width": 100, "height": 50, "pixels": 3000, "radius_m": 0.5, "error_without": 0.2,
      "trials": [{"name": "2 slices of 12", "note": "", "method": "gtao", "samples": 24, "full_size": false,
        "blur": true, "default": true, "error": 0.05, "milliseconds": [2.0, 2.01, 1.99]}])" +
           at_vertices + "}";
  };
  const auto without = cost::occlusion_group(answer("")).findings;
  const auto findings = cost::occlusion_group(answer(R"(, "at_vertices": [
    {"rays": 64, "vertex_error": 0.025, "error": 0.061, "seconds": 0.5},
    {"rays": 256, "vertex_error": 0.013, "error": 0.043, "seconds": 2.0}])"))
                            .findings;
  ASSERT_EQ(findings.size(), without.size() + 2);
  EXPECT_EQ(findings.back(),
            "256 rays a vertex, baked in 2 s before the first frame, leave 4.3 % and take no time in a frame; at the "
            "vertices they are 1.3 % off 4096 rays, the rest is what triangles interpolate.");
}

TEST(cost_findings, ambient_occlusion_is_looked_at_in_the_same_clip_of_the_same_file) {
  EXPECT_THAT(cost::occlusion_arguments("a file.glb", 3, true),
              ElementsAre("--quick", "--clip", "3", "--", "a file.glb"));
  EXPECT_THAT(cost::occlusion_arguments("-f.glb", kNone, false), ElementsAre("--clip", "none", "--", "-f.glb"));
  EXPECT_THAT(cost::occlusion_arguments("", 3, true), ElementsAre("--quick")) << "its own scene has its own clip";
  EXPECT_THAT(cost::occlusion_arguments("", 3, false), ElementsAre());
}

TEST(cost_findings, keys_along_one_axis_are_rounded_within_their_range) {
  for (const float range_m : {2.0f, 1e-3f}) {
    Scene scene = arm();
    scene.animations[0].bones[0].rotation = {};
    Vec3Track& track = scene.animations[0].bones[0].translation;
    track = {Interpolation::linear, {}, {}};
    for (int k = 0; k <= 200; ++k) {
      track.times_s.push_back(static_cast<float>(k) / 200.0f);
      track.values.push_back({range_m * static_cast<float>(k * k % 201) / 201.0f, 1.0f, 0.0f});
    }
    const Study study = cost::study_storage(Subject(scene, 0, Effort::quick()));
    for (const auto& [name, steps] : {std::pair("16 bits", 65536.0), std::pair("8 bits", 256.0)}) {
      const auto point = std::find_if(study.group.points.begin(), study.group.points.end(),
                                      [&, n = name](const Point& p) { return p.name == n; });
      ASSERT_NE(point, study.group.points.end()) << name;
      EXPECT_LE(point->error, 1.2 * 1e3 * 0.5 * static_cast<double>(range_m) / steps + 1e-4) << name;
    }
  }
}

TEST(cost_findings, resampling_meets_keys_that_lie_on_its_times) {
  Scene scene = arm();
  scene.animations[0].bones[0].rotation = {};
  const auto at = [](int frame) { return static_cast<float>(frame / 24.0); };
  scene.animations[0].bones[0].translation = {
      Interpolation::linear, {0.0f, at(1), at(2), 1.0f}, {{0, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0, 2, 0}}};
  const Study study = cost::study_storage(Subject(scene, 0, Effort::quick()));
  for (const Point& point : study.group.points) {
    if (point.name == "24 Hz" || point.name == "120 Hz") {
      EXPECT_LT(point.error, 1e-3) << point.name;
    } else if (point.name == "30 Hz") {
      EXPECT_GT(point.error, 100.0) << "the corner lies between two of its times";
    }
  }
}

}  // namespace
}  // namespace sinew::test
