// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/retarget/humanoid_bones.h"

namespace sinew {

/// How a joint of the target follows one of the source.
struct MappedJoint {
  std::uint32_t target = 0, source = 0;
  std::uint32_t above_target = kNone, above_source = kNone;  ///< nearest mapped joints above; kNone = model space
  Quat<double> before{1, 0, 0, 0}, after{1, 0, 0, 0};        ///< of the equation
  bool moves = false;              ///< its translation follows, scaled; else bones keep their length
  Mat3<double> translation{1.0};   ///< from the space of `above_source` to that of the target's parent
  Vec3<double> source_place{0.0};  ///< at rest, in the space of `above_source`
};

/// From the poses of one skeleton to those of another. Made once by make_skeleton_map; immutable.
struct SkeletonMap {
  std::vector<MappedJoint> joints;  ///< rising targets: parents before children
  bool by_names = false;            ///< the skeletons share names, and scale tracks are carried
  double height_ratio = 1.0;  ///< of the hips, or of the top joints, above the lowest mapped joint; target to source
  std::vector<std::uint32_t> unmapped_source, unmapped_target;  ///< rising
  /// [kHumanoidBones] joints of the target that play them, or kNone
  std::vector<std::uint32_t> target_bones = std::vector<std::uint32_t>(kHumanoidBones.size(), kNone);
};

/// How far the reference poses of humanoids are made to agree.
enum class LimbDirections : std::uint8_t {
  of_source,  ///< arms and legs point where those of the source do, whatever their rest poses (A-pose, T-pose)
  of_rest,    ///< the rest pose becomes the rest pose
};

/// What becomes of the translations of mapped joints.
enum class TranslationRule : std::uint8_t {
  hips_by_height,  ///< the path of top joints and of hips is scaled by the ratio of heights; others keep their place
                   ///< against the parent, or are scaled by the ratio of lengths where the skeletons share names
  by_length,       ///< each is scaled by how long its bone is against that of the source: bones may stretch
  keep             ///< all keep their place against the parent
};

/// A rule for a joint of the target and all below it, as far as no other one is given there.
struct ChainRule {
  std::uint32_t joint = 0;
  TranslationRule rule = TranslationRule::hips_by_height;
};

struct SkeletonMapOptions {
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< joints {source, target}; where given, nothing else is mapped
  LimbDirections limbs = LimbDirections::of_source;
  TranslationRule translations = TranslationRule::hips_by_height;
  std::vector<ChainRule> chains;  ///< other rules than `translations`
  /// [kHumanoidBones] joints that play the bones, or kNone, where files say so (humanoid_bones_of); empty = they are
  /// found by names
  std::vector<std::uint32_t> source_bones, target_bones;
};

/// Maps joints of equal names, or joints that play the same humanoid bone (humanoid_bones.h): what finds more. Where
/// both find as many, names count, unless a file says which joints the bones are. A joint whose mapped joint above is
/// not above it in both skeletons is left out. A root joint above the hips follows the other root joint; where one
/// alone has it, the hips carry the whole path.
///
/// What is carried is how far each joint is turned from the rest pose, in model space. With W the rotations at rest and
/// G those of the pose in model space, m the mapped joint above j, Q = G_m^-1 G_j the rotation of j seen from m (over
/// all joints between), and primes for the target with P' the parent of j':
/// eq   G'_j = (G_j W_j^-1) C'_j,  C'_j = R_j W'_j;  q'_j = (W'_P'^-1 W'_m C'_m^-1 W_m) Q (W_j^-1 C'_j)
///      Without R this is q' = L' W'^-1 N W' with N = W L^-1 q W^-1 (VRMC_vrm_animation, "humanoid"), for any axes and
///      roll, and for joints that one side alone has. R_j is the shortest arc from the target's limb to the source's in
///      rest poses, for upper and lower arms and legs, and that of the lower arm for hands and fingers; else the
///      identity. t' = r' + k R (p - p_rest), p the place of j seen from m, k by TranslationRule. Scales of parents are
///      taken out.
/// in   skeletons  rest rotations unit;   options  joints in range
/// cost O(J log J), allocates
SkeletonMap make_skeleton_map(const Skeleton& source, const Skeleton& target, const SkeletonMapOptions& options = {});

}  // namespace sinew
