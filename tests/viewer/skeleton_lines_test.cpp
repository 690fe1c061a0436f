// SPDX-License-Identifier: MIT
#include "viewer/app/skeleton_lines.h"

#include <gtest/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/allocation_counter.h"

namespace sinew::viewer {
namespace {

Affine at(float x, float y, float z) {
  Affine m;
  m.row[0].w = x;
  m.row[1].w = y;
  m.row[2].w = z;
  return m;
}

// root 0 -> 1 -> 2 -> 3, 0 -> 4: a scene root, an armature of 1, 2, 3 and a lamp.
Scene chain() {
  Scene scene;
  scene.skeleton.parents = {kNone, 0, 1, 2, 0};
  scene.skeleton.rest.resize(5);
  return scene;
}

// The outline touches each end four times, and its other points are nearer to the parent.
void expect_bone(std::span<const LineVertex> lines, const glm::vec3& from, const glm::vec3& to) {
  int at_parent = 0, at_joint = 0, nearer_to_parent = 0;
  for (const auto& vertex : lines.first(SkeletonLines::kVerticesPerBone)) {
    if (vertex.position == from)
      ++at_parent;
    else if (vertex.position == to)
      ++at_joint;
    else if (glm::distance(vertex.position, from) < 0.5f * glm::distance(vertex.position, to))
      ++nearer_to_parent;
  }
  EXPECT_EQ(at_parent, 4);
  EXPECT_EQ(at_joint, 4);
  EXPECT_EQ(nearer_to_parent, 16);
}

TEST(skeleton_lines, without_a_skin_joins_every_joint_to_its_parent) {
  SkeletonLines lines(chain());
  EXPECT_EQ(lines.bone_count(), 4u);
  const Affine model[] = {at(0, 0, 0), at(0, 1, 0), at(0, 2, 0), at(0, 2, 5), at(7, 0, 0)};
  const auto made = lines.make(model, 0.5f);
  ASSERT_EQ(made.size(), SkeletonLines::kVerticesPerBone * 4 + 6u * 5);
  expect_bone(made.subspan(2 * SkeletonLines::kVerticesPerBone), {0, 2, 0}, {0, 2, 5});  // third bone: 2 -> 3
}

TEST(skeleton_lines, P15_take_memory_only_when_they_are_made_and_then_once) {
  const std::vector<Affine> model = {at(0, 0, 0), at(0, 1, 0), at(0, 2, 0), at(0, 2, 5), at(7, 0, 0)};
  const Scene scene = chain();
  const test::PeakMemory peak;
  SkeletonLines lines(scene);
  EXPECT_LT(peak.bytes(), 500u);
  const std::size_t bytes = lines.make(model, 0.5f).size_bytes();
  EXPECT_GT(bytes, 1000u);
  EXPECT_GE(peak.bytes(), bytes);
  const test::AllocationCounter counter;
  EXPECT_EQ(lines.make(model, 0.5f).size_bytes(), bytes);
  EXPECT_EQ(counter.count(), 0u);
}

TEST(skeleton_lines, the_outline_is_a_square_around_the_bone_near_the_parent_joined_to_both_ends) {
  Scene scene;
  scene.skeleton.parents = {kNone, 0};
  SkeletonLines lines(scene);
  for (const glm::vec3& along : {glm::vec3(0, 2, 0), glm::vec3(3, 0, 0), glm::vec3(0, 0, -5), glm::vec3(1, -2, 2)}) {
    const glm::vec3 from(7, 8, 9), to = from + along;
    const Affine model[] = {at(from.x, from.y, from.z), at(to.x, to.y, to.z)};
    const auto bone = lines.make(model, 0.5f).first(SkeletonLines::kVerticesPerBone);
    const float length = glm::length(along), radius = 0.06f * length;
    glm::vec3 sum(0);
    for (std::size_t side = 0; side < 4; ++side) {
      // Each side has three lines: parent joint to ring corner, that corner to the joint, that corner to the next one.
      const glm::vec3 corner = bone[6 * side + 1].position, next = bone[6 * side + 5].position;
      EXPECT_EQ(bone[6 * side].position, from);
      EXPECT_EQ(bone[6 * side + 2].position, corner);
      EXPECT_EQ(bone[6 * side + 3].position, to);
      EXPECT_EQ(bone[6 * side + 4].position, corner);
      EXPECT_EQ(next, bone[6 * ((side + 1) % 4) + 1].position);
      EXPECT_NEAR(glm::dot(corner - from, along) / (length * length), 0.15f, 1e-5f);
      EXPECT_NEAR(glm::distance(corner, from + 0.15f * along), radius, 1e-5f * length);
      EXPECT_NEAR(glm::distance(corner, next), std::sqrt(2.0f) * radius, 1e-5f * length);
      sum += corner - from;
    }
    EXPECT_LT(glm::length(0.25f * sum - 0.15f * along), 1e-5f * length);
  }
}

TEST(skeleton_lines, with_a_skin_shows_its_joints_and_those_between_them_only) {
  Scene scene = chain();
  scene.skins.emplace_back().joints = {3, 1};  // 2 is between them
  SkeletonLines lines(scene);
  EXPECT_EQ(lines.bone_count(), 2u);
  const Affine model[] = {at(9, 9, 9), at(0, 1, 0), at(0, 2, 0), at(0, 2, 5), at(7, 0, 0)};
  const auto made = lines.make(model, 0.5f);
  ASSERT_EQ(made.size(), SkeletonLines::kVerticesPerBone * 2 + 6u * 3);
  expect_bone(made, {0, 1, 0}, {0, 2, 0});
  expect_bone(made.subspan(SkeletonLines::kVerticesPerBone), {0, 2, 0}, {0, 2, 5});
}

TEST(skeleton_lines, joints_of_every_skin_and_those_between_two_skins_are_shown) {
  Scene scene = chain();
  scene.skins.resize(2);
  for (const std::size_t upper : {0u, 1u}) {
    scene.skins[upper].joints = {1};
    scene.skins[1 - upper].joints = {3};
    EXPECT_EQ(SkeletonLines(scene).bone_count(), 2u);
  }
}

TEST(skeleton_lines, a_bone_without_length_has_no_outline) {
  Scene scene;
  scene.skeleton.parents = {kNone, 0};
  SkeletonLines lines(scene);
  const Affine model[] = {at(1, 1, 1), at(1, 1, 1)};
  EXPECT_EQ(lines.make(model, 0.5f).size(), 6u * 2);
}

TEST(skeleton_lines, axes_have_the_asked_length_whatever_the_scale_and_vanish_when_scaled_away) {
  Scene scene;
  scene.skeleton.parents = {kNone};
  SkeletonLines lines(scene);
  Affine scaled = at(1, 2, 3);
  scaled.row[0].x = 40.0f;
  scaled.row[1].y = -0.01f;
  scaled.row[2].z = 0.0f;
  const auto made = lines.make({&scaled, 1}, 0.25f);
  ASSERT_EQ(made.size(), 4u);
  EXPECT_EQ(made[1].position, glm::vec3(1.25f, 2, 3));
  EXPECT_EQ(made[3].position, glm::vec3(1, 1.75f, 3));
  EXPECT_NE(made[1].rgba, made[3].rgba);
}

TEST(skeleton_lines, axes_are_in_proportion_to_what_is_shown_and_longer_where_joints_are_alone) {
  Scene scene = chain();
  const Aabb box{{-1, 0, 0}, {1, 2, 1}};  // the diagonal is 3
  scene.skeleton.parents.assign(36, 0);
  scene.skeleton.parents[0] = kNone;
  EXPECT_FLOAT_EQ(SkeletonLines(scene).axis_length_m(box), 0.15f);
  EXPECT_FLOAT_EQ(SkeletonLines(scene).axis_length_m({}), 0.05f) << "as of a diagonal of 1";
  scene.skeleton.parents.resize(4);
  EXPECT_FLOAT_EQ(SkeletonLines(scene).axis_length_m(box), 0.45f) << "few joints have room for long axes";
  scene.instances.emplace_back();
  EXPECT_FLOAT_EQ(SkeletonLines(scene).axis_length_m(box), 0.036f) << "bones are seen through the mesh";
}

TEST(skeleton_lines, nodes_on_their_own_are_no_part_of_a_skeleton) {
  Scene scene = chain();
  scene.skeleton.parents.push_back(kNone);
  EXPECT_EQ(joints_of_skeleton(scene), (std::vector<bool>{true, true, true, true, true, false}));
  scene.skeleton.parents = {kNone, kNone};
  const std::vector<bool> alone = joints_of_skeleton(scene);
  EXPECT_EQ(alone, (std::vector<bool>{true, true})) << "but they are all that there is";
  const Affine model[] = {at(1, 2, 3), at(-1, 5, 0)};
  EXPECT_EQ(places_of({false, true}, model), (std::vector<glm::vec3>{{-1, 5, 0}}));
}

}  // namespace
}  // namespace sinew::viewer
