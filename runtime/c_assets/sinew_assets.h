// SPDX-License-Identifier: MIT
#pragma once
// Asset files (.sinew) for engines that speak C. Link sinew::c_assets beside sinew::c. For C and C++.
#include "runtime/base/api.h"
#include "runtime/c/graph/graph.h"
#include "runtime/c/messages.h"
#include "runtime/c/pages.h"
#include "runtime/c/scene.h"
#include "runtime/c/skeleton_lod.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Returns 1 if the bytes begin like an asset file, else 0.
SINEW_API int sinew_looks_like_assets(const void* bytes, size_t byte_count);

/// Reads the scene of an asset file: its skeleton, and its model and clips if it has them. Any bytes may be passed. The
/// scene owns its memory, so the bytes may be freed afterwards.
/// out  scene     owned by the caller
///      messages  owned by the caller, why the bytes were refused; may be null. Given for SINEW_BAD_FILE only
/// err  SINEW_NULL_ARGUMENT, SINEW_BAD_FILE, SINEW_OUT_OF_MEMORY;   cost O(bytes), allocates
SINEW_API sinew_error sinew_assets_read(const void* bytes, size_t byte_count, sinew_scene** scene,
                                        sinew_messages** messages);

/// How the clips of a file are cut into pages (sinew.h).
typedef struct sinew_page_tables sinew_page_tables;

/// Like sinew_assets_read, but clips that are stored in pages get only the first key of each track.
/// out  tables  owned by the caller
SINEW_API sinew_error sinew_assets_read_first_keys(const void* bytes, size_t byte_count, sinew_scene** scene,
                                                   sinew_page_tables** tables, sinew_messages** messages);
SINEW_API void sinew_page_tables_destroy(sinew_page_tables* tables);

/// Number of pages of a clip, and their duration in seconds. Both are 0 if the clip has no pages or does not exist.
SINEW_API size_t sinew_page_tables_count(const sinew_page_tables* tables, uint32_t clip, double* page_s);
/// Position of a page in the file. Returns its size in bytes; 0 for a page that does not exist.
SINEW_API size_t sinew_page_tables_place(const sinew_page_tables* tables, uint32_t clip, size_t page, uint64_t* offset);

/// Like sinew_paged_clip_load_page, for the bytes of a page as they are in the file, packed or not.
SINEW_API sinew_error sinew_assets_load_page(sinew_paged_clip* paged, size_t page, const void* bytes, size_t byte_count,
                                             int* taken, sinew_messages** messages);

/// Reads a skeleton LOD of a file (sinew compile --joint-tolerance), for sinew_needs.skeleton_lod.
/// in   scene  of this file, or with the same skeleton
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE (the file has fewer), SINEW_BAD_FILE (also one of another
///      skeleton), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_assets_read_skeleton_lod(const void* bytes, size_t byte_count, const sinew_scene* scene,
                                                     size_t level, sinew_skeleton_lod** out, sinew_messages** messages);

/// Appends the clips of an asset file to a scene of the same skeleton.
/// in   scene  must have no plans, since plans refer to its clips
/// err  SINEW_NULL_ARGUMENT, SINEW_BUSY (the scene has plans), SINEW_BAD_FILE (also clips of another skeleton),
///      SINEW_OUT_OF_MEMORY. After an error the scene is as before.
SINEW_API sinew_error sinew_assets_add_clips(sinew_scene* scene, const void* bytes, size_t byte_count,
                                             sinew_messages** messages);

/// Reads a motion graph of a file by its name (graph/graph.h).
/// err  SINEW_INDEX_OUT_OF_RANGE (the file has no graph of this name), SINEW_BAD_FILE (the file or the graph is damaged;
///      `messages` says where), SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_assets_read_graph(const void* bytes, size_t byte_count, const char* name, sinew_graph** out,
                                              sinew_messages** messages);

#ifdef __cplusplus
}
#endif
