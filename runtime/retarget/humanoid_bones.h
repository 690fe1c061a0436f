// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"

namespace sinew {

/// Humanoid bones by their names in VRM 1.0 (VRMC_vrm, "humanoid.humanBones"), parents before children.
inline constexpr std::array<std::string_view, 52> kHumanoidBones = {"hips",
                                                                    "spine",
                                                                    "chest",
                                                                    "upperChest",
                                                                    "neck",
                                                                    "head",
                                                                    "leftUpperLeg",
                                                                    "leftLowerLeg",
                                                                    "leftFoot",
                                                                    "leftToes",
                                                                    "rightUpperLeg",
                                                                    "rightLowerLeg",
                                                                    "rightFoot",
                                                                    "rightToes",
                                                                    "leftShoulder",
                                                                    "leftUpperArm",
                                                                    "leftLowerArm",
                                                                    "leftHand",
                                                                    "rightShoulder",
                                                                    "rightUpperArm",
                                                                    "rightLowerArm",
                                                                    "rightHand",
                                                                    "leftThumbMetacarpal",
                                                                    "leftThumbProximal",
                                                                    "leftThumbDistal",
                                                                    "leftIndexProximal",
                                                                    "leftIndexIntermediate",
                                                                    "leftIndexDistal",
                                                                    "leftMiddleProximal",
                                                                    "leftMiddleIntermediate",
                                                                    "leftMiddleDistal",
                                                                    "leftRingProximal",
                                                                    "leftRingIntermediate",
                                                                    "leftRingDistal",
                                                                    "leftLittleProximal",
                                                                    "leftLittleIntermediate",
                                                                    "leftLittleDistal",
                                                                    "rightThumbMetacarpal",
                                                                    "rightThumbProximal",
                                                                    "rightThumbDistal",
                                                                    "rightIndexProximal",
                                                                    "rightIndexIntermediate",
                                                                    "rightIndexDistal",
                                                                    "rightMiddleProximal",
                                                                    "rightMiddleIntermediate",
                                                                    "rightMiddleDistal",
                                                                    "rightRingProximal",
                                                                    "rightRingIntermediate",
                                                                    "rightRingDistal",
                                                                    "rightLittleProximal",
                                                                    "rightLittleIntermediate",
                                                                    "rightLittleDistal"};

/// Index of a name in kHumanoidBones; kNone if it is not a humanoid bone.
SINEW_API std::uint32_t humanoid_bone(std::string_view name) noexcept;

/// Finds the joints of the humanoid bones by their names. It knows these naming schemes and their variants:
///     VRM 1.0 and 0.x   leftUpperArm, J_Bip_L_UpperArm
///     Mixamo, CMU       mixamorig:LeftForeArm, LeftUpLeg
///     Unreal            lowerarm_l, calf_l, ball_l
///     Rigify            DEF-upper_arm.L, DEF-f_index.01.L
///     Daz               lShldrBend, lThighBend
/// Joints between hips and neck become spine, chest and upper chest in this order, whatever their names. Finger bones
/// are counted from the hand.
/// out  [kHumanoidBones] a joint, or kNone     cost O(J log J), allocates
SINEW_API std::vector<std::uint32_t> find_humanoid_bones(const Skeleton& skeleton);

/// Same, for files that name the joint of each bone (SkeletonMapOptions). Empty if the file names no humanoid bone.
SINEW_API std::vector<std::uint32_t> humanoid_bones_of(std::span<const NamedBone> bones);

/// The joint above the hips that carries a character through the world, by its name ("root", "Root_Bone"). The topmost
/// if there are several, kNone if there is none.     cost O(joints above the hips)
SINEW_API std::uint32_t find_root_joint(const Skeleton& skeleton, std::uint32_t hips);

}  // namespace sinew
