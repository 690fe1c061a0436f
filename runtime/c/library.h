// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/messages.h"
#include "runtime/c/plan.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Clips of any number of files, bound by the names of joints to one skeleton. Scenes with models on that skeleton
/// share them. A library may grow while plans run: a plan keeps the clips that it was compiled for.
typedef struct sinew_library sinew_library;

/// Treatment of clips that move joints, morph targets or properties that the skeleton or the scene does not have.
typedef enum sinew_if_unbound {
  SINEW_LEAVE_OUT = 0,  ///< clips play without the channels that are missing
  SINEW_REFUSE = 1      ///< nothing is added, and SINEW_UNBOUND is returned
} sinew_if_unbound;

/// Creates an empty library.
/// in   scene  gives the skeleton; it may be destroyed afterwards
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY;   cost O(joints), allocates
SINEW_API sinew_error sinew_library_create(const sinew_scene* scene, sinew_library** out);
SINEW_API void sinew_library_destroy(sinew_library* library);

/// Adds all clips of a scene, in their order. The library shares the clips, so the scene may be destroyed afterwards.
/// in   if_unbound  sinew_if_unbound
/// out  unbound     owned by the caller, one line for each name that does not bind: "missing: hand", "ambiguous: arm"
///      (several have the name, so none was taken). NULL if all bind; the argument may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_UNSUPPORTED (if_unbound), SINEW_UNBOUND, SINEW_OUT_OF_MEMORY. After an error the
///      library is as before.
/// cost O(names + clips * (joints + weights + properties)), allocates
SINEW_API sinew_error sinew_library_add(sinew_library* library, const sinew_scene* scene, uint32_t if_unbound,
                                        sinew_messages** unbound);

// Clips keep their indices as the library grows. For an index out of range, functions return an empty string or 0.
SINEW_API size_t sinew_library_clip_count(const sinew_library* library);
SINEW_API sinew_string sinew_library_clip_name(const sinew_library* library, uint32_t clip);
SINEW_API double sinew_library_clip_duration_s(const sinew_library* library, uint32_t clip);
/// The clip of that name; SINEW_NONE if there is none, or if there are several.
SINEW_API uint32_t sinew_library_find(const sinew_library* library, const char* name);

/// sinew_plan_create for the clips of a library in place of the scene's own: sinew_layer.clip is an index into the
/// library as it is now. Morph weights and properties bind to the scene by name.
/// in   library  may grow or be destroyed afterwards;   scene  must outlive the plan
/// out  unbound  as in sinew_library_add. Names that this scene lacks are listed even if other scenes of the library's
///               skeleton have them
/// err  as sinew_plan_create
SINEW_API sinew_error sinew_plan_create_from_library(const sinew_scene* scene, const sinew_library* library,
                                                     const sinew_needs* needs, sinew_messages** unbound,
                                                     sinew_plan** out);

#ifdef __cplusplus
}
#endif
