// SPDX-License-Identifier: MIT
#include "runtime/c/needs.h"

#include <cmath>

#include "runtime/c/boundary.h"
#include "runtime/c/program_room.h"

namespace sinew::c {
namespace {

constexpr std::uint32_t kAllFlags = (SINEW_NEED_CUT << 1) - 1;

static_assert(static_cast<int>(Skinning::linear) == SINEW_SKIN_LINEAR &&
              static_cast<int>(Skinning::dual_quaternion) == SINEW_SKIN_DUAL_QUATERNION &&
              static_cast<int>(Skinning::center_of_rotation) == SINEW_SKIN_CENTER_OF_ROTATION &&
              static_cast<int>(NormalRule::cofactor) == SINEW_NORMALS_COFACTOR);

bool fits(const MirrorMap& map, const Scene& scene) noexcept {
  return map.joints.size() == scene.skeleton.joint_count() &&
         (map.weight_source.empty() || map.weight_source.size() == scene.weight_count());
}

sinew_error check(const sinew_needs& given, const Scene& scene) noexcept {
  const std::size_t joints = scene.skeleton.joint_count(), instances = scene.instances.size();
  if ((given.flags & ~kAllFlags) != 0 || given.max_layers == 0) return SINEW_UNSUPPORTED;
  if (given.skinning > SINEW_SKIN_CENTER_OF_ROTATION || given.normal_rule > SINEW_NORMALS_COFACTOR)
    return SINEW_UNSUPPORTED;
  if (given.mask_count > 0 && given.masks == nullptr) return SINEW_NULL_ARGUMENT;
  if (given.mask_count > PoseOp::kNoMask) return SINEW_UNSUPPORTED;
  for (std::size_t i = 0; i < given.mask_count * joints; ++i)
    if (!std::isfinite(given.masks[i]) || given.masks[i] < 0.0f) return SINEW_NOT_FINITE;
  for (std::size_t i = 0; given.instance_skinning != nullptr && i < instances; ++i)
    if (given.instance_skinning[i] > SINEW_SKIN_CENTER_OF_ROTATION) return SINEW_UNSUPPORTED;
  const sinew_indices& cached = given.cached_instances;
  if (cached.count > 0 && cached.data == nullptr) return SINEW_NULL_ARGUMENT;
  for (std::size_t i = 0; i < cached.count; ++i)
    if (cached.data[i] >= instances || (i > 0 && cached.data[i] <= cached.data[i - 1])) return SINEW_INDEX_OUT_OF_RANGE;
  if (given.mirror != nullptr && !fits(*given.mirror->map, scene)) return SINEW_SIZE_MISMATCH;
  if (given.skeleton_lod == nullptr || given.skeleton_lod->kept.empty()) return SINEW_OK;
  return given.skeleton_lod->kept.size() == joints ? SINEW_OK : SINEW_SIZE_MISMATCH;
}

}  // namespace

sinew_error read_needs(const sinew_needs* caller, const Scene& scene, Needs& needs) {
  sinew_needs given = sinew_default_needs();
  if (const sinew_error error = read_struct(caller, given); error != SINEW_OK) return error;
  const std::size_t joints = scene.skeleton.joint_count(), instances = scene.instances.size();
  if (const sinew_error error = check(given, scene); error != SINEW_OK) return error;
  if (const sinew_error error = read_program_room(given.program, needs.in.program); error != SINEW_OK) return error;
  const auto asked = [&](std::uint32_t flag) { return (given.flags & flag) != 0; };
  needs.out.joints = asked(SINEW_NEED_JOINTS);
  needs.out.positions = asked(SINEW_NEED_POSITIONS);
  needs.out.normals = asked(SINEW_NEED_NORMALS);
  needs.out.tangents = asked(SINEW_NEED_TANGENTS);
  needs.out.tangents_of_all = asked(SINEW_NEED_TANGENTS_OF_ALL);
  needs.out.weights = asked(SINEW_NEED_WEIGHTS);
  needs.out.bounds = asked(SINEW_NEED_BOUNDS);
  needs.out.properties = asked(SINEW_NEED_PROPERTIES);
  needs.out.hidden_meshes = asked(SINEW_NEED_HIDDEN_MESHES);
  needs.in.additive = asked(SINEW_NEED_ADDITIVE);
  needs.out.palettes = asked(SINEW_NEED_PALETTES);
  needs.in.between_updates = asked(SINEW_NEED_BETWEEN_UPDATES);
  needs.in.cut = asked(SINEW_NEED_CUT);
  needs.in.max_layers = given.max_layers;
  needs.in.max_additive_layers = given.max_adding_layers;
  needs.skin.kind = static_cast<Skinning>(given.skinning);
  needs.skin.normal_rule = static_cast<NormalRule>(given.normal_rule);
  for (std::size_t m = 0; m < given.mask_count; ++m)
    needs.in.masks.emplace_back(given.masks + m * joints, given.masks + (m + 1) * joints);
  for (std::size_t i = 0; given.instance_skinning != nullptr && i < instances; ++i)
    needs.skin.per_instance.push_back(static_cast<Skinning>(given.instance_skinning[i]));
  if (given.skeleton_lod != nullptr) needs.out.skeleton_lod = given.skeleton_lod->lod.detail;
  if (given.mirror != nullptr) needs.in.mirror = given.mirror->map;
  needs.in.cached_instances.assign(given.cached_instances.data,
                                   given.cached_instances.data + given.cached_instances.count);
  return SINEW_OK;
}

}  // namespace sinew::c

sinew_needs sinew_default_needs(void) {
  return {.struct_size = sizeof(sinew_needs),
          .flags = SINEW_NEED_JOINTS | SINEW_NEED_POSITIONS | SINEW_NEED_NORMALS | SINEW_NEED_TANGENTS |
                   SINEW_NEED_WEIGHTS | SINEW_NEED_PROPERTIES,
          .max_layers = 4,
          .max_adding_layers = 4,
          .skinning = SINEW_SKIN_LINEAR,
          .normal_rule = SINEW_NORMALS_LINEAR,
          .mask_count = 0,
          .masks = nullptr,
          .instance_skinning = nullptr,
          .skeleton_lod = nullptr,
          .cached_instances = {nullptr, 0},
          .mirror = nullptr,
          .program = nullptr};
}
