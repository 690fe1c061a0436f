// SPDX-License-Identifier: MIT
#include "runtime/c/mirror.h"

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/read_reference.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/handles.h"
#include "runtime/model/mirror_scene.h"

using namespace sinew;

sinew_error sinew_mirror_create(const sinew_scene* scene, sinew_mirror** out) {
  return sinew_mirror_create_about(scene, SINEW_REFERENCE_CHOSEN, nullptr, out);
}

sinew_error sinew_mirror_create_about(const sinew_scene* scene, std::uint32_t reference, const sinew_pose* given,
                                      sinew_mirror** out) {
  return c::call(c::given(scene, out), [&] {
    std::vector<Transform> about;
    if (const sinew_error error = c::read_reference(reference, given, scene->scene, about)) return error;
    MirrorOptions options;
    options.reference = about;
    auto map = std::make_shared<const MirrorMap>(make_mirror_map(scene->scene, options));
    std::vector<std::uint32_t> partner;
    for (const MirroredJoint& joint : map->joints) partner.push_back(joint.source);
    MirrorTables tables = make_mirror_tables(map->joints);
    const std::uint32_t told = c::told_reference(map->reference, reference);
    *out = new sinew_mirror{std::move(map), std::move(tables), std::move(partner), told};
    return SINEW_OK;
  });
}

void sinew_mirror_destroy(sinew_mirror* mirror) { delete mirror; }

sinew_error sinew_get_mirror(const sinew_mirror* mirror, sinew_mirror_info* out) {
  return c::call(c::given(mirror), [&] {
    return c::write_struct({.struct_size = 0,
                            .plane_normal = c::to_c(mirror->map->plane_normal),
                            .plane_offset = mirror->map->plane_offset,
                            .partner = c::to_c(mirror->partner),
                            .unpaired = c::to_c(mirror->map->unpaired),
                            .reference = mirror->reference},
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
