// SPDX-License-Identifier: MIT
#include "runtime/c/mirror.h"

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"
#include "runtime/c/pose_span.h"
#include "runtime/c/read_reference.h"
#include "runtime/model/mirror_scene.h"

using namespace sinew;

sinew_error sinew_mirror_create(const sinew_scene* scene, sinew_mirror** out) {
  return sinew_mirror_create_about(scene, SINEW_REFERENCE_CHOSEN, nullptr, out);
}

sinew_error sinew_mirror_create_about(const sinew_scene* scene, std::uint32_t reference, const sinew_pose* given,
                                      sinew_mirror** out) {
  if (scene == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    std::vector<Transform> about;
    if (const sinew_error error = c::read_reference(reference, given, scene->scene, about); error != SINEW_OK)
      return error;
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
  if (mirror == nullptr) return SINEW_NULL_ARGUMENT;
  const glm::vec3& normal = mirror->map->plane_normal;
  const std::vector<std::uint32_t>& unpaired = mirror->map->unpaired;
  return c::write_struct({.struct_size = 0,
                          .plane_normal = {normal.x, normal.y, normal.z},
                          .plane_offset = mirror->map->plane_offset,
                          .partner = {mirror->partner.data(), mirror->partner.size()},
                          .unpaired = {unpaired.data(), unpaired.size()},
                          .reference = mirror->reference},
                         out);
}

sinew_error sinew_mirror_pose(const sinew_mirror* mirror, const sinew_pose* pose, const sinew_pose* mirrored) {
  if (mirror == nullptr) return SINEW_NULL_ARGUMENT;
  MirrorPoseJob job{.tables = &mirror->tables, .pose = {}, .mirrored = {}};
  if (const sinew_error error = c::read_pose(pose, job.pose); error != SINEW_OK) return error;
  if (const sinew_error error = c::read_pose(mirrored, job.mirrored); error != SINEW_OK) return error;
  return c::run_job(job);
}
