// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose.h"
#include "runtime/c/retarget.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Poses between two skeletons of one body in different detail: the bodies of a ragdoll (coarse), and the character
/// that is drawn (fine). Both fit each other in their rest poses; their joints may have other axes and places. Owned by
/// the caller; any number of threads may read it.
typedef struct sinew_detail_map sinew_detail_map;

/// in   coarse, fine  must outlive the map
///      pairs[count]  source = joint of `coarse`, target = joint of `fine`; none = joints of equal names
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE, SINEW_UNSUPPORTED (a joint in two pairs, a scale of 0 at rest,
///      a joint of `fine` with a fixed matrix), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_detail_map_create(const sinew_scene* coarse, const sinew_scene* fine,
                                              const sinew_joint_pair* pairs, size_t count, sinew_detail_map** out);
SINEW_API void sinew_detail_map_destroy(sinew_detail_map* map);

/// Where a pose of the character wants the bodies to be.
/// in   fine[fine_count]  model matrices, one for each joint of the character
/// out  coarse[coarse_count]  one for each joint of the ragdoll
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost O(joints of the ragdoll), no allocation
SINEW_API sinew_error sinew_coarse_from_fine(const sinew_detail_map* map, const sinew_affine* fine, size_t fine_count,
                                             sinew_affine* coarse, size_t coarse_count);

/// Bytes of `scratch` for sinew_fine_from_coarse, which are aligned to 8.
SINEW_API size_t sinew_detail_map_scratch(const sinew_detail_map* map);

/// Moves a pose of the character to where the bodies are. Joints between two bodies share what the end lacks, and
/// joints that no body moves, such as fingers, keep their local transforms.
/// in   coarse[coarse_count]  model matrices of the bodies
///      keep_lengths  1 = bones keep their lengths and take only rotations; 0 = joints stand exactly at their bodies
/// io   local  the animated pose
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH, SINEW_NOT_FINITE;   cost O(joints of the character), no allocation
SINEW_API sinew_error sinew_fine_from_coarse(const sinew_detail_map* map, const sinew_affine* coarse,
                                             size_t coarse_count, const sinew_pose* local, void* scratch,
                                             size_t scratch_bytes, int keep_lengths);

#ifdef __cplusplus
}
#endif
