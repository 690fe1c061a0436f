// SPDX-License-Identifier: MIT
#include "runtime/c/program_input.h"

#include <cstddef>

#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/list_field.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/page_handle.h"
#include "runtime/c/pose_program.h"

namespace sinew::c {

// Arrays of these types are read in place.
template <>
inline constexpr bool kSameBytes<sinew_joint_override, JointOverride> = true;
static_assert(offsetof(sinew_joint_override, joint) == offsetof(JointOverride, joint) &&
              offsetof(sinew_joint_override, transform) == offsetof(JointOverride, transform) &&
              offsetof(sinew_joint_override, space) == offsetof(JointOverride, space) &&
              sizeof(OverrideSpace) == sizeof(sinew_joint_override::space));
static_assert(sizeof(sinew_transform) == sizeof(Transform) &&
              offsetof(sinew_transform, rotation) == offsetof(Transform, rotation) &&
              offsetof(sinew_transform, scale) == offsetof(Transform, scale) && offsetof(glm::quat, x) == 0);

namespace {

constexpr auto kExternal = fields(field<&sinew_external_pose::pose, &ExternalPose::pose>("pose"),
                                  field<&sinew_external_pose::weights, &ExternalPose::weights>("weights"),
                                  field<&sinew_external_pose::properties, &ExternalPose::properties>("properties"),
                                  field<&sinew_external_pose::version, &ExternalPose::version>());

/// The spaces of overridden joints, which are checked in the caller's array.
struct SpacesField {
  const char* name = "space";
  const char* rule = "there is no such space of a joint";

  sinew_error read(const sinew_joint_overrides& given, JointOverrides&) const noexcept {
    for (std::size_t i = 0; i < given.joint_count; ++i)
      if (!kEnum<OverrideSpace>.has(given.joints[i].space)) return SINEW_UNSUPPORTED;
    return SINEW_OK;
  }
  void write(const JointOverrides&, sinew_joint_overrides&) const noexcept {}
};
constexpr auto kOverrides = fields(
    span_field<&sinew_joint_overrides::joints, &sinew_joint_overrides::joint_count, &JointOverrides::joints>("joints"),
    SpacesField{}, field<&sinew_joint_overrides::version, &JointOverrides::version>());

constexpr auto kMask = fields(field<&sinew_pose_mask::joints, &PoseMask::joints>("joints"),
                              field<&sinew_pose_mask::weights, &PoseMask::weights>("weights"),
                              field<&sinew_pose_mask::properties, &PoseMask::properties>("properties"),
                              field<&sinew_pose_mask::version, &PoseMask::version>());

constexpr auto kProcedurePose = fields(
    field<&sinew_procedure_pose::local, &ProcedurePose::local>(),
    span_field<&sinew_procedure_pose::weights, &sinew_procedure_pose::weight_count, &ProcedurePose::weights>(),
    span_field<&sinew_procedure_pose::properties, &sinew_procedure_pose::property_count, &ProcedurePose::properties>(),
    field<&sinew_procedure_pose::share, &ProcedurePose::share>());

/// A procedure of a C caller. A null function stays null, and the runtime refuses it.
struct CallField {
  const char* name = nullptr;

  static void call(void* given, const ProcedurePose& pose) {
    const auto& procedure = *static_cast<const sinew_pose_procedure*>(given);
    const auto own = written<sinew_procedure_pose>(kProcedurePose, pose);
    procedure.run(procedure.context, &own);
  }
  sinew_error read(const sinew_pose_procedure& given, PoseProcedure& procedure) const noexcept {
    procedure.run = given.run != nullptr ? &call : nullptr;
    procedure.context = const_cast<sinew_pose_procedure*>(&given);
    return SINEW_OK;
  }
};
constexpr auto kProcedure = fields(CallField{}, field<&sinew_pose_procedure::version, &PoseProcedure::version>());

constexpr auto kExternals = list_field<&sinew_program_inputs::externals, &sinew_program_inputs::external_count,
                                       &PoseProgramInputs::externals, &InputRoom::externals, &InputRoomOfC::externals>(
    {"externals", SINEW_NOT_IN_NEEDS, kLongerThanNeeds}, kExternal);
constexpr auto kOverrideLists =
    list_field<&sinew_program_inputs::overrides, &sinew_program_inputs::override_count, &PoseProgramInputs::overrides,
               &InputRoom::overrides, &InputRoomOfC::overrides>({"overrides", SINEW_NOT_IN_NEEDS, kLongerThanNeeds},
                                                                kOverrides);
constexpr auto kProcedures = list_field<&sinew_program_inputs::procedures, &sinew_program_inputs::procedure_count,
                                        &PoseProgramInputs::procedures, &InputRoom::procedures, nullptr>(
    {"procedures", SINEW_NOT_IN_NEEDS, kLongerThanNeeds}, kProcedure);
constexpr auto kMasks =
    list_field<&sinew_program_inputs::masks, &sinew_program_inputs::mask_count, &PoseProgramInputs::masks,
               &InputRoom::masks, &InputRoomOfC::masks>({"masks", SINEW_NOT_IN_NEEDS, kLongerThanNeeds}, kMask);

}  // namespace

NotRead read_program(const sinew_frame_input& given, const PoseProgramRoom& needs, const InputRoom& room,
                     FrameInput& input) noexcept {
  input.program = {};
  input.program_inputs = {};
  if (given.op_count > 0 && given.program == nullptr) return refuse(SINEW_NULL_ARGUMENT, {.list = "program"});
  input.program = {reinterpret_cast<const PoseOp*>(given.program), given.op_count};
  if (given.op_count > 0 && needs.ops == 0) return {};  // the runtime refuses the program, whatever its lists are
  sinew_program_inputs own{};
  if (const sinew_error error = read_struct(given.program_inputs, own))
    return refuse(error, {.field = "struct_size", .list = "program_inputs"});
  PoseProgramInputs& inputs = input.program_inputs;
  if (given.op_count == 0) return kMasks.read(own, room, inputs);  // layers only name masks
  if (own.pages != nullptr) inputs.pages = {clips_of(own.pages), given.op_count};
  NotRead why = kExternals.read(own, room, inputs);
  if (why.error == SINEW_OK) why = kOverrideLists.read(own, room, inputs);
  if (why.error == SINEW_OK) why = kProcedures.read(own, room, inputs);
  if (why.error == SINEW_OK) why = kMasks.read(own, room, inputs);
  return why;
}

void write_program(const FrameInput& input, const InputRoomOfC& room, sinew_frame_input& out) noexcept {
  const PoseProgramInputs& inputs = input.program_inputs;
  if (input.program.empty() && inputs.masks.empty()) return;
  sinew_program_inputs& own = *room.program_inputs;
  own = {};
  own.struct_size = sizeof(own);
  kExternals.write(inputs, room, own);
  kOverrideLists.write(inputs, room, own);
  kMasks.write(inputs, room, own);
  const void* const procedures = inputs.procedures.empty() ? nullptr : inputs.procedures[0].context;
  own.procedures = static_cast<const sinew_pose_procedure*>(procedures);  // the list that the caller gave
  own.procedure_count = inputs.procedures.size();
  own.pages = inputs.pages.empty() ? nullptr : pages_of(inputs.pages.data());
  out.program_inputs = &own;
  if (input.program.empty()) return;
  out.program = reinterpret_cast<const sinew_pose_op*>(input.program.data());
  out.op_count = input.program.size();
}

}  // namespace sinew::c
