// SPDX-License-Identifier: MIT
#include "runtime/c/skeleton_lod.h"

#include <cmath>

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"
#include "runtime/c/needs.h"

using namespace sinew;

sinew_error sinew_skeleton_lod_create(const sinew_scene* scene, double tolerance_m, const std::uint32_t* clips,
                                      std::size_t clip_count, const sinew_needs* needs, sinew_skeleton_lod** out) {
  if (scene == nullptr || out == nullptr || (clips == nullptr && clip_count > 0)) return SINEW_NULL_ARGUMENT;
  if (!std::isfinite(tolerance_m) || tolerance_m < 0.0) return SINEW_NOT_FINITE;
  for (std::size_t i = 0; i < clip_count; ++i)
    if (clips[i] != SINEW_NONE && clips[i] >= scene->scene.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
  return c::guarded([&] {
    Needs wanted;
    if (const sinew_error error = c::read_needs(needs, scene->scene, wanted); error != SINEW_OK) return error;
    CompiledSkeletonLod lod = compile_skeleton_lod(scene->scene, tolerance_m, {clips, clip_count}, wanted);
    std::vector<unsigned char> kept(lod.detail.kept.begin(), lod.detail.kept.end());
    *out = new sinew_skeleton_lod{std::move(lod), std::move(kept)};
    return SINEW_OK;
  });
}

void sinew_skeleton_lod_destroy(sinew_skeleton_lod* lod) { delete lod; }

sinew_error sinew_get_skeleton_lod(const sinew_skeleton_lod* lod, sinew_skeleton_lod_info* out) {
  if (lod == nullptr) return SINEW_NULL_ARGUMENT;
  return c::write_struct({.struct_size = 0,
                          .kept = {lod->kept.data(), lod->kept.size()},
                          .measured_m = lod->lod.measured_m,
                          .left_out = lod->lod.left_out,
                          .worst_joint = lod->lod.worst_joint,
                          .tolerance_m = lod->lod.tolerance_m},
                         out);
}
