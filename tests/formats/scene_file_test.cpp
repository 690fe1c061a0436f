// SPDX-License-Identifier: MIT
// FBX and COLLADA written by hand: pivots, units and axes, beside their own formulas.
#include "importer/formats/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "importer/import_gltf.h"
#include "tests/formats/scene_files.h"
#include "tests/formats/world_pose.h"
#include "tests/support/near.h"

namespace sinew::formats {
namespace {

struct Imported {
  Scene scene;
  ImportedFormat summary;
};

Imported imported(const std::string& text, bool is_fbx, const FormatOptions& options = {}) {
  Imported out;
  ModelDraft draft;
  const auto fault = add_scene_file(std::as_bytes(std::span(text)), is_fbx, "test", options, draft, out.summary);
  EXPECT_FALSE(fault) << fault->detail;
  const auto bytes = draft.finish("test", out.summary.warnings);
  EXPECT_TRUE(bytes) << describe("test", bytes.error().issue);
  auto file = import_gltf(*bytes, "test", {.make_normals = false});  // normals of faces would split vertices
  EXPECT_TRUE(file);
  out.scene = std::move(file->scene);
  return out;
}

glm::dmat4 move(double x, double y, double z) {
  glm::dmat4 out(1.0);
  out[3] = {x, y, z, 1.0};
  return out;
}

glm::dmat4 turn(int axis, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  glm::dmat4 out(1.0);
  out[a][a] = out[b][b] = c;
  out[a][b] = s;
  out[b][a] = -s;
  return out;
}

/// Euler angles in the order x, y, z of FBX.
glm::dmat4 euler(double x, double y, double z) { return turn(2, z) * turn(1, y) * turn(0, x); }

/// eq    T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1   (FBX SDK, "Transformation matrices")
glm::dmat4 hip(double x, double y, double z) {
  return move(1, 2, 3) * move(0, 0, 2) * move(0, 5, 0) * euler(90, 0, 0) * euler(x, y, z) * turn(1, -45) *
         move(0, -5, 0) * move(3, 0, 0) * move(-3, 0, 0);
}

void expect_pose(const Scene& scene, std::uint32_t clip, double time_s, const glm::dmat4& hip_local, double knee_y,
                 double bound) {
  constexpr double kInch = 0.0254;
  const glm::dmat4 hip_world = turn(0, -90) * hip_local, knee = hip_world * move(0, knee_y, 0) * euler(0, 0, -90);
  const auto world = test::world_pose(scene, clip, time_s);
  const std::size_t first = world.size() - 2;
  for (const auto& [node, exact] : {std::pair(first, hip_world), std::pair(first + 1, knee)})
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r)
        EXPECT_NEAR(world[node].row[r][c], exact[c][r] * (c == 3 ? kInch : 1.0), bound) << time_s << ' ' << node;
}

TEST(scene_file, pivots_of_fbx_are_folded_into_one_node_a_joint) {
  const Imported file = imported(test::pivots_fbx(), true);
  EXPECT_THAT(file.scene.skeleton.names, testing::ElementsAre("RootNode", "hip", "knee"));
  EXPECT_THAT(file.summary.warnings, testing::IsEmpty());
  expect_pose(file.scene, kNone, 0.0, hip(10, 20, 30), 10, 1e-6);
}

TEST(scene_file, clips_of_joints_with_pivots_agree_with_the_formula_of_fbx_at_all_times) {
  const Scene scene = imported(test::pivots_fbx(), true).scene;
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].name, "Take 001");
  EXPECT_NEAR(scene.animations[0].duration_s, 1.0, 1e-6);
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0, angle = t < 0.5 ? 10.0 + 60.0 * t : 40.0 - 120.0 * (t - 0.5);
    expect_pose(scene, 0, t, hip(angle, 0, 0), 10.0 + 2.0 * t, 1e-4 * 12 * 0.0254);
  }
}

TEST(scene_file, unit_and_axis_of_the_caller_count_more_than_those_of_the_file) {
  FormatOptions options;
  options.metres_per_unit = 1.0;
  options.z_up = false;
  const Scene scene = imported(test::pivots_fbx(), true, options).scene;
  const auto world = test::world_pose(scene, kNone, 0.0);
  EXPECT_TRUE(test::is_near(translation_of(world[1]), glm::dvec3(hip(10, 20, 30)[3]), 1e-5));
}

TEST(scene_file, left_handed_axes_get_a_warning) {
  std::string text = test::pivots_fbx();
  const std::string sign = "\"FrontAxisSign\", \"int\", \"Integer\", \"\",-1";
  const std::size_t at = text.find(sign);
  ASSERT_NE(at, text.npos);
  text.erase(at + sign.size() - 2, 1);
  const auto warnings = imported(text, true).summary.warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].rule, "fbx-axes");
}

TEST(scene_file, collada_in_feet_with_z_up_is_in_metres_with_y_up) {
  const Scene scene = imported(test::tower_collada(), false).scene;
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.skeleton.names.back(), "tower");
  const Affined world = test::world_pose(scene, kNone, 0.0).back();
  const auto& corners = scene.meshes[0].primitives.at(0).positions;
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_TRUE(test::is_near(translation_of(world), glm::dvec3(0.0, 3.0 * 0.3048, 0.0), 1e-6));
  EXPECT_TRUE(test::is_near(transform_point(world, glm::dvec3(corners[2])), glm::dvec3(0, 5.0 * 0.3048, 0), 1e-6));
}

TEST(scene_file, geometric_transforms_move_the_mesh_and_not_what_is_below_its_node) {
  const Imported file = imported(test::sail_fbx(), true);
  const Skeleton& skeleton = file.scene.skeleton;
  const auto world = test::world_pose(file.scene, kNone, 0.0);
  const auto place = [&](const char* name, const glm::dvec3& point) {
    return transform_point(world[skeleton.node_of_joint[*skeleton.find(name)]], point);
  };
  EXPECT_TRUE(test::is_near(place("flag", glm::dvec3(0.0)), glm::dvec3(0.0, 1.5, 0.0), 1e-6));
  std::vector<std::string> shown_at;
  for (const MeshInstance& instance : file.scene.instances) shown_at.push_back(skeleton.names[instance.joint]);
  EXPECT_THAT(shown_at, testing::UnorderedElementsAre("flag", "sail"));
  EXPECT_TRUE(test::is_near(place("sail", glm::dvec3(1.0, 0.0, 0.0)), glm::dvec3(0.0, 1.0, -0.9), 1e-6));
}

TEST(scene_file, morph_targets_of_fbx_rest_at_0_and_follow_their_curve) {
  const Scene scene = imported(test::sail_fbx(), true).scene;
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_THAT(mesh.target_names, testing::ElementsAre("wind"));
  EXPECT_THAT(mesh.default_weights, testing::ElementsAre(0.0f));
  const auto& deltas = mesh.primitives.at(0).morphs.targets.at(0).positions.deltas;
  EXPECT_THAT(deltas, testing::UnorderedElementsAre(glm::vec3(0, 0, 0.5f), glm::vec3(0, 0, 0.25f)));
  const WeightTrack& track = scene.animations.at(0).weights.at(0).weights;
  EXPECT_THAT(track.times_s, testing::ElementsAre(0.0f, 0.5f, 1.0f));
  EXPECT_THAT(track.values, testing::ElementsAre(0.0f, 1.0f, 0.25f));
}

TEST(scene_file, a_curve_without_a_key_in_its_take_ends_no_process) {
  std::string text = test::pivots_fbx();
  const std::string stop = "\"LocalStop\", \"KTime\", \"Time\", \"\",46186158000";
  text.replace(text.find(stop), stop.size(), "\"LocalStop\", \"KTime\", \"Time\", \"\",34639618500");
  const std::string start = "\"LocalStart\", \"KTime\", \"Time\", \"\",0";
  text.replace(text.find(start), start.size(), "\"LocalStart\", \"KTime\", \"Time\", \"\",11546539500");
  const Imported file = imported(text, true);
  ASSERT_EQ(file.summary.warnings.size(), 1u);
  EXPECT_EQ(file.summary.warnings[0].rule, "fbx-take-range");
  EXPECT_NEAR(file.scene.animations.at(0).duration_s, 1.0, 1e-6);
}

TEST(scene_file, weights_without_their_target_are_listed) {
  std::string text = test::sail_fbx();  // assimp does not read shapes without normals
  text.replace(text.find("  Normals: *6"), 7, "  Ignored");
  EXPECT_THAT(imported(text, true).summary.left_out, testing::Contains(testing::HasSubstr("morph weights of 'boat")));
}

TEST(scene_file, damaged_files_are_errors) {
  ModelDraft draft;
  ImportedFormat summary;
  for (const std::string& text : {test::pivots_fbx().substr(0, 900), std::string("Kaydara FBX Binary  \0\x1a\0", 23),
                                  test::tower_collada().substr(0, 300)}) {
    const bool is_fbx = text[0] != '<';
    const auto fault = add_scene_file(std::as_bytes(std::span(text)), is_fbx, "test", {}, draft, summary);
    ASSERT_TRUE(fault) << text.size();
    EXPECT_EQ(fault->rule, "assimp");
  }
}

}  // namespace
}  // namespace sinew::formats
