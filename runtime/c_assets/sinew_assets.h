// SPDX-License-Identifier: MIT
#pragma once
// Asset files (.sinew) for engines that speak C. Link sinew::c_assets beside sinew::c. For C11 and C++.
#include "runtime/c/messages.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Whether bytes begin as those of asset files do.
int sinew_looks_like_assets(const void* bytes, size_t byte_count);

/// The scene of an asset file: its skeleton, and model and clips where it has them. Any bytes are welcome; the scene
/// owns what it has, so they may go afterwards.
/// out  scene     owned by the caller
///      messages  owned by the caller, why the bytes were refused; may be null. Given for SINEW_BAD_FILE only
/// err  SINEW_NULL_ARGUMENT, SINEW_BAD_FILE, SINEW_OUT_OF_MEMORY;   cost O(bytes), allocates
sinew_error sinew_assets_read(const void* bytes, size_t byte_count, sinew_scene** scene, sinew_messages** messages);

/// Appends the clips of an asset file to a scene of the same skeleton.
/// in   scene  without plans: those refer to its clips
/// err  SINEW_NULL_ARGUMENT, SINEW_BUSY (the scene has plans), SINEW_BAD_FILE (also clips of another skeleton),
///      SINEW_OUT_OF_MEMORY. After an error the scene is as before.
sinew_error sinew_assets_add_clips(sinew_scene* scene, const void* bytes, size_t byte_count, sinew_messages** messages);

#ifdef __cplusplus
}
#endif
