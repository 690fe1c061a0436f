// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/messages.h"
#include "runtime/c/plan.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Compiled clips as bytes for a file. Owned by the caller.
typedef struct sinew_clip_block sinew_clip_block;

/// Saves clips [first_clip, first_clip + clip_count) of the scene.
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_clips_save(const sinew_scene* scene, uint32_t first_clip, size_t clip_count,
                                       sinew_clip_block** out);
SINEW_API sinew_flags sinew_clip_block_bytes(const sinew_clip_block* block);
SINEW_API void sinew_clip_block_destroy(sinew_clip_block* block);

/// Returns 1 if the bytes begin like a block of saved clips, else 0.
SINEW_API int sinew_looks_like_clips(const void* bytes, size_t byte_count);

/// Replaces the scene's clips from `first_clip` on by saved clips, for example by clips that were packed within an
/// error budget offline. They give the same bits as the clips that were saved. Any bytes may be passed. Clip bounds,
/// skeleton LODs and root motion still follow the animations of the file.
/// in   scene  must have no plans, since plans refer to its clips
/// out  messages  owned by the caller, why the bytes were refused; may be null. Given for SINEW_BAD_FILE only
/// err  SINEW_NULL_ARGUMENT, SINEW_BUSY (the scene has plans), SINEW_BAD_FILE, SINEW_INDEX_OUT_OF_RANGE (more clips
///      than the scene has from first_clip on), SINEW_SIZE_MISMATCH (clips of other joints, morph weights or
///      properties), SINEW_OUT_OF_MEMORY. After an error the scene is as before.
SINEW_API sinew_error sinew_clips_load(sinew_scene* scene, uint32_t first_clip, const void* bytes, size_t byte_count,
                                       sinew_messages** messages);

/// Boxes that hold the mesh instances at every time of a clip, if it plays alone at weight 1. They need no pose, so
/// test them against the view before a frame, and skip instances out of view (sinew_frame_input: out_of_view, asleep).
/// in   needs  only kinds of skinning and skeleton LOD are used; null = sinew_default_needs
///      clip   SINEW_NONE = the rest pose
/// out  boxes[capacity]  in the space below sinew_frame_input.root
///      count  boxes written: one for each instance. 0 if none can be computed; then treat everything as in view. This
///      happens for meshes that correctives morph, skinned meshes with parts that are not skinned, and very long clips
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (clip), SINEW_SIZE_MISMATCH (capacity below the instances),
///      the errors of sinew_plan_create for the needs
/// cost O(keys * joints + vertices), of asset files that hold boxes O(instances); allocates
SINEW_API sinew_error sinew_clip_bounds(const sinew_scene* scene, const sinew_needs* needs, uint32_t clip,
                                        sinew_box* boxes, size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif
