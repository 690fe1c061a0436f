// SPDX-License-Identifier: MIT
// Jobs without memory: run(job) answers with a code, and a debug build ends run_unchecked(job) with a sentence.
#include <gtest/gtest.h>

#include <array>

#include "runtime/deform/blend_combinations.h"
#include "runtime/deform/flat_normals.h"
#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/surface_normals.h"
#include "runtime/geometry_cache/block_motion.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/joint_palette.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/retarget_pose.h"
#include "runtime/retarget/share_twist.h"

namespace sinew {
namespace {

constexpr std::size_t kCount = 16;

/// A view with a size and no memory.
template <class T>
std::span<T> without_memory() {
  return {static_cast<T*>(nullptr), kCount};
}

const PoseSpan kNoPose{nullptr, kCount, PoseSpan::stride_for(kCount)};

TEST(job_nulls, default_jobs_that_need_an_asset_are_refused) {
  EXPECT_EQ(run(SampleClipJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(CorrectPoseJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(LocalToModelJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(JointPaletteJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(MirrorPoseJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(MorphVerticesJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(BlendCombinationsJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(FlatNormalsJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(SurfaceNormalsJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(SurfaceTangentsJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(RetargetPoseJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(HoldFeetJob{}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(ShareTwistJob{}), ErrorCode::size_mismatch);
}

TEST(job_nulls, poses_without_memory_are_refused) {
  EXPECT_EQ(run(BlendPosesJob{{}, kNoPose, kNoPose}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(AddPoseJob{kNoPose, kNoPose, 1.0f, {}, kNoPose}), ErrorCode::size_mismatch);
  const TwistMap no_twists;
  EXPECT_EQ(run(ShareTwistJob{&no_twists, kNoPose}), ErrorCode::size_mismatch);
  const FeetMap no_feet;
  EXPECT_EQ(run(HoldFeetJob{&no_feet, 0.0f, kNoPose, kNoPose}), ErrorCode::size_mismatch);
  Skeleton skeleton;
  skeleton.parents.assign(kCount, kNone);
  skeleton.rest.resize(kCount);
  std::array<Affine, kCount> model;
  EXPECT_EQ(run(LocalToModelJob{&skeleton, kNoPose, {}, model}), ErrorCode::size_mismatch);
}

TEST(job_nulls, spans_without_memory_are_refused) {
  std::array<RigidStretch, kCount> split;
  EXPECT_EQ(run(SplitPaletteJob{without_memory<const JointMatrix>(), split}), ErrorCode::size_mismatch);
  Skin skin;
  skin.joints.assign(kCount, 0);
  skin.inverse_bind.resize(kCount);
  std::array<Affine, kCount> model;
  EXPECT_EQ(run(JointPaletteJob{&skin, model, without_memory<JointMatrix>()}), ErrorCode::size_mismatch);

  const VertexInfluences nothing;
  const VertexInput in{without_memory<const glm::vec3>(), {}, {}};
  const VertexOutput out{without_memory<glm::vec3>(), {}, {}};
  const auto palette = without_memory<const JointMatrix>();
  EXPECT_EQ(run(SkinLinearJob{&nothing, palette, in, out}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(SkinDualQuaternionJob{&nothing, split, true, in, out, {}, {}}), ErrorCode::size_mismatch);
  EXPECT_EQ(
      run(SkinCenterOfRotationJob{&nothing, palette, split, true, without_memory<const glm::vec3>(), in, out, {}}),
      ErrorCode::size_mismatch);
  EXPECT_EQ(run(BlendCombinationsJob{&nothing, palette, {}}), ErrorCode::size_mismatch);
  const MorphSet no_targets;
  EXPECT_EQ(run(MorphVerticesJob{&no_targets, {}, in, out, without_memory<glm::vec3>()}), ErrorCode::size_mismatch);
  const FlatFaces no_faces;
  EXPECT_EQ(run(FlatNormalsJob{&no_faces, in.positions, in.positions, false, out.positions}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(EmitPointsJob{.out = out.positions}), ErrorCode::size_mismatch);
}

TEST(job_nulls, indices_outside_of_the_vertices_are_refused) {
  std::array<glm::vec3, 4> in{}, out{};
  FlatFaces faces;
  faces.alone = {0, 1, 4};
  EXPECT_EQ(run(FlatNormalsJob{&faces, in, in, false, out}), ErrorCode::index_out_of_range);
  faces.alone = {0, 1, 3};
  EXPECT_EQ(run(FlatNormalsJob{&faces, in, in, false, out}), ErrorCode::ok);
  faces.streams = {{{0, 1, 2}, 3}};
  EXPECT_EQ(run(FlatNormalsJob{&faces, in, in, false, out}), ErrorCode::index_out_of_range);

  SurfaceFaces surface{{0, 1, 4}, {0, 1, 2, 3}, 4, {}};
  std::array<glm::vec4, 16> sums{};
  EXPECT_EQ(run(SurfaceNormalsJob{&surface, in, in, false, sums, out}), ErrorCode::index_out_of_range);
  surface.corners = {0, 1, 3};
  EXPECT_EQ(run(SurfaceNormalsJob{&surface, in, in, false, sums, out}), ErrorCode::ok);
  surface.point_of_vertex[3] = 4;
  EXPECT_EQ(run(SurfaceNormalsJob{&surface, in, in, false, sums, out}), ErrorCode::index_out_of_range);
}

#ifndef NDEBUG
TEST(job_nulls, unchecked_runs_end_with_a_sentence_in_debug_builds) {
  EXPECT_DEATH(run_unchecked(SampleClipJob{}), "only a job that check\\(\\) accepts");
  EXPECT_DEATH(run_unchecked(CorrectPoseJob{}), "only a job that check\\(\\) accepts");
}
#endif

}  // namespace
}  // namespace sinew
