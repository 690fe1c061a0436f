// SPDX-License-Identifier: MIT
#include "runtime/plan/program_copy.h"

#include <algorithm>
#include <memory>

#include "runtime/base/size_or_none.h"
#include "runtime/plan/compiled_plan.h"

namespace sinew {
namespace {

constexpr std::size_t kPoseAlignment = 64;

std::size_t pose_bytes(std::size_t joints) noexcept { return PoseSpan::floats_for(joints) * sizeof(float); }

/// Copies numbers to `to`, and moves `to` behind them.
std::span<const float> take(std::span<const float> numbers, float*& to) noexcept {
  float* const start = to;
  to = std::copy(numbers.begin(), numbers.end(), start);
  return {start, numbers.size()};
}

}  // namespace

ProgramCopy::ProgramCopy(const Plan& plan, std::pmr::memory_resource& memory)
    : room_(plan.needs().in.program),
      joints_(plan.compiled()->assets.joint_count()),
      weights_(plan.compiled()->rest_weights.size()),
      properties_(plan.scene().properties.rest.size()),
      ops_(&memory),
      pages_(&memory),
      externals_(&memory),
      overrides_(&memory),
      procedures_(&memory),
      masks_(&memory),
      poses_(&memory),
      external_numbers_(&memory),
      mask_weights_(&memory),
      joints_of_overrides_(&memory) {
  ops_.reserve(room_.ops);
  pages_.reserve(room_.ops);
  externals_.reserve(room_.externals);
  overrides_.reserve(room_.overrides);
  procedures_.reserve(room_.procedures);
  masks_.reserve(room_.masks);
  if (room_.externals > 0) poses_.resize(room_.externals * pose_bytes(joints_) + kPoseAlignment);
  external_numbers_.resize(room_.externals * (weights_ + properties_));
  mask_weights_.resize(room_.masks * (joints_ + weights_ + properties_));
  joints_of_overrides_.resize(room_.overridden_joints);
}

ErrorCode ProgramCopy::check_room(const FrameInput& input) const noexcept {
  const PoseProgramInputs& inputs = input.program_inputs;
  std::size_t joints = 0;
  for (const JointOverrides& overrides : inputs.overrides) joints += overrides.joints.size();
  const bool fits = input.program.size() <= room_.ops && inputs.pages.size() <= room_.ops &&
                    inputs.externals.size() <= room_.externals && inputs.overrides.size() <= room_.overrides &&
                    inputs.procedures.size() <= room_.procedures && inputs.masks.size() <= room_.masks &&
                    joints <= room_.overridden_joints;
  if (!fits) return ErrorCode::not_in_needs;
  for (const ExternalPose& external : inputs.externals)
    if (!is_pose_of(external.pose, joints_) || !has_size_or_none(external.weights, weights_) ||
        !has_size_or_none(external.properties, properties_))
      return ErrorCode::size_mismatch;
  for (const PoseMask& mask : inputs.masks)
    if (!has_size_or_none(mask.joints, joints_) || !has_size_or_none(mask.weights, weights_) ||
        !has_size_or_none(mask.properties, properties_))
      return ErrorCode::size_mismatch;
  return ErrorCode::ok;
}

void ProgramCopy::assign(const FrameInput& input) noexcept {
  const PoseProgramInputs& inputs = input.program_inputs;
  ops_.assign(input.program.begin(), input.program.end());
  pages_.assign(inputs.pages.begin(), inputs.pages.end());
  externals_.assign(inputs.externals.begin(), inputs.externals.end());
  overrides_.assign(inputs.overrides.begin(), inputs.overrides.end());
  procedures_.assign(inputs.procedures.begin(), inputs.procedures.end());
  masks_.assign(inputs.masks.begin(), inputs.masks.end());
  void* start = poses_.data();
  std::size_t space = poses_.size();
  if (start != nullptr) start = std::align(kPoseAlignment, room_.externals * pose_bytes(joints_), start, space);
  float* pose = static_cast<float*>(start);
  float* number = external_numbers_.data();
  for (ExternalPose& external : externals_) {
    const std::size_t floats = PoseSpan::floats_for(joints_);
    std::copy_n(external.pose.planes, floats, pose);
    external.pose.planes = pose;
    pose += floats;
    external.weights = take(external.weights, number);
    external.properties = take(external.properties, number);
  }
  float* weight = mask_weights_.data();
  for (PoseMask& mask : masks_) {
    mask.joints = take(mask.joints, weight);
    mask.weights = take(mask.weights, weight);
    mask.properties = take(mask.properties, weight);
  }
  JointOverride* joint = joints_of_overrides_.data();
  for (JointOverrides& overrides : overrides_) {
    JointOverride* const first = joint;
    joint = std::copy(overrides.joints.begin(), overrides.joints.end(), first);
    overrides.joints = {first, overrides.joints.size()};
  }
}

void ProgramCopy::show(FrameInput& input) const noexcept {
  input.program = ops_;
  input.program_inputs = {
      .externals = externals_, .overrides = overrides_, .procedures = procedures_, .masks = masks_, .pages = pages_};
}

}  // namespace sinew
