// SPDX-License-Identifier: MIT
#include "runtime/c/program_input.h"

#include <cstddef>

#include "runtime/c/boundary.h"
#include "runtime/c/page_handle.h"
#include "runtime/c/pose_span.h"

namespace sinew::c {
namespace {

static_assert(sizeof(sinew_joint_override) == sizeof(JointOverride) &&
              alignof(sinew_joint_override) == alignof(JointOverride) &&
              offsetof(sinew_joint_override, joint) == offsetof(JointOverride, joint) &&
              offsetof(sinew_joint_override, transform) == offsetof(JointOverride, transform) &&
              offsetof(sinew_joint_override, space) == offsetof(JointOverride, space) &&
              sizeof(OverrideSpace) == sizeof(sinew_joint_override::space));
static_assert(sizeof(sinew_transform) == sizeof(Transform) &&
              offsetof(sinew_transform, rotation) == offsetof(Transform, rotation) &&
              offsetof(sinew_transform, scale) == offsetof(Transform, scale) && offsetof(glm::quat, x) == 0);
static_assert(static_cast<int>(OverrideSpace::local) == SINEW_OVERRIDE_LOCAL &&
              static_cast<int>(OverrideSpace::model) == SINEW_OVERRIDE_MODEL);

bool is_null(sinew_floats floats) noexcept { return floats.data == nullptr && floats.count > 0; }

NotRead read(const sinew_external_pose& given, ExternalPose& external) noexcept {
  if (const sinew_error error = read_pose(&given.pose, external.pose); error != SINEW_OK)
    return refuse(error, {.field = "pose"});
  if (is_null(given.weights)) return refuse(SINEW_NULL_ARGUMENT, {.field = "weights"});
  if (is_null(given.properties)) return refuse(SINEW_NULL_ARGUMENT, {.field = "properties"});
  external.weights = {given.weights.data, given.weights.count};
  external.properties = {given.properties.data, given.properties.count};
  external.version = given.version;
  return {};
}

NotRead read(const sinew_joint_overrides& given, JointOverrides& overrides) noexcept {
  if (given.joints == nullptr && given.joint_count > 0) return refuse(SINEW_NULL_ARGUMENT, {.field = "joints"});
  for (std::size_t i = 0; i < given.joint_count; ++i)
    if (given.joints[i].space > SINEW_OVERRIDE_MODEL)
      return refuse(SINEW_UNSUPPORTED, {.field = "space", .rule = "there is no such space of a joint"});
  overrides.joints = {reinterpret_cast<const JointOverride*>(given.joints), given.joint_count};
  overrides.version = given.version;
  return {};
}

/// Calls the procedure of a C caller.
/// in   given  its sinew_pose_procedure
void call(void* given, const ProcedurePose& pose) {
  const auto& procedure = *static_cast<const sinew_pose_procedure*>(given);
  const sinew_procedure_pose own{.struct_size = sizeof(own),
                                 .local = {pose.local.planes, pose.local.joint_count},
                                 .weights = pose.weights.data(),
                                 .weight_count = pose.weights.size(),
                                 .properties = pose.properties.data(),
                                 .property_count = pose.properties.size(),
                                 .share = pose.share};
  procedure.run(procedure.context, &own);
}

/// One without code stays so: the runtime refuses it.
NotRead read(const sinew_pose_procedure& given, PoseProcedure& procedure) noexcept {
  procedure = {given.run != nullptr ? &call : nullptr, const_cast<sinew_pose_procedure*>(&given), given.version};
  return {};
}

NotRead read(const sinew_joint_mask& given, JointMask& mask) noexcept {
  if (is_null(given.weights)) return refuse(SINEW_NULL_ARGUMENT, {.field = "weights"});
  mask = {{given.weights.data, given.weights.count}, given.version};
  return {};
}

template <class OfC, class Own>
NotRead read_list(const OfC* given, std::size_t count, const char* list, std::span<Own> room,
                  std::span<const Own>& entries) noexcept {
  if (given == nullptr && count > 0) return refuse(SINEW_NULL_ARGUMENT, {.list = list});
  if (count > room.size()) return refuse(SINEW_NOT_IN_NEEDS, {.rule = kLongerThanNeeds, .list = list});
  for (std::size_t i = 0; i < count; ++i) {
    NotRead why = read(given[i], room[i]);
    if (why.error == SINEW_OK) continue;
    why.where.list = list;
    why.where.index = static_cast<std::uint32_t>(i);
    return why;
  }
  entries = room.first(count);
  return {};
}

sinew_floats floats_of(std::span<const float> numbers) noexcept { return {numbers.data(), numbers.size()}; }

}  // namespace

NotRead refuse(sinew_error error, Refusal where) noexcept {
  if (where.rule == nullptr) where.rule = sinew_describe(error);
  return {error, where};
}

NotRead read_program(const sinew_frame_input& given, const PoseProgramRoom& needs, const ProgramRoom& room,
                     FrameInput& input) noexcept {
  input.program = {};
  input.program_inputs = {};
  if (given.op_count == 0) return {};
  if (given.program == nullptr) return refuse(SINEW_NULL_ARGUMENT, {.list = "program"});
  input.program = {reinterpret_cast<const PoseOp*>(given.program), given.op_count};
  if (needs.ops == 0) return {};  // the runtime refuses it, whatever the lists are
  sinew_program_inputs own{};
  if (const sinew_error error = read_struct(given.program_inputs, own); error != SINEW_OK)
    return refuse(error, {.field = "struct_size", .list = "program_inputs"});
  PoseProgramInputs& inputs = input.program_inputs;
  NotRead why = read_list(own.externals, own.external_count, "externals", room.externals, inputs.externals);
  if (why.error == SINEW_OK)
    why = read_list(own.overrides, own.override_count, "overrides", room.overrides, inputs.overrides);
  if (why.error == SINEW_OK)
    why = read_list(own.procedures, own.procedure_count, "procedures", room.procedures, inputs.procedures);
  if (why.error == SINEW_OK) why = read_list(own.masks, own.mask_count, "masks", room.masks, inputs.masks);
  if (own.pages != nullptr) inputs.pages = {clips_of(own.pages), given.op_count};
  return why;
}

void write_program(const FrameInput& input, const ProgramRoomOfC& room, sinew_frame_input& out) noexcept {
  if (input.program.empty()) return;
  const PoseProgramInputs& inputs = input.program_inputs;
  for (std::size_t i = 0; i < inputs.externals.size(); ++i) {
    const ExternalPose& external = inputs.externals[i];
    room.externals[i] = {.pose = {external.pose.planes, external.pose.joint_count},
                         .weights = floats_of(external.weights),
                         .properties = floats_of(external.properties),
                         .version = external.version};
  }
  for (std::size_t i = 0; i < inputs.overrides.size(); ++i) {
    const JointOverrides& overrides = inputs.overrides[i];
    room.overrides[i] = {.joints = reinterpret_cast<const sinew_joint_override*>(overrides.joints.data()),
                         .joint_count = overrides.joints.size(),
                         .version = overrides.version};
  }
  for (std::size_t i = 0; i < inputs.masks.size(); ++i)
    room.masks[i] = {.weights = floats_of(inputs.masks[i].weights), .version = inputs.masks[i].version};
  const void* const procedures = inputs.procedures.empty() ? nullptr : inputs.procedures[0].context;
  *room.inputs = {.struct_size = sizeof(sinew_program_inputs),
                  .externals = room.externals.data(),
                  .external_count = inputs.externals.size(),
                  .overrides = room.overrides.data(),
                  .override_count = inputs.overrides.size(),
                  .procedures = static_cast<const sinew_pose_procedure*>(procedures),  // the caller's list
                  .procedure_count = inputs.procedures.size(),
                  .masks = room.masks.data(),
                  .mask_count = inputs.masks.size(),
                  .pages = inputs.pages.empty() ? nullptr : pages_of(inputs.pages.data())};
  out.program = reinterpret_cast<const sinew_pose_op*>(input.program.data());
  out.op_count = input.program.size();
  out.program_inputs = room.inputs;
}

}  // namespace sinew::c
