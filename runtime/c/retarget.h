// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/library.h"
#include "runtime/c/pose.h"
#include "runtime/c/reference.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How poses and clips of one skeleton, the source, go to another, the target. Joints of equal names are mapped, or
/// joints that are the same bone of a human body, whichever of the two maps more. Bones are known by the names of VRM,
/// Mixamo, Unreal, Rigify and motion capture. Owned by the caller; any number of threads may read it.
typedef struct sinew_skeleton_map sinew_skeleton_map;

/// This struct never grows.
typedef struct sinew_joint_pair {
  uint32_t source, target;
} sinew_joint_pair;

typedef enum sinew_limb_directions {
  SINEW_LIMBS_OF_SOURCE = 0,  ///< arms and legs point where those of the source point, whatever the rest poses are
  SINEW_LIMBS_OF_REST = 1     ///< the rest pose of the source becomes the rest pose of the target
} sinew_limb_directions;

/// How the translations of mapped joints are retargeted.
typedef enum sinew_translation_rule {
  SINEW_HIPS_BY_HEIGHT = 0,  ///< the path of top joints and hips is scaled by the ratio of heights; other bones keep
                             ///< their lengths
  SINEW_BY_LENGTH = 1,       ///< each translation is scaled by the length ratio of its bones, so bones may stretch
  SINEW_KEEP = 2             ///< all joints keep their rest translation
} sinew_translation_rule;

/// A rule for a joint of the target and its descendants, down to descendants with a rule of their own. This struct
/// never grows.
typedef struct sinew_chain_rule {
  uint32_t joint;
  uint32_t rule;  ///< a value of sinew_translation_rule
} sinew_chain_rule;

typedef struct sinew_skeleton_map_options {
  size_t struct_size;
  const sinew_joint_pair* pairs;  ///< if given, only these joints are mapped; copied
  size_t pair_count;
  uint32_t limbs;                  ///< a value of sinew_limb_directions
  uint32_t translations;           ///< a value of sinew_translation_rule
  const sinew_chain_rule* chains;  ///< exceptions from `translations`; copied
  size_t chain_count;
  /// sinew_reference: poses in which both bodies have the same posture. SINEW_REFERENCE_CHOSEN takes the rest and bind
  /// poses in which the bones of both bodies point most alike. Rest poses stay unless others are clearly better.
  uint32_t source_reference, target_reference;
  const sinew_pose *source_pose, *target_pose;  ///< read for SINEW_REFERENCE_GIVEN only; copied
} sinew_skeleton_map_options;

/// Maps the joints of two scenes.
/// in   source, target  must outlive the map;   options  null = no pairs or chains, SINEW_LIMBS_OF_SOURCE,
///                      SINEW_HIPS_BY_HEIGHT, SINEW_REFERENCE_CHOSEN
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (pairs, chains), SINEW_OUT_OF_MEMORY,
///      SINEW_UNSUPPORTED (limbs, a rule, a reference, a joint of the target in two pairs or two chains),
///      SINEW_SIZE_MISMATCH (a given pose)
/// cost O(joints log joints), allocates
SINEW_API sinew_error sinew_skeleton_map_create(const sinew_scene* source, const sinew_scene* target,
                                                const sinew_skeleton_map_options* options, sinew_skeleton_map** out);
SINEW_API void sinew_skeleton_map_destroy(sinew_skeleton_map* map);

typedef struct sinew_skeleton_map_info {
  size_t struct_size;
  const sinew_joint_pair* pairs;  ///< [pair_count] sorted by joints of the target
  size_t pair_count;
  sinew_indices unmapped_source, unmapped_target;  ///< joints that are not mapped, rising
  double height_ratio;                             ///< target to source
  uint32_t leg_count;                              ///< legs whose feet sinew_hold_feet holds
  uint32_t twist_count;                         ///< twist joints of the target, which share the twist of arms and legs
  uint32_t source_reference, target_reference;  ///< sinew_reference: as requested, or as chosen
  double bone_angle_rad;                        ///< mean angle between bones of both bodies in their reference poses
} sinew_skeleton_map_info;
/// Describes a map. The arrays are views into it.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_skeleton_map(const sinew_skeleton_map* map, sinew_skeleton_map_info* out);

/// Retargets a pose of the source to the target. Twist joints of the target share the twist of hands, feet, upper arms
/// and thighs.
/// in   pose  of the source
/// out  scratch     of the source; overwritten. Must not overlap `pose`
///      retargeted  of the target; must not overlap the others
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost O(joints), no allocation
SINEW_API sinew_error sinew_retarget_pose(const sinew_skeleton_map* map, const sinew_pose* pose,
                                          const sinew_pose* scratch, const sinew_pose* retargeted);

/// Holds the feet of a retargeted pose. A foot on the ground follows the path of the source's foot, scaled by the ratio
/// of heights. It stands still while the source's foot stands still. Thighs and shanks turn; hips come down where legs
/// are too short.
/// in   ground    height of the ground relative to the source's feet at rest, in its units (sinew_find_ground)
///      pose      of the source
///      held      the result of sinew_retarget_pose for `pose`; changed in place
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH, SINEW_NOT_FINITE;   cost O(joints of legs), no allocation
SINEW_API sinew_error sinew_hold_feet(const sinew_skeleton_map* map, float ground, const sinew_pose* pose,
                                      const sinew_pose* held);

/// Estimates the height of the floor in a clip of the source, relative to the floor under the feet of the rest pose.
/// Over the time of the clip, 5 % of the heights of the lower foot are smaller. So a foot that dips below the floor for
/// a moment does not count. Without legs in the map it is 0.
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE, SINEW_OUT_OF_MEMORY;   cost O(duration * joints), allocates
SINEW_API sinew_error sinew_find_ground(const sinew_skeleton_map* map, uint32_t clip, float* ground);

/// Adds a clip of the source to a library as a clip of the target, key by key where joints follow one other joint.
/// Morph targets follow morph targets of equal names, on any mesh. Properties follow properties of equal names, if
/// clips of the target's scene animate them too.
/// in   library    of the target's skeleton, or one that shares names with it
///      hold_feet  1 = feet on the ground are held, as by sinew_hold_feet
///      if_unbound, unbound  as in sinew_library_add
/// err  SINEW_INDEX_OUT_OF_RANGE (clip), and as sinew_library_add
/// cost O(keys * joints), with held feet O(duration * joints); allocates
SINEW_API sinew_error sinew_library_add_retargeted(sinew_library* library, const sinew_skeleton_map* map, uint32_t clip,
                                                   uint32_t hold_feet, uint32_t if_unbound, sinew_messages** unbound);

#ifdef __cplusplus
}
#endif
