// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/animation/pose_reference.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/retarget/humanoid_bones.h"

namespace sinew {

/// How a joint of the target follows one joint of the source.
struct MappedJoint {
  std::uint32_t target = 0, source = 0;
  std::uint32_t above_target = kNone, above_source = kNone;  ///< nearest mapped ancestors; kNone = model space
  Quat<double> before{1, 0, 0, 0}, after{1, 0, 0, 0};  ///< q' = before Q after in the equation of make_skeleton_map
  bool moves = false;              ///< the translation follows the source, scaled; otherwise the bone keeps its length
  Mat3<double> translation{1.0};   ///< from the space of `above_source` to the space of the target's parent
  Vec3<double> source_place{0.0};  ///< at rest, in the space of `above_source`
};

/// Maps poses of one skeleton to another. Made once by make_skeleton_map; immutable.
struct SkeletonMap {
  std::vector<MappedJoint> joints;  ///< rising target indices: parents before children
  bool by_names = false;            ///< the skeletons share joint names, so scale tracks are retargeted too
  double height_ratio = 1.0;        ///< target to source: height of hips or top joints above the lowest mapped joint
  std::vector<std::uint32_t> unmapped_source, unmapped_target;  ///< joints without a counterpart, rising
  /// [kHumanoidBones] joint of the target for each humanoid bone, or kNone
  std::vector<std::uint32_t> target_bones = std::vector<std::uint32_t>(kHumanoidBones.size(), kNone);
  PoseReference source_reference = PoseReference::rest, target_reference = PoseReference::rest;
  std::vector<Transform> source_pose, target_pose;  ///< [J] the reference poses; empty = the rest pose.
  /// Mean angle between the bones of mapped joints and those of the joints that they follow, in the reference poses.
  /// A bone runs from the nearest mapped ancestor to the joint.
  double bone_angle_rad = 0.0;
};

/// How the rest poses of two humanoids are aligned.
enum class LimbDirections : std::uint8_t {
  of_source,  ///< arms and legs point where those of the source point, whatever the rest poses are (A-pose, T-pose)
  of_rest,    ///< the rest pose of the source becomes the rest pose of the target
};

/// How the translations of mapped joints are retargeted.
enum class TranslationRule : std::uint8_t {
  /// Translations of top joints, of the hips and of their ancestors are scaled by the height ratio. Other joints keep
  /// their rest translation. With SkeletonMap::by_names, the translations of these other joints follow the source, each
  /// scaled by the ratio of its bone lengths.
  hips_by_height,
  by_length,  ///< each translation is scaled by the length ratio of its bones, so bones may stretch
  keep        ///< all joints keep their rest translation
};

/// Overrides the translation rule of a joint of the target and its descendants, down to the next joint with a rule.
struct ChainRule {
  std::uint32_t joint = 0;
  TranslationRule rule = TranslationRule::hips_by_height;
};

struct SkeletonMapOptions {
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< joints {source, target}; if given, only these are mapped
  LimbDirections limbs = LimbDirections::of_source;
  TranslationRule translations = TranslationRule::hips_by_height;
  std::vector<ChainRule> chains;  ///< exceptions from `translations`
  /// [kHumanoidBones] Joint of each humanoid bone, or kNone, for files that say so (humanoid_bones_of). Empty = bones
  /// are found by names.
  std::vector<std::uint32_t> source_bones, target_bones;
  /// [J] Reference poses: for each skeleton, local transforms of a pose. Both bodies must have the same posture in
  /// them. Empty = the rest pose, or what make_skeleton_map of scenes chooses (map_scenes.h).
  std::span<const Transform> source_reference = {}, target_reference = {};
};

/// Checks options that come from a file or a script. make_skeleton_map breaks a contract if they are bad.
/// err  index_out_of_range (a joint);  unsupported (a joint of the target in two pairs or two chains);  size_mismatch
///      (bones, reference poses)
SINEW_API ErrorCode check(const SkeletonMapOptions& options, const Skeleton& source, const Skeleton& target);

/// Maps joints of equal names, or joints of the same humanoid bone (humanoid_bones.h), whichever maps more joints. On a
/// tie names win, unless a file says which joints the bones are. A joint is left out if its nearest mapped ancestor is
/// not an ancestor in both skeletons. A root joint above the hips follows the other skeleton's root joint. If only one
/// skeleton has a root joint, the hips carry the whole path.
///
/// The map carries rotations relative to the reference pose, which is the rest pose unless the options give another
/// one. Notation: W rotations of the reference and G of the pose in model space, m the nearest mapped ancestor of j.
/// Q = G_m^-1 G_j is the rotation of j relative to m (over all joints between). Primes mark the target, and P' is the
/// parent of j'.
/// eq   G'_j = (G_j W_j^-1) C'_j,  C'_j = R_j W'_j;  q'_j = B Q A,  B = W'_P'^-1 W'_m C'_m^-1 W_m,  A = W_j^-1 C'_j
///      Without R this is q' = L' W'^-1 N W' with N = W L^-1 q W^-1, L the local reference rotation
///      (VRMC_vrm_animation, "humanoid"). It holds for any bone axes and roll, and for joints that only one skeleton
///      has. R_j aligns limbs: for upper and lower arms and legs it is the shortest arc from the target's limb to the
///      source's limb in the reference poses. Hands and fingers use the R of the lower arm. All other joints use the
///      identity, as do all joints with LimbDirections::of_rest or if the map is by names.
///      t' = t'_ref + k B (p - p_ref), p the place of j relative to m, k by TranslationRule. Scales of parents are
///      divided out.
/// in   skeletons  rest rotations unit;   options  that check accepts, reference rotations unit
/// cost O(J log J), allocates
SINEW_API SkeletonMap make_skeleton_map(const Skeleton& source, const Skeleton& target,
                                        const SkeletonMapOptions& options = {});

}  // namespace sinew
