// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/plan.h"
#include "runtime/c/pose.h"
#include "runtime/c/reference.h"

#ifdef __cplusplus
extern "C" {
#endif

// How left and right of a scene are exchanged: for layers that play mirrored (sinew_needs.mirror and
// SINEW_LAYER_MIRRORED), and for poses. Joints are paired by their names, or by their positions if their names give no
// side. Morph targets are paired by their names. Owned by the caller.

/// Pairs the joints and morph targets of a scene.
/// in   scene  may be destroyed afterwards
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY;   cost O(joints log joints), without names O(joints^2); allocates
SINEW_API sinew_error sinew_mirror_create(const sinew_scene* scene, sinew_mirror** out);
/// Like sinew_mirror_create, with a given reference pose. It should be symmetric, and mirroring does not change it.
/// SINEW_REFERENCE_CHOSEN is what sinew_mirror_create does: the rest pose, or the bind pose if that is less than half
/// as asymmetric.
/// in   reference  sinew_reference
///      given      of the scene; read for SINEW_REFERENCE_GIVEN only
/// err  as sinew_mirror_create, and SINEW_UNSUPPORTED (reference), SINEW_SIZE_MISMATCH (given)
SINEW_API sinew_error sinew_mirror_create_about(const sinew_scene* scene, uint32_t reference, const sinew_pose* given,
                                                sinew_mirror** out);
SINEW_API void sinew_mirror_destroy(sinew_mirror* mirror);

typedef struct sinew_mirror_info {
  size_t struct_size;
  sinew_vec3 plane_normal;  ///< unit, in model space
  float plane_offset;       ///< distance from the origin, along the normal
  sinew_indices partner;    ///< [joints] the joint whose motion each joint gets; itself if it has no partner
  sinew_indices unpaired;   ///< rising: joints without a partner, although their name or position suggests one
  uint32_t reference;       ///< sinew_reference: as requested, or as chosen
} sinew_mirror_info;
/// Describes a mirror. The arrays are views into it.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_mirror(const sinew_mirror* mirror, sinew_mirror_info* out);

/// Mirrors a pose: each joint gets the reflected transform of its partner.
/// in   pose  of the mirror's scene
/// out  mirrored  of the same size; must not overlap
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost O(joints), no allocation
SINEW_API sinew_error sinew_mirror_pose(const sinew_mirror* mirror, const sinew_pose* pose, const sinew_pose* mirrored);

#ifdef __cplusplus
}
#endif
