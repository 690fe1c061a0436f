// SPDX-License-Identifier: MIT
// The numbers that ozz-animation 0.16 expects in its own unit tests, asked of sinew. A group counts the numbers that
// are the same and those that differ by a rule of sinew's documentation; any other difference fails.
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {
namespace {

struct Group {
  const char* tests;  ///< names of ozz's tests
  Tally (*run)();
  Tally expected;
};

constexpr Group kGroups[] = {
    {"SamplingJob: Sampling", sampling_group, {680, 0}},
    {"SamplingJob: Sampling1Track0Key, 1Key, 2Keys, Sampling4Track2Keys", sampling_few_keys_group, {449, 1}},
    {"BlendingJob: Weight", blend_weights_group, {144, 0}},
    {"BlendingJob: JointWeights", blend_joint_weights_group, {96, 0}},
    {"BlendingJob: Normalize", blend_normalised_group, {104, 0}},
    {"BlendingJob: Threshold", blend_threshold_group, {80, 0}},
    {"BlendingJob: AdditiveWeight", additive_group, {240, 0}},
    {"BlendingJob: AdditiveJointWeight", additive_joint_weights_group, {160, 0}},
    {"LocalToModel: Transformation", model_matrices_group, {144, 0}},
    {"LocalToModel: TransformationFromTo", model_ranges_group, {672, 0}},
    {"SkinningJob: JobResult", skinning_group, {90, 0}},
    {"SkinningJob: JobResult, interleaved vertices", skinning_strides_group, {90, 0}},
    {"MotionExtractor: Extract", extraction_group, {144, 0}},
    {"MotionBlendingJob: Run", motion_blending_group, {43, 6}},
    {"IKAimJob: Correction", aim_corrections_group, {144, 0}},
    {"IKAimJob: Forward, Up, Pole, Twist", aim_directions_group, {64, 4}},
    {"IKAimJob: Offset", aim_offsets_group, {24, 8}},
    {"IKAimJob: AlignedTarget, TargetTooClose, Weight", aim_limits_group, {40, 8}},
    {"IKTwoBoneJob: StartJointCorrection", limb_corrections_group, {162, 0}},
    {"IKTwoBoneJob: Pole, Twist, PoleTargetAlignment", limb_poles_group, {99, 0}},
    {"IKTwoBoneJob: Soften, Weight, ZeroLengthStartTarget", limb_reach_group, {47, 21}},
    {"IKTwoBoneJob: MidAxis, Aligned, ZeroScale, ZeroLengthBoneChain", limb_shapes_group, {54, 0}},
    {"TrackSamplingJob: Constant, Bounds, Float", float_tracks_group, {15, 0}},
    {"TrackSamplingJob: Float2, Float3, Float4", vector_tracks_group, {72, 0}},
    {"TrackSamplingJob: Quaternion", rotation_tracks_group, {32, 0}},
    {"TrackEdgeTriggerJob: SquareStep", track_edges_group, {8, 0}},
};

TEST(ozz_numbers, are_those_of_sinew_or_differ_by_a_rule) {
  Tally all;
  for (const Group& group : kGroups) {
    SCOPED_TRACE(group.tests);
    const Tally found = group.run();
    EXPECT_EQ(found.same, group.expected.same);
    EXPECT_EQ(found.by_rule, group.expected.by_rule);
    all += found;
  }
  EXPECT_EQ(all, (Tally{3897, 48}));
}

}  // namespace
}  // namespace sinew::ozz
