// SPDX-License-Identifier: MIT
#include "runtime/c/detail_map.h"

#include <cstdint>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/handles.h"
#include "runtime/retarget/detail_map.h"

using namespace sinew;

struct sinew_detail_map {
  const sinew_scene *coarse, *fine;
  DetailMap map;
};

namespace {

// Matrices of the C API are read and written in place.
static_assert(sizeof(sinew_affine) == sizeof(Affine) && alignof(sinew_affine) == alignof(Affine));

std::span<const Affine> matrices(const sinew_affine* data, std::size_t count) noexcept {
  return {reinterpret_cast<const Affine*>(data), count};
}

}  // namespace

sinew_error sinew_detail_map_create(const sinew_scene* coarse, const sinew_scene* fine, const sinew_joint_pair* pairs,
                                    std::size_t count, sinew_detail_map** out) {
  return c::call(c::given(coarse, fine, out, c::Array{pairs, count}), [&] {
    DetailMapOptions options;
    for (std::size_t i = 0; i < count; ++i) options.pairs.push_back({pairs[i].source, pairs[i].target});
    auto map = make_detail_map(coarse->scene.skeleton, fine->scene.skeleton, options);
    if (!map) return c::error_from(map.error());
    *out = new sinew_detail_map{coarse, fine, std::move(*map)};
    return SINEW_OK;
  });
}

void sinew_detail_map_destroy(sinew_detail_map* map) { delete map; }

sinew_error sinew_coarse_from_fine(const sinew_detail_map* map, const sinew_affine* fine, std::size_t fine_count,
                                   sinew_affine* coarse, std::size_t coarse_count) {
  return c::call(c::given(map, c::Array{fine, fine_count}, c::Array{coarse, coarse_count}), [&] {
    return coarse_from_fine(map->map, map->coarse->scene.skeleton, matrices(fine, fine_count),
                            {reinterpret_cast<Affine*>(coarse), coarse_count});
  });
}

std::size_t sinew_detail_map_scratch(const sinew_detail_map* map) {
  return map == nullptr ? 0 : 2 * map->map.pair_of_fine.size() * sizeof(Affined);
}

sinew_error sinew_fine_from_coarse(const sinew_detail_map* map, const sinew_affine* coarse, std::size_t coarse_count,
                                   const sinew_pose* local, void* scratch, std::size_t scratch_bytes,
                                   int keep_lengths) {
  return c::call(c::given(map, local, scratch, c::Array{coarse, coarse_count}), [&] {
    PoseSpan pose;
    if (const sinew_error error = c::read_poses({{local, pose}})) return error;
    if (reinterpret_cast<std::uintptr_t>(scratch) % alignof(Affined) != 0) return SINEW_SIZE_MISMATCH;
    const std::span<Affined> memory(static_cast<Affined*>(scratch), scratch_bytes / sizeof(Affined));
    return c::error_from(fine_from_coarse(map->map, map->fine->scene.skeleton, matrices(coarse, coarse_count), pose,
                                          memory, keep_lengths != 0 ? BodyPlaces::keep_lengths : BodyPlaces::exact));
  });
}
