// SPDX-License-Identifier: MIT
#include "runtime/c/skeleton_lod.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/handles.h"
#include "runtime/c/needs.h"

using namespace sinew;

sinew_error sinew_skeleton_lod_create(const sinew_scene* scene, double tolerance_m, const std::uint32_t* clips,
                                      std::size_t clip_count, const sinew_needs* needs, sinew_skeleton_lod** out) {
  return c::call(c::given(scene, out, c::Array{clips, clip_count}), [&] {
    if (!std::isfinite(tolerance_m) || tolerance_m < 0.0) return SINEW_NOT_FINITE;
    const std::span<const std::uint32_t> own(clips, clip_count);
    const bool are_there = std::all_of(own.begin(), own.end(), [&](std::uint32_t clip) {
      return clip == SINEW_NONE || clip < scene->scene.clips.size();
    });
    if (!are_there) return SINEW_INDEX_OUT_OF_RANGE;
    Needs wanted;
    if (const sinew_error error = c::read_needs(needs, scene->scene, wanted)) return error;
    *out = new sinew_skeleton_lod(compile_skeleton_lod(scene->scene, tolerance_m, own, wanted));
    return SINEW_OK;
  });
}

void sinew_skeleton_lod_destroy(sinew_skeleton_lod* lod) { delete lod; }

sinew_error sinew_get_skeleton_lod(const sinew_skeleton_lod* lod, sinew_skeleton_lod_info* out) {
  return c::call(c::given(lod), [&] {
    return c::write_struct({.struct_size = 0,
                            .kept = c::to_c(lod->kept),
                            .measured_m = lod->lod.measured_m,
                            .left_out = lod->lod.left_out,
                            .worst_joint = lod->lod.worst_joint,
                            .tolerance_m = lod->lod.tolerance_m},
                           out);
  });
}
