// SPDX-License-Identifier: MIT
#include "runtime/c/mirror.h"

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"
#include "runtime/c/pose_span.h"
#include "runtime/model/mirror_scene.h"

using namespace sinew;

sinew_error sinew_mirror_create(const sinew_scene* scene, sinew_mirror** out) {
  if (scene == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    auto map = std::make_shared<const MirrorMap>(make_mirror_map(scene->scene));
    std::vector<std::uint32_t> partner;
    for (const MirroredJoint& joint : map->joints) partner.push_back(joint.source);
    MirrorTables tables = make_mirror_tables(map->joints);
    *out = new sinew_mirror{std::move(map), std::move(tables), std::move(partner)};
    return SINEW_OK;
  });
}

void sinew_mirror_destroy(sinew_mirror* mirror) { delete mirror; }

sinew_error sinew_get_mirror(const sinew_mirror* mirror, sinew_mirror_info* out) {
  if (mirror == nullptr) return SINEW_NULL_ARGUMENT;
  const glm::vec3& normal = mirror->map->plane_normal;
  const std::vector<std::uint32_t>& unpaired = mirror->map->unpaired;
  return c::write_struct({.struct_size = 0,
                          .plane_normal = {normal.x, normal.y, normal.z},
                          .plane_offset = mirror->map->plane_offset,
                          .partner = {mirror->partner.data(), mirror->partner.size()},
                          .unpaired = {unpaired.data(), unpaired.size()}},
                         out);
}

sinew_error sinew_mirror_pose(const sinew_mirror* mirror, const sinew_pose* pose, const sinew_pose* mirrored) {
  if (mirror == nullptr) return SINEW_NULL_ARGUMENT;
  MirrorPoseJob job{.tables = &mirror->tables, .pose = {}, .mirrored = {}};
  if (const sinew_error error = c::read_pose(pose, job.pose); error != SINEW_OK) return error;
  if (const sinew_error error = c::read_pose(mirrored, job.mirrored); error != SINEW_OK) return error;
  return c::run_job(job);
}
