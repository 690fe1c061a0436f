// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/animation/skeleton.h"

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

/// Index of a humanoid bone in kHumanoidBones; kNone for a name that is none.
std::uint32_t humanoid_bone(std::string_view name) noexcept;

/// The joints that play the humanoid bones, by their names: those of VRM 1.0 and 0.x (leftUpperArm, J_Bip_L_UpperArm),
/// Mixamo and CMU motion capture (mixamorig:LeftForeArm, LeftUpLeg), Unreal (lowerarm_l, calf_l, ball_l), Rigify
/// (DEF-upper_arm.L, DEF-f_index.01.L), Daz (lShldrBend, lThighBend) and what is spelt like them. Joints between hips
/// and neck are spine, chest and upper chest in their order, whatever they are called; fingers are counted from the
/// hand on.
/// out  [kHumanoidBones] a joint, or kNone     cost O(J log J), allocates
std::vector<std::uint32_t> find_humanoid_bones(const Skeleton& skeleton);

/// The same where a file names the joints of the bones, for SkeletonMapOptions; empty where it names none of these.
std::vector<std::uint32_t> humanoid_bones_of(std::span<const NamedBone> bones);

/// The joint above the hips that carries a character through the world, by its name ("root", "Root_Bone"); the topmost
/// of several, kNone without one.     cost O(joints above the hips)
std::uint32_t find_root_joint(const Skeleton& skeleton, std::uint32_t hips);

}  // namespace sinew
