// SPDX-License-Identifier: MIT
#include "runtime/threads/followed_input.h"

#include <algorithm>
#include <optional>

#include "runtime/base/bit_hash.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"

namespace sinew {
namespace {

/// Version of content that also depends on a matrix.
ContentVersion version_with(ContentVersion version, const Affine& matrix) noexcept {
  if (version == 0) return 0;
  const ContentVersion mixed = BitHash().add(std::span(&version, 1)).add(std::span(&matrix, 1)).value();
  return mixed != 0 ? mixed : 1;
}

}  // namespace

FollowedInput::FollowedInput(const Plan& plan, std::pmr::memory_resource& memory)
    : overrides_(&memory), joints_(&memory), procedures_(&memory) {
  const PoseProgramRoom& room = plan.needs().in.program;
  overrides_.reserve(room.overrides);
  joints_.reserve(room.overridden_joints);
  procedures_.reserve(room.procedures);
}

void FollowedInput::copy_lists(FrameInput& input) noexcept {
  PoseProgramInputs& inputs = input.program_inputs;
  overrides_.assign(inputs.overrides.begin(), inputs.overrides.end());
  procedures_.assign(inputs.procedures.begin(), inputs.procedures.end());
  joints_.clear();
  for (JointOverrides& overrides : overrides_) {
    const std::size_t first = joints_.size();
    joints_.insert(joints_.end(), overrides.joints.begin(), overrides.joints.end());
    overrides.joints = std::span(joints_).subspan(first);
  }
  inputs.overrides = overrides_;
  inputs.procedures = procedures_;
}

ErrorCode FollowedInput::place(const FrameInput& input, const FollowPlace& place, const Affine& world) noexcept {
  const std::optional<Affine> model_from_world = inverse_of(input.root);
  if (!model_from_world) return ErrorCode::rank_deficient;
  const Affine joint = *model_from_world * world;
  if (place.kind == FollowKind::procedure) {
    if (place.list >= procedures_.size()) return ErrorCode::index_out_of_range;
    procedures_[place.list].version = version_with(procedures_[place.list].version, joint);
    *place.matrix = joint;
    return ErrorCode::ok;
  }
  if (place.list >= overrides_.size() || place.entry >= overrides_[place.list].joints.size())
    return ErrorCode::index_out_of_range;
  JointOverrides& list = overrides_[place.list];
  JointOverride& placed = joints_[static_cast<std::size_t>(list.joints.data() - joints_.data()) + place.entry];
  if (placed.space != OverrideSpace::model) return ErrorCode::unsupported;
  placed.transform = decompose_trs(joint * affine_from_transform(placed.transform)).transform;
  list.version = version_with(list.version, joint);
  return ErrorCode::ok;
}

}  // namespace sinew
