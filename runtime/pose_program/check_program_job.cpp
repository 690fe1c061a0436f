// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/base/all_finite.h"
#include "runtime/base/size_or_none.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {
namespace {

ErrorCode check_assets(const PoseProgramAssets& assets) noexcept {
  if (assets.skeleton == nullptr) return ErrorCode::size_mismatch;
  const std::size_t joints = assets.skeleton->joint_count(), weights = assets.rest_weights.size();
  if (!is_pose_of(assets.rest, joints)) return ErrorCode::size_mismatch;
  if (assets.mirror != nullptr && assets.mirror->joint_count != joints) return ErrorCode::size_mismatch;
  if (!assets.mirrored_weight_source.empty() && assets.mirrored_weight_source.size() != weights)
    return ErrorCode::size_mismatch;
  for (const std::span<const float> mask : assets.masks)
    if (mask.size() != joints) return ErrorCode::size_mismatch;
  return ErrorCode::ok;
}

bool has_shape_of(const Clip& clip, const PoseProgramAssets& assets) noexcept {
  return clip.joint_count() == assets.skeleton->joint_count() && clip.weight_count() == assets.rest_weights.size() &&
         clip.property_count() == assets.rest_properties.size();
}

ErrorCode check_samples(const PoseProgramJob& job) noexcept {
  const std::span<const Clip* const> pages = job.inputs.pages;
  if (!pages.empty() && pages.size() != job.program.size()) return ErrorCode::size_mismatch;
  for (std::size_t i = 0; i < job.program.size(); ++i) {
    const PoseOp& op = job.program[i];
    if (op.kind != PoseOpKind::sample && op.kind != PoseOpKind::sample_mirrored) continue;
    if (!has_shape_of(job.assets->clips[op.index], *job.assets)) return ErrorCode::size_mismatch;
    if (!pages.empty() && pages[i] != nullptr && !has_shape_of(*pages[i], *job.assets)) return ErrorCode::size_mismatch;
  }
  return ErrorCode::ok;
}

bool is_finite(const Transform& t) noexcept {
  const float sum = 0.0f * (t.translation.x + t.translation.y + t.translation.z) +
                    0.0f * (t.rotation.x + t.rotation.y + t.rotation.z + t.rotation.w) +
                    0.0f * (t.scale.x + t.scale.y + t.scale.z);
  return sum == 0.0f;  // 0 * infinity and 0 * NaN are NaN
}

using InputRule = PoseInputFault;

InputRule find_fault(const ExternalPose& external, std::size_t joints, std::size_t weights,
                     std::size_t properties) noexcept {
  if (!is_pose_of(external.pose, joints))
    return {.code = ErrorCode::size_mismatch, .rule = "the pose has not one transform for each joint of poses"};
  if (!has_size_or_none(external.weights, weights))
    return {.code = ErrorCode::size_mismatch, .rule = "there is not one weight for each of the scene"};
  if (!has_size_or_none(external.properties, properties))
    return {.code = ErrorCode::size_mismatch, .rule = "there is not one number for each property of the scene"};
  for (std::size_t p = 0; p < PoseSpan::plane_count; ++p)
    if (!all_finite(std::span<const float>(external.pose.plane(static_cast<PoseSpan::Plane>(p)), joints)))
      return {.code = ErrorCode::not_finite, .rule = "a number of the pose is not finite"};
  if (!all_finite(external.weights) || !all_finite(external.properties))
    return {.code = ErrorCode::not_finite, .rule = "a weight or property is not finite"};
  return {};
}

InputRule find_fault(const JointOverrides& overrides, std::size_t joints) noexcept {
  for (const JointOverride& given : overrides.joints) {
    if (given.joint >= joints) return {.code = ErrorCode::index_out_of_range, .rule = "poses have no such joint"};
    if (!is_finite(given.transform)) return {.code = ErrorCode::not_finite, .rule = "a transform is not finite"};
  }
  return {};
}

InputRule find_fault_in_mask(std::span<const float> weights) noexcept {
  if (!all_finite(weights)) return {.code = ErrorCode::not_finite, .rule = "a weight is not finite"};
  for (const float weight : weights)
    if (weight < 0.0f) return {.code = ErrorCode::negative_weight, .rule = "a weight is negative"};
  return {};
}

InputRule find_fault(const PoseMask& mask, std::size_t joints, std::size_t weights, std::size_t properties) noexcept {
  if (!has_size_or_none(mask.joints, joints))
    return {.code = ErrorCode::size_mismatch, .rule = "there is not one weight for each joint of poses"};
  if (!has_size_or_none(mask.weights, weights))
    return {.code = ErrorCode::size_mismatch, .rule = "there is not one weight for each morph weight of the scene"};
  if (!has_size_or_none(mask.properties, properties))
    return {.code = ErrorCode::size_mismatch, .rule = "there is not one weight for each property of the scene"};
  for (const std::span<const float> list : {mask.joints, mask.weights, mask.properties})
    if (const InputRule rule = find_fault_in_mask(list); rule.code != ErrorCode::ok) return rule;
  return {};
}

InputRule find_fault(const PoseProcedure& procedure) noexcept {
  if (procedure.run == nullptr) return {.code = ErrorCode::unsupported, .rule = "it has no code to run"};
  return {};
}

template <class Entry, class... Sizes>
InputRule find_fault_in(std::span<const Entry> entries, const char* list, Sizes... sizes) noexcept {
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (const InputRule rule = find_fault(entries[i], sizes...); rule.code != ErrorCode::ok)
      return {rule.code, list, static_cast<std::uint32_t>(i), rule.rule};
  return {};
}

}  // namespace

PoseInputFault find_fault(const PoseProgramInputs& inputs, std::size_t joint_count, std::size_t weight_count,
                          std::size_t property_count) noexcept {
  InputRule rule = find_fault_in(inputs.externals, "externals", joint_count, weight_count, property_count);
  if (rule.code == ErrorCode::ok) rule = find_fault_in(inputs.overrides, "overrides", joint_count);
  if (rule.code == ErrorCode::ok) rule = find_fault_in(inputs.procedures, "procedures");
  if (rule.code == ErrorCode::ok)
    rule = find_fault_in(inputs.masks, "masks", joint_count, weight_count, property_count);
  return rule;
}

ErrorCode check(const PoseProgramJob& job) noexcept {
  if (job.assets == nullptr) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_assets(*job.assets); error != ErrorCode::ok) return error;
  const PoseProgramInputs& inputs = job.inputs;
  const PoseProgramLimits limits{.clips = std::min<std::size_t>(job.assets->clips.size(), kMostClipsOfPrograms),
                                 .externals = inputs.externals.size(),
                                 .masks = job.assets->masks.size() + inputs.masks.size(),
                                 .overrides = inputs.overrides.size(),
                                 .procedures = inputs.procedures.size(),
                                 .mirror = job.assets->mirror != nullptr,
                                 .slots = kMostPoseOps,
                                 .kept = kMostPoseOps};
  if (const ErrorCode error = check(job.program, limits); error != ErrorCode::ok) return error;
  const std::size_t joints = job.assets->skeleton->joint_count(), weights = job.assets->rest_weights.size(),
                    properties = job.assets->rest_properties.size();
  const bool is_output_sized = is_pose_of(job.pose, joints) && has_size_or_none(job.weights, weights) &&
                               has_size_or_none(job.properties, properties);
  if (!is_output_sized || job.memory.size() < pose_program_bytes(*job.assets, room_of(job.program)))
    return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_samples(job); error != ErrorCode::ok) return error;
  return find_fault(inputs, joints, weights, properties).code;
}

}  // namespace sinew
