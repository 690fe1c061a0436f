// SPDX-License-Identifier: MIT
/// What must hold for every scene, through all jobs in a row.
#include <gtest/gtest.h>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/scenes/face.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

struct Shape {
  const char* name;
  Skeleton skeleton;
};

std::vector<Shape> shapes() {
  return {{"biped", scenes::biped()}, {"long chain", scenes::long_chain(100)}, {"wide tree", scenes::wide_tree(300)}};
}

/// All jobs of one skinned character, in order.
class Character {
 public:
  Character(const Skeleton& skeleton, std::uint32_t influences)
      : scene_(scenes::swinging_surface(skeleton, scenes::swinging(skeleton, 20), 600, influences)),
        pose_(skeleton.joint_count()),
        model_(skeleton.joint_count()),
        palette_(skeleton.joint_count()),
        split_(skeleton.joint_count()) {
    linear.resize(vertex_count());
    dual.resize(vertex_count());
    normals.resize(vertex_count());
  }

  const Scene& scene() const { return scene_; }
  std::size_t vertex_count() const { return primitive().vertex_count(); }
  const Primitive& primitive() const { return scene_.meshes[0].primitives[0]; }

  void pose_at_rest() {
    for (std::size_t j = 0; j < scene_.skeleton.joint_count(); ++j) pose_.span().set(j, scene_.skeleton.rest[j]);
  }
  void pose_at(double time_s) {
    EXPECT_EQ(run(SampleClipJob{.clip = &scene_.clips[0], .time_s = time_s, .pose = pose_.span(), .weights = {}}),
              ErrorCode::ok);
  }
  void deform(const Affine& root = {}) {
    const Primitive& p = primitive();
    EXPECT_EQ(run(LocalToModelJob{&scene_.skeleton, pose_.span(), root, model_}), ErrorCode::ok);
    EXPECT_EQ(run(JointPaletteJob{&scene_.skins[0], model_, palette_}), ErrorCode::ok);
    EXPECT_EQ(run(SkinLinearJob{
                  &p.influences, palette_, {p.positions, p.normals, {}}, {linear, normals, {}}, NormalRule::cofactor}),
              ErrorCode::ok);
    EXPECT_EQ(run(SplitPaletteJob{palette_, split_, &any_stretch_}), ErrorCode::ok);
    EXPECT_EQ(run(SkinDualQuaternionJob{&p.influences, split_, any_stretch_, {p.positions, {}, {}}, {dual, {}, {}}}),
              ErrorCode::ok);
  }

  std::vector<glm::vec3> linear, dual, normals;

 private:
  Scene scene_;
  test::PoseBuffer pose_;
  std::vector<Affine> model_;
  std::vector<JointMatrix> palette_;
  std::vector<RigidStretch> split_;
  bool any_stretch_ = false;
};

TEST(invariants, every_scene_passes_its_checks) {
  for (const Shape& shape : shapes())
    EXPECT_EQ(check(Character(shape.skeleton, 4).scene()), ErrorCode::ok) << shape.name;
  EXPECT_EQ(scenes::biped().joint_count(), 67u);
}

TEST(invariants, bind_pose_in_is_bind_pose_out) {
  for (const Shape& shape : shapes())
    for (const std::uint32_t influences : {1u, 2u, 3u, 4u, 7u}) {
      Character c(shape.skeleton, influences);
      c.pose_at_rest();
      c.deform();
      for (std::size_t v = 0; v < c.vertex_count(); ++v) {
        ASSERT_TRUE(test::is_near(c.linear[v], c.primitive().positions[v], 1e-5)) << shape.name;
        ASSERT_TRUE(test::is_near(c.dual[v], c.primitive().positions[v], 1e-5)) << shape.name;
        ASSERT_TRUE(test::is_near(c.normals[v], c.primitive().normals[v], 1e-6)) << shape.name;
      }
    }
}

TEST(invariants, rigid_motion_of_the_root_commutes_with_skinning) {
  test::FixedRandom random(3);
  for (const Shape& shape : shapes()) {
    Character still(shape.skeleton, 4), moved(shape.skeleton, 4);
    const Affine root = affine_from_transform(Transform{random.vec3(-1, 1), random.rotation(), glm::vec3(1)});
    still.pose_at(0.31);
    moved.pose_at(0.31);
    still.deform();
    moved.deform(root);
    for (std::size_t v = 0; v < still.vertex_count(); ++v) {
      ASSERT_TRUE(test::is_near(moved.linear[v], transform_point(root, still.linear[v]), 2e-5)) << shape.name;
      ASSERT_TRUE(test::is_near(moved.dual[v], transform_point(root, still.dual[v]), 2e-5)) << shape.name;
      ASSERT_TRUE(test::is_near(moved.normals[v], transform_vector(root, still.normals[v]), 1e-5)) << shape.name;
    }
  }
}

TEST(invariants, one_influence_moves_alike_in_both_kinds_of_skinning) {
  for (const Shape& shape : shapes()) {
    Character c(shape.skeleton, 1);
    c.pose_at(0.45);
    c.deform();
    for (std::size_t v = 0; v < c.vertex_count(); ++v)
      ASSERT_TRUE(test::is_near(c.linear[v], c.dual[v], 2e-5)) << shape.name;
  }
}

TEST(invariants, zero_morph_weights_change_nothing) {
  const Primitive face = scenes::face(3000, 12);
  std::vector<glm::vec3> positions(3000), normals(3000), scratch(3000);
  const std::vector<float> weights(12, 0.0f);
  const MorphVerticesJob job{&face.morphs, weights, {face.positions, face.normals, {}}, {positions, normals, {}},
                             scratch,      true};
  ASSERT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(positions, face.positions);
  EXPECT_EQ(normals, face.normals);
}

TEST(invariants, the_same_input_gives_the_same_bits) {
  const Skeleton skeleton = scenes::biped();
  Character first(skeleton, 4), second(skeleton, 4);
  second.pose_at(0.1);
  second.deform();  // another history
  first.pose_at(0.5);
  first.deform();
  second.pose_at(0.5);
  second.deform();
  EXPECT_EQ(first.linear, second.linear);
  EXPECT_EQ(first.dual, second.dual);
  EXPECT_EQ(first.normals, second.normals);
}

TEST(invariants, a_whole_frame_allocates_nothing) {
  Character c(scenes::biped(), 4);
  const Primitive face = scenes::face(500, 4);
  std::vector<glm::vec3> positions(500), normals(500), scratch(500);
  const std::vector<float> weights(4, 0.5f);
  const MorphVerticesJob morph{&face.morphs, weights, {face.positions, face.normals, {}}, {positions, normals, {}},
                               scratch,      true};
  const test::AllocationCounter counter;
  c.pose_at(0.2);
  c.deform();
  EXPECT_EQ(run(morph), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace sinew
