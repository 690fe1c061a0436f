// SPDX-License-Identifier: MIT
// Poses of the model of tool_model.h, computed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "importer/import_gltf.h"
#include "importer/tool/model_size.h"
#include "importer/tool/poses/pose_sampler.h"
#include "tests/importer/tool_model.h"

namespace sinew::tool {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pointwise;

constexpr double kNear = 1e-6;

ImportedFile model() {
  const std::string text = test::tool_model();
  auto file = import_gltf(std::as_bytes(std::span(text)), "model.gltf");
  EXPECT_TRUE(file) << describe("model.gltf", file.error().issue);
  return std::move(*file);
}

auto near(std::vector<double> expected) { return Pointwise(DoubleNear(kNear), std::move(expected)); }

const PrimitivePose& primitive_at(const Pose& pose, std::uint32_t node) {
  return *std::find_if(pose.primitives.begin(), pose.primitives.end(), [&](const auto& p) { return p.node == node; });
}

TEST(pose_sampler, rest_pose_has_all_nodes_the_mesh_weights_and_the_bind_pose) {
  const ImportedFile file = model();
  const Pose rest = *PoseSampler(file.scene, {}).sample(kNone, 0.0);
  ASSERT_EQ(rest.nodes.size(), 4u);
  EXPECT_THAT(rest.nodes[2].world, near({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1}));
  EXPECT_THAT(rest.nodes[3].world, near({1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1}));
  ASSERT_EQ(rest.weights.size(), 1u);
  EXPECT_EQ(rest.weights[0].node, 3u);
  EXPECT_THAT(rest.weights[0].weights, ElementsAre(0.25, 0.0));
  const PrimitivePose& strip = primitive_at(rest, 0);
  EXPECT_THAT(strip.vertices, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(strip.of(VertexKind::positions), near({0, 0, 0, 0, 1, 0, 0, 1.5, 0, 0, 2, 0}));
  EXPECT_THAT(strip.of(VertexKind::dqs), near({0, 0, 0, 0, 1, 0, 0, 1.5, 0, 0, 2, 0}));
}

TEST(pose_sampler, a_bent_joint_moves_what_hangs_on_it_both_ways_of_skinning) {
  const ImportedFile file = model();
  const Pose bent = *PoseSampler(file.scene, {}).sample(0, 1.0);
  EXPECT_THAT(bent.nodes[2].world, near({0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1}));
  const PrimitivePose& strip = primitive_at(bent, 0);
  const double half = std::sqrt(0.5);
  EXPECT_THAT(strip.of(VertexKind::positions), near({0, 0, 0, 0, 1, 0, -0.5, 1, 0, -1, 1, 0}));
  EXPECT_THAT(strip.of(VertexKind::normals), near({1, 0, 0, half, half, 0, 0, 1, 0, 0, 1, 0}));
  EXPECT_THAT(strip.of(VertexKind::dqs), near({0, 0, 0, 0, 1, 0, -0.5, 1, 0, -1, 1, 0}));
  EXPECT_THAT(strip.of(VertexKind::dqs_normals), near({1, 0, 0, half, half, 0, 0, 1, 0, 0, 1, 0}));
}

TEST(pose_sampler, G42_morphs_before_the_nodes_matrix_and_has_no_flat_normals) {
  const ImportedFile file = model();
  const Pose talking = *PoseSampler(file.scene, {}).sample(1, 2.0);
  EXPECT_THAT(talking.weights[0].weights, ElementsAre(1.0, 0.5));
  const PrimitivePose& face = primitive_at(talking, 3);
  EXPECT_EQ(face.mesh, 1u);
  EXPECT_THAT(face.of(VertexKind::positions), near({2, 0, 1, 3, 0, 0, 2, 6, 0}));
  EXPECT_THAT(face.of(VertexKind::normals), IsEmpty());
  EXPECT_THAT(face.of(VertexKind::dqs), IsEmpty());
}

TEST(pose_sampler, each_kind_of_skinning_fills_its_own_keys) {
  const ImportedFile file = model();
  const auto filled = [&](bool linear, bool dual_quaternion, bool center_of_rotation) {
    const Pose pose = *PoseSampler(file.scene, {linear, dual_quaternion, center_of_rotation, 64}).sample(0, 0.5);
    EXPECT_FALSE(primitive_at(pose, 3).of(VertexKind::positions).empty());  // unskinned: always
    const PrimitivePose& strip = primitive_at(pose, 0);
    const auto has = [&](VertexKind kind) { return !strip.of(kind).empty(); };
    return std::array{has(VertexKind::positions) && has(VertexKind::normals),
                      has(VertexKind::dqs) && has(VertexKind::dqs_normals),
                      has(VertexKind::cors) && has(VertexKind::cor_normals)};
  };
  for (const auto& kinds :
       {std::array{true, false, false}, {false, true, false}, {false, false, true}, {true, true, true}})
    EXPECT_EQ(filled(kinds[0], kinds[1], kinds[2]), kinds);
}

TEST(pose_sampler, N21_a_bent_joint_turns_what_lies_around_a_center_of_rotation) {
  ImportedFile file = model();
  Primitive& strip = file.scene.meshes[0].primitives[0];
  strip.centers_of_rotation = strip.positions;
  for (std::size_t v = 0; v < 4; ++v)
    if (strip.source_vertex[v] == 1) strip.centers_of_rotation[v] = {0, 0.5f, 0};
  const Pose bent = *PoseSampler(file.scene, {}).sample(0, 1.0);
  const PrimitivePose& pose = primitive_at(bent, 0);
  const double half = std::sqrt(
      0.5);  // the center goes to half of (0 .5) and half of (.5 1), the arm of half a metre turns by 45 degrees
  EXPECT_THAT(pose.of(VertexKind::cors), near({0, 0, 0, 0.25 - half / 2, 0.75 + half / 2, 0, -0.5, 1, 0, -1, 1, 0}));
  EXPECT_THAT(pose.of(VertexKind::cor_normals), near({1, 0, 0, half, half, 0, 0, 1, 0, 0, 1, 0}));
}

TEST(pose_sampler, a_joint_that_mirrors_or_collapses_space_has_no_dual_quaternion) {
  for (const float scale : {-1.0f, 0.0f}) {
    ImportedFile file = model();
    Skeleton& skeleton = file.scene.skeleton;
    skeleton.rest[skeleton.joint_of_node[2]].scale.x = scale;
    const Pose pose = *PoseSampler(file.scene, {}).sample(kNone, 0.0);
    const std::vector<double>& dqs = primitive_at(pose, 0).of(VertexKind::dqs);
    EXPECT_FALSE(std::isnan(dqs[0])) << "vertex 0 follows the other joint alone";
    EXPECT_TRUE(std::isnan(dqs[3]) && std::isnan(dqs[6]) && std::isnan(dqs[9])) << scale;
    for (const double x : primitive_at(pose, 0).of(VertexKind::positions)) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(pose_sampler, N22_normals_of_unskinned_meshes_follow_the_inverse_transpose_even_mirrored) {
  ImportedFile file = model();
  Scene& scene = file.scene;
  scene.instances[0].skin = kNone;
  Primitive& strip = scene.meshes[0].primitives[0];
  strip.influences = {};
  for (glm::vec3& normal : strip.normals) normal = {0.6f, 0.8f, 0.0f};
  scene.skeleton.rest[scene.skeleton.joint_of_node[0]].scale = {-2.0f, 1.0f, 1.0f};
  const Pose pose = *PoseSampler(scene, {}).sample(kNone, 0.0);
  const std::vector<double>& normals = primitive_at(pose, 0).of(VertexKind::normals);
  const double length = std::hypot(0.3, 0.8);  // inverse transpose of diag(-2, 1, 1): diag(-1/2, 1, 1)
  EXPECT_NEAR(normals[0], -0.3 / length, kNear);
  EXPECT_NEAR(normals[1], 0.8 / length, kNear);
  EXPECT_NEAR(primitive_at(pose, 0).of(VertexKind::positions)[9], 0.0, kNear);
}

TEST(pose_sampler, a_thin_joint_turns_vertices_and_one_flattened_aslant_does_not) {
  // A joint below `root`, which flattens y, and turned by 45 degrees: no column is short, the volume is.
  for (const auto& [root_scale, tip_scale, turned, usable] :
       {std::tuple(1.0f, 1e-7f, false, true), std::tuple(1e-13f, 1.0f, true, false)}) {
    ImportedFile file = model();
    Skeleton& skeleton = file.scene.skeleton;
    skeleton.rest[skeleton.joint_of_node[1]].scale.y = root_scale;
    skeleton.rest[skeleton.joint_of_node[2]].scale.y = tip_scale;
    const float eighth = 0.39269908f;
    if (turned) skeleton.rest[skeleton.joint_of_node[2]].rotation = {std::cos(eighth), 0, 0, std::sin(eighth)};
    const Pose pose = *PoseSampler(file.scene, {}).sample(kNone, 0.0);
    const std::vector<double>& dqs = primitive_at(pose, 0).of(VertexKind::dqs);
    EXPECT_EQ(std::isfinite(dqs[9]), usable) << "vertex 3 follows the tip alone";
    EXPECT_TRUE(std::isfinite(dqs[0])) << "the root is thin at most";
  }
}

TEST(pose_sampler, tangents_of_unskinned_meshes_turn_with_the_node_and_keep_their_handedness) {
  ImportedFile file = model();
  Scene& scene = file.scene;
  scene.instances[0].skin = kNone;
  Primitive& strip = scene.meshes[0].primitives[0];
  strip.influences = {};
  strip.tangents = {{0.6f, 0.8f, 0, -1}, {0, 1, 0, 1}, {0, 1, 0, -1}, {0, 0, 1, 1}};
  strip.source_vertex.clear();
  scene.skeleton.rest[scene.skeleton.joint_of_node[0]].scale = {2.0f, 1.0f, 1.0f};
  const Pose pose = *PoseSampler(scene, {}).sample(kNone, 0.0);
  const double length = std::hypot(1.2, 0.8);
  EXPECT_THAT(primitive_at(pose, 0).of(VertexKind::tangents),
              near({1.2 / length, 0.8 / length, 0, -1, 0, 1, 0, 1, 0, 1, 0, -1, 0, 0, 1, 1}));
}

TEST(pose_sampler, each_primitive_of_a_mesh_has_vertices_of_its_own) {
  for (const bool skinned : {true, false}) {
    ImportedFile file = model();
    Scene& scene = file.scene;
    Primitive& first = scene.meshes[0].primitives[0];
    first.tangents.assign(4, {0, 1, 0, 1});
    if (!skinned) scene.instances[0].skin = kNone;
    if (!skinned) first.influences = {};
    for (int p = 1; p < 3; ++p) {
      Primitive other = scene.meshes[0].primitives[0];
      for (glm::vec3& position : other.positions) position.x += static_cast<float>(p);
      for (glm::vec3& normal : other.normals) normal = {0, 0, p == 1 ? 1 : -1};
      for (glm::vec4& tangent : other.tangents) tangent = {0, p == 1 ? 1 : -1, 0, -1};
      scene.meshes[0].primitives.push_back(other);
    }
    const Pose pose = *PoseSampler(scene, {true, true, true, 64}).sample(kNone, 0.0);
    for (const PrimitivePose& part : pose.primitives) {
      if (part.node != 0) continue;
      const double x = part.primitive, side = std::array{0.0, 1.0, -1.0}[part.primitive];
      const auto first_of = [&](VertexKind kind, std::ptrdiff_t count) {
        const std::vector<double>& all = part.of(kind);
        return std::vector<double>(all.begin(), all.begin() + std::min<std::ptrdiff_t>(count, std::ssize(all)));
      };
      EXPECT_THAT(first_of(VertexKind::positions, 3), near({x, 0, 0}));
      EXPECT_THAT(first_of(VertexKind::normals, 3), near({part.primitive == 0 ? 1.0 : 0.0, 0, side}));
      EXPECT_THAT(first_of(VertexKind::tangents, 4),
                  near({0, part.primitive == 2 ? -1.0 : 1.0, 0, part.primitive == 0 ? 1.0 : -1.0}));
      if (!skinned) continue;
      for (const VertexKind kind : {VertexKind::dqs, VertexKind::cors}) EXPECT_THAT(first_of(kind, 3), near({x, 0, 0}));
      for (const VertexKind kind : {VertexKind::dqs_normals, VertexKind::cor_normals})
        EXPECT_THAT(first_of(kind, 3), near({part.primitive == 0 ? 1.0 : 0.0, 0, side}));
    }
    EXPECT_EQ(pose.primitives.size(), 4u);
  }
}

TEST(pose_sampler, G10_times_outside_the_clip_give_its_ends) {
  const ImportedFile file = model();
  PoseSampler sampler(file.scene, {});
  EXPECT_EQ(sampler.sample(0, 99.0)->nodes[2].world, sampler.sample(0, 1.0)->nodes[2].world);
  EXPECT_EQ(sampler.sample(0, -5.0)->nodes[2].world, sampler.sample(0, 0.0)->nodes[2].world);
}

TEST(pose_sampler, G22_a_clip_leaves_what_it_does_not_animate_at_rest) {
  const ImportedFile file = model();
  PoseSampler sampler(file.scene, {});
  EXPECT_THAT(sampler.sample(1, 2.0)->weights[0].weights, ElementsAre(1.0, 0.5));
  EXPECT_THAT(sampler.sample(0, 1.0)->weights[0].weights, ElementsAre(0.25, 0.0));
}

TEST(model_size, is_the_largest_side_of_the_rest_pose_in_the_world) {
  const ImportedFile file = model();
  EXPECT_DOUBLE_EQ(model_size_m(file.scene), 3.0);  // x from the strip's 0 to the face's 3
  EXPECT_EQ(model_size_m(Scene{}), kSizeWithoutVertices);
}

}  // namespace
}  // namespace sinew::tool
