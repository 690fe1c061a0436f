// SPDX-License-Identifier: MIT
#pragma once
/// Motion of one skeleton on another. make_skeleton_map pairs joints by the names of bones or by a list. The map then
/// bakes animations, or retargets poses while they play. Morph weights and properties go by name, and twist joints
/// share a rotation. make_detail_map is for two skeletons of one body: a ragdoll and the character that it moves.
///
///     const sinew::SkeletonMap map = make_skeleton_map(actor, knight);
///     const sinew::Animation walk = retarget_animation(actor.animations[0], map, actor.skeleton, knight.skeleton);
#include "runtime/retarget/detail_map.h"
#include "runtime/retarget/humanoid_bones.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_pose.h"
#include "runtime/retarget/retarget_properties.h"
#include "runtime/retarget/retarget_weights.h"
#include "runtime/retarget/share_twist.h"
#include "runtime/retarget/skeleton_map.h"
