// SPDX-License-Identifier: MIT
#include "runtime/c/input_room.h"

namespace sinew::c {
namespace {

const Inputs& inputs_of(const sinew_plan& plan) noexcept { return plan.plan.needs().in; }

std::size_t next_layer_room(const sinew_plan& plan) noexcept {
  return inputs_of(plan).between_updates ? inputs_of(plan).layer_room() : 0;
}

}  // namespace

InputRoom::InputRoom(const sinew_plan& plan, Block& block)
    : layers(block.take<ClipLayer>(inputs_of(plan).layer_room())),
      next_layers(block.take<ClipLayer>(next_layer_room(plan))),
      geometry(block.take<GeometryInput>(inputs_of(plan).cached_instances.size())),
      externals(block.take<ExternalPose>(inputs_of(plan).program.externals)),
      overrides(block.take<JointOverrides>(inputs_of(plan).program.overrides)),
      procedures(block.take<PoseProcedure>(inputs_of(plan).program.procedures)),
      masks(block.take<PoseMask>(inputs_of(plan).program.masks)) {}

InputRoomOfC::InputRoomOfC(const sinew_plan& plan, Block& block)
    : layers(block.take<sinew_layer>(inputs_of(plan).layer_room())),
      next_layers(block.take<sinew_layer>(next_layer_room(plan))),
      pages(block.take<const sinew_page*>(inputs_of(plan).layer_room())),
      next_pages(block.take<const sinew_page*>(next_layer_room(plan))),
      geometry(block.take<sinew_geometry_input>(inputs_of(plan).cached_instances.size())),
      externals(block.take<sinew_external_pose>(inputs_of(plan).program.externals)),
      overrides(block.take<sinew_joint_overrides>(inputs_of(plan).program.overrides)),
      masks(block.take<sinew_pose_mask>(inputs_of(plan).program.masks)),
      program_inputs(block.take<sinew_program_inputs>(1).data()) {}

}  // namespace sinew::c
