// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/plan.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The joints that poses can leave out, for sinew_needs.skeleton_lod of several plans of one scene. Owned by the
/// caller.
/// Finds the most joints that can be left out while no vertex moves farther than `tolerance_m`.
/// in   tolerance_m          >= 0, in the file's units
///      clips[clip_count]    clips that will play, SINEW_NONE = the rest pose; clip_count 0 = all clips
///      needs                only kinds of skinning are used; null = sinew_default_needs
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE (tolerance not finite or negative), SINEW_INDEX_OUT_OF_RANGE (clip),
///      SINEW_OUT_OF_MEMORY, the errors of sinew_plan_create for the needs
/// cost O(keys * joints) and more, allocates: for loading, not for frames
SINEW_API sinew_error sinew_skeleton_lod_create(const sinew_scene* scene, double tolerance_m, const uint32_t* clips,
                                                size_t clip_count, const sinew_needs* needs, sinew_skeleton_lod** out);
SINEW_API void sinew_skeleton_lod_destroy(sinew_skeleton_lod* lod);

typedef struct sinew_skeleton_lod_info {
  size_t struct_size;
  sinew_flags kept;      ///< [joints] 1 = poses have the joint; empty = all
  double measured_m;     ///< largest displacement that was found
  uint32_t left_out;     ///< number of joints that are left out
  uint32_t worst_joint;  ///< the joint whose vertices moved most; SINEW_NONE = none moved
  double tolerance_m;    ///< the requested limit
} sinew_skeleton_lod_info;
/// Describes a skeleton LOD. The array is a view into it.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_skeleton_lod(const sinew_skeleton_lod* lod, sinew_skeleton_lod_info* out);

#ifdef __cplusplus
}
#endif
