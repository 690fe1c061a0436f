// SPDX-License-Identifier: MIT
#include "runtime/c/needs.h"

#include <algorithm>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/program_room.h"
#include "runtime/plan/check_needs.h"

namespace sinew::c {
namespace {

/// A flag, and the bool of the needs that it sets.
template <std::uint32_t Flag, auto... Own>
constexpr auto flag() noexcept {
  return BitField<&sinew_needs::flags, Flag, Own...>{};
}

constexpr auto kNeeds = fields(flag<SINEW_NEED_JOINTS, &Needs::out, &Outputs::joints>(),
                               flag<SINEW_NEED_POSITIONS, &Needs::out, &Outputs::positions>(),
                               flag<SINEW_NEED_LOCAL_POSE, &Needs::out, &Outputs::local_pose>(),
                               flag<SINEW_NEED_NORMALS, &Needs::out, &Outputs::normals>(),
                               flag<SINEW_NEED_TANGENTS, &Needs::out, &Outputs::tangents>(),
                               flag<SINEW_NEED_TANGENTS_OF_ALL, &Needs::out, &Outputs::tangents_of_all>(),
                               flag<SINEW_NEED_WEIGHTS, &Needs::out, &Outputs::weights>(),
                               flag<SINEW_NEED_BOUNDS, &Needs::out, &Outputs::bounds>(),
                               flag<SINEW_NEED_PROPERTIES, &Needs::out, &Outputs::properties>(),
                               flag<SINEW_NEED_HIDDEN_MESHES, &Needs::out, &Outputs::hidden_meshes>(),
                               flag<SINEW_NEED_PALETTES, &Needs::out, &Outputs::palettes>(),
                               flag<SINEW_NEED_ADDITIVE, &Needs::in, &Inputs::additive>(),
                               flag<SINEW_NEED_BETWEEN_UPDATES, &Needs::in, &Inputs::between_updates>(),
                               flag<SINEW_NEED_CUT, &Needs::in, &Inputs::cut>(),
                               field<&sinew_needs::max_layers, &Needs::in, &Inputs::max_layers>(),
                               field<&sinew_needs::max_adding_layers, &Needs::in, &Inputs::max_additive_layers>(),
                               field<&sinew_needs::skinning, &Needs::skin, &SkinningRules::kind>(),
                               field<&sinew_needs::normal_rule, &Needs::skin, &SkinningRules::normal_rule>(),
                               field<&sinew_needs::cached_instances, &Needs::in, &Inputs::cached_instances>());

/// Copies the masks.     err  SINEW_NULL_ARGUMENT
sinew_error read_masks(const sinew_needs& given, std::size_t joints, Inputs& in) {
  if (given.mask_count > 0 && given.masks == nullptr) return SINEW_NULL_ARGUMENT;
  // At most one more than allowed: compile_plan refuses that many anyway.
  const std::size_t rows = std::min(given.mask_count, PoseOp::kNoMask + 1u);
  for (std::size_t m = 0; m < rows; ++m)
    in.masks.emplace_back(given.masks + m * joints, given.masks + (m + 1) * joints);
  return SINEW_OK;
}

/// Copies the kinds of skinning.     err  SINEW_UNSUPPORTED (kind)
sinew_error read_skinning(const unsigned char* kinds, std::size_t instances, SkinningRules& skin) {
  if (kinds == nullptr) return SINEW_OK;
  skin.per_instance.resize(instances);
  for (std::size_t i = 0; i < instances; ++i)
    if (const sinew_error error = from_c(kinds[i], skin.per_instance[i])) return error;
  return SINEW_OK;
}

}  // namespace

sinew_error read_needs(const sinew_needs* caller, const Scene& scene, Needs& needs) {
  sinew_needs given = sinew_default_needs();
  if (const sinew_error error = read_struct(caller, given)) return error;
  if ((given.flags & ~kNeeds.bits()) != 0) return SINEW_UNSUPPORTED;
  if (const sinew_error error = kNeeds.read(given, needs).error) return error;
  if (const sinew_error error = read_masks(given, scene.skeleton.joint_count(), needs.in)) return error;
  if (const sinew_error error = read_skinning(given.instance_skinning, scene.instances.size(), needs.skin))
    return error;
  if (const sinew_error error = read_fields(given.program, kProgramRoom, needs.in.program)) return error;
  if (given.skeleton_lod != nullptr) needs.out.skeleton_lod = given.skeleton_lod->lod.detail;
  if (given.mirror != nullptr) needs.in.mirror = given.mirror->map;
  return error_from(find_fault(needs, scene).error);
}

}  // namespace sinew::c

sinew_needs sinew_default_needs(void) {
  auto needs = sinew::c::written<sinew_needs>(sinew::c::kNeeds, sinew::Needs{});
  needs.max_adding_layers = 4;  // in C++ this number is no limit: frames with more are evaluated anew
  return needs;
}
