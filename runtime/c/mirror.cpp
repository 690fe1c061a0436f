// SPDX-License-Identifier: MIT
#include "runtime/c/mirror.h"

#include "runtime/c/call.h"
#include "runtime/c/handles.h"
#include "runtime/c/pose_span.h"
#include "runtime/c/struct_versions.h"
#include "runtime/model/mirror_scene.h"

using namespace sinew;

sinew_error sinew_mirror_create(const sinew_scene* scene, sinew_mirror** out) {
  return c::call(c::given(scene, out), [&] {
    auto map = std::make_shared<const MirrorMap>(make_mirror_map(scene->scene));
    std::vector<std::uint32_t> partner;
    for (const MirroredJoint& joint : map->joints) partner.push_back(joint.source);
    MirrorTables tables = make_mirror_tables(map->joints);
    *out = new sinew_mirror{std::move(map), std::move(tables), std::move(partner)};
  });
}

void sinew_mirror_destroy(sinew_mirror* mirror) { delete mirror; }

sinew_error sinew_get_mirror(const sinew_mirror* mirror, sinew_mirror_info* out) {
  return c::call(c::given(mirror), [&] {
    return c::write_struct({.struct_size = 0,
                            .plane_normal = c::to_c(mirror->map->plane_normal),
                            .plane_offset = mirror->map->plane_offset,
                            .partner = c::to_c(mirror->partner),
                            .unpaired = c::to_c(mirror->map->unpaired)},
                           out);
  });
}

sinew_error sinew_mirror_pose(const sinew_mirror* mirror, const sinew_pose* pose, const sinew_pose* mirrored) {
  return c::call(c::given(mirror), [&] {
    MirrorPoseJob job{.tables = &mirror->tables, .pose = {}, .mirrored = {}};
    if (const sinew_error error = c::read_poses({{pose, job.pose}, {mirrored, job.mirrored}})) return error;
    return c::error_from(run(job));
  });
}
