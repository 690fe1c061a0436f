// SPDX-License-Identifier: MIT
#include "runtime/c/library.h"

#include <memory>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/handles.h"
#include "runtime/c/needs.h"
#include "runtime/c/unbound.h"

using namespace sinew;

sinew_error sinew_library_create(const sinew_scene* scene, sinew_library** out) {
  return c::call(c::given(scene, out), [&] { *out = new sinew_library{ClipLibrary(scene->scene.skeleton)}; });
}

void sinew_library_destroy(sinew_library* library) { delete library; }

sinew_error sinew_library_add(sinew_library* library, const sinew_scene* scene, std::uint32_t if_unbound,
                              sinew_messages** unbound) {
  return c::call(c::given(library, scene), [&] {
    const Scene& file = scene->scene;
    return c::add_to(*library, file.clips, clip_channels(file), if_unbound, unbound);
  });
}

std::size_t sinew_library_clip_count(const sinew_library* library) {
  return library != nullptr ? library->clips.size() : 0;
}

sinew_string sinew_library_clip_name(const sinew_library* library, std::uint32_t clip) {
  if (clip >= sinew_library_clip_count(library)) return {"", 0};
  return c::to_c(library->clips[clip].name());
}

double sinew_library_clip_duration_s(const sinew_library* library, std::uint32_t clip) {
  return clip < sinew_library_clip_count(library) ? library->clips[clip].duration_s() : 0.0;
}

std::uint32_t sinew_library_find(const sinew_library* library, const char* name) {
  if (library == nullptr || name == nullptr) return SINEW_NONE;
  return library->clips.find(name).value_or(SINEW_NONE);
}

sinew_error sinew_plan_create_from_library(const sinew_scene* scene, const sinew_library* library,
                                           const sinew_needs* needs, sinew_messages** unbound, sinew_plan** out) {
  return c::call(c::given(scene, library, out), [&] {
    Needs wanted;
    if (const sinew_error error = c::read_needs(needs, scene->scene, wanted)) return error;
    const BoundClips bound = clips_for(library->clips, scene->scene);
    auto lines = c::messages_of(bound.unbound);
    *out = new sinew_plan(*scene, bound.clips, wanted);
    if (unbound != nullptr) *unbound = lines.release();
    return SINEW_OK;
  });
}
