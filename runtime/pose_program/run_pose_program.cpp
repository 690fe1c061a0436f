// SPDX-License-Identifier: MIT
#include "runtime/pose_program/run_pose_program.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "runtime/base/all_finite.h"
#include "runtime/math/negligible.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/pose_program/mix_poses.h"
#include "runtime/pose_program/override_joints.h"
#include "runtime/pose_program/pose_slots.h"

namespace sinew {
namespace {

void copy_planes(const PoseSpan& from, const PoseSpan& to) noexcept {
  std::copy_n(from.planes, PoseSpan::floats_for(from.joint_count), to.planes);
}

void copy_or_rest(std::span<const float> from, std::span<const float> rest, std::span<float> to) noexcept {
  const std::span<const float> source = from.empty() ? rest : from;
  std::copy_n(source.begin(), to.size(), to.begin());
}

/// The share of a pose on the stack in the operation that takes it.
struct Share {
  float weight;
  std::uint8_t mask;
};

/// Runs the operations of one job, one after the other.
class Machine {
 public:
  Machine(const PoseProgramJob& job, PoseProgramWork& work) noexcept
      : job_(job),
        assets_(*job.assets),
        slots_(assets_, pose_slots(job.program), job.memory.data(), {job.pose, job.weights, job.properties}),
        work_(work) {}

  void run() noexcept {
    for (std::size_t i = 0; i < job_.program.size(); ++i) apply(job_.program[i], i);
  }

 private:
  void apply(const PoseOp& op, std::size_t index) noexcept {
    switch (op.kind) {
      case PoseOpKind::rest: push_rest(); break;
      case PoseOpKind::rest_mirrored: push_mirrored_rest(); break;
      case PoseOpKind::sample: push_sample(op, index, slots_.slot(depth_)); break;
      case PoseOpKind::sample_mirrored: push_mirrored_sample(op, index); break;
      case PoseOpKind::external: push_external(op.index); break;
      case PoseOpKind::mean: mean(op.index, op.time_s); break;
      case PoseOpKind::overlay: overlay(false); break;
      case PoseOpKind::overlay_model: overlay(true); break;
      case PoseOpKind::add_to_rest: add_to_rest(); break;
      case PoseOpKind::add: add_to_reference(); break;
      case PoseOpKind::override_joints: override_top(op); break;
    }
    shares_[depth_ - 1] = {op.weight, op.mask};
  }

  void push_rest() noexcept {
    const PoseSlot to = slots_.slot(depth_++);
    copy_planes(assets_.rest, to.pose);
    copy_or_rest({}, assets_.rest_weights, to.weights);
    copy_or_rest({}, assets_.rest_properties, to.properties);
  }

  void push_external(std::size_t index) noexcept {
    const ExternalPose& from = job_.externals[index];
    const PoseSlot to = slots_.slot(depth_++);
    copy_planes(from.pose, to.pose);
    copy_or_rest(from.weights, assets_.rest_weights, to.weights);
    copy_or_rest(from.properties, assets_.rest_properties, to.properties);
  }

  void push_sample(const PoseOp& op, std::size_t index, const PoseSlot& to) noexcept {
    const bool has_page = !job_.pages.empty() && job_.pages[index] != nullptr;
    const SampleClipJob sample{.clip = has_page ? job_.pages[index] : &assets_.clips[op.index],
                               .time_s = op.time_s,
                               .pose = to.pose,
                               .weights = to.weights,
                               .properties = to.properties};
    assert(check(sample) == ErrorCode::ok);
    run_unchecked(sample);
    ++work_.clips_sampled;
    ++depth_;
  }

  void mirror(const PoseSpan& from, std::span<const float> weights, const PoseSlot& to) noexcept {
    const MirrorPoseJob mirrored{.tables = assets_.mirror, .pose = from, .mirrored = to.pose};
    assert(check(mirrored) == ErrorCode::ok);
    run_unchecked(mirrored);
    const std::span<const std::uint32_t> source = assets_.mirrored_weight_source;
    for (std::size_t w = 0; w < to.weights.size(); ++w) to.weights[w] = weights[source.empty() ? w : source[w]];
    ++work_.poses_mirrored;
  }

  void push_mirrored_sample(const PoseOp& op, std::size_t index) noexcept {
    const PoseSlot to = slots_.slot(depth_), plain = slots_.scratch();
    push_sample(op, index, {plain.pose, plain.weights.first(to.weights.size()), to.properties});
    mirror(plain.pose, plain.weights, to);
  }

  void push_mirrored_rest() noexcept {
    const PoseSlot to = slots_.slot(depth_++);
    mirror(assets_.rest, assets_.rest_weights, to);
    copy_or_rest({}, assets_.rest_properties, to.properties);
  }

  std::span<const float> mask(std::uint8_t index) const noexcept {
    return index == PoseOp::kNoMask ? std::span<const float>{} : assets_.masks[index];
  }

  /// A single pose of full weight is its own mean, to the bit.
  void mean(std::size_t operands, double threshold) noexcept {
    if (operands == 0) return push_rest();
    depth_ -= operands;
    const std::span<BlendLayer> layers = slots_.blend_layers().first(operands);
    for (std::size_t l = 0; l < operands; ++l) {
      const Share& share = shares_[depth_ + l];
      layers[l] = {.pose = slots_.slot(depth_ + l).pose,
                   .weight = static_cast<float>(static_cast<double>(share.weight) / threshold),
                   .joint_weights = mask(share.mask)};
    }
    const PoseSlot to = slots_.slot(depth_++);
    if (operands == 1 && layers[0].weight >= 1.0f && layers[0].joint_weights.empty()) return;
    const BlendPosesJob blend{.layers = layers, .rest = assets_.rest, .pose = to.pose};
    assert(check(blend) == ErrorCode::ok);
    run_unchecked(blend);
    blend_weights(layers, assets_.rest_weights, to.weights, slots_.weights_above(depth_ - 1));
    blend_weights(layers, assets_.rest_properties, to.properties, slots_.properties_above(depth_ - 1));
    work_.poses_blended += static_cast<std::uint32_t>(operands);
  }

  void overlay(bool in_model_space) noexcept {
    const PoseSlot above = slots_.slot(--depth_), below = slots_.slot(depth_ - 1);
    const MixShare share{shares_[depth_].weight, mask(shares_[depth_].mask)};
    if (in_model_space)
      overlay_pose_in_model_space(*assets_.skeleton, above.pose, share, slots_.model_rotations(), below.pose);
    else
      overlay_pose(above.pose, share, below.pose);
    const float w = std::min(share.weight, 1.0f);
    mix_numbers(above.weights, w, below.weights);
    mix_numbers(above.properties, w, below.properties);
    ++work_.poses_overlaid;
  }

  static void mix_numbers(std::span<const float> above, float w, std::span<float> below) noexcept {
    for (std::size_t i = 0; i < below.size(); ++i)
      below[i] = w < 1.0f ? flushed(below[i] * (1.0f - w) + above[i] * w) : above[i];
  }

  void add(const PoseSlot& layer, const Share& share, const PoseSpan& reference,
           std::span<const float> reference_weights) noexcept {
    const PoseSlot base = slots_.slot(depth_ - 1);
    const AddPoseJob added{.layer = layer.pose,
                           .reference = reference,
                           .weight = share.weight,
                           .joint_weights = mask(share.mask),
                           .pose = base.pose};
    assert(check(added) == ErrorCode::ok);
    run_unchecked(added);
    for (std::size_t i = 0; i < base.weights.size(); ++i)
      base.weights[i] = flushed(base.weights[i] + share.weight * (layer.weights[i] - reference_weights[i]));
    ++work_.poses_added;
  }

  void add_to_rest() noexcept {
    --depth_;
    add(slots_.slot(depth_), shares_[depth_], assets_.rest, assets_.rest_weights);
  }

  void add_to_reference() noexcept {
    depth_ -= 2;
    const PoseSlot reference = slots_.slot(depth_ + 1);
    add(slots_.slot(depth_), shares_[depth_], reference.pose, reference.weights);
  }

  void override_top(const PoseOp& op) noexcept {
    const std::span<const JointOverride> joints = job_.overrides[op.index];
    override_joints(*assets_.skeleton, joints, static_cast<float>(op.time_s), slots_.slot(depth_ - 1).pose);
    work_.joints_overridden += static_cast<std::uint32_t>(joints.size());
  }

  const PoseProgramJob& job_;
  const PoseProgramAssets& assets_;
  PoseSlots slots_;
  PoseProgramWork& work_;
  std::array<Share, kMostPoseOps> shares_;
  std::size_t depth_ = 0;
};

bool has_size_or_none(std::span<const float> numbers, std::size_t count) noexcept {
  return numbers.empty() || numbers.size() == count;
}

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
  if (!job.pages.empty() && job.pages.size() != job.program.size()) return ErrorCode::size_mismatch;
  for (std::size_t i = 0; i < job.program.size(); ++i) {
    const PoseOp& op = job.program[i];
    if (op.kind != PoseOpKind::sample && op.kind != PoseOpKind::sample_mirrored) continue;
    if (!has_shape_of(job.assets->clips[op.index], *job.assets)) return ErrorCode::size_mismatch;
    if (!job.pages.empty() && job.pages[i] != nullptr && !has_shape_of(*job.pages[i], *job.assets))
      return ErrorCode::size_mismatch;
  }
  return ErrorCode::ok;
}

bool is_finite(const Transform& t) noexcept {
  const float sum = 0.0f * (t.translation.x + t.translation.y + t.translation.z) +
                    0.0f * (t.rotation.x + t.rotation.y + t.rotation.z + t.rotation.w) +
                    0.0f * (t.scale.x + t.scale.y + t.scale.z);
  return sum == 0.0f;  // an infinity or NaN makes it NaN
}

ErrorCode check_poses_of_caller(const PoseProgramJob& job) noexcept {
  const std::size_t joints = job.assets->skeleton->joint_count();
  for (const ExternalPose& external : job.externals)
    if (!is_pose_of(external.pose, joints) || !has_size_or_none(external.weights, job.assets->rest_weights.size()) ||
        !has_size_or_none(external.properties, job.assets->rest_properties.size()))
      return ErrorCode::size_mismatch;
  for (const std::span<const JointOverride> overrides : job.overrides) {
    for (const JointOverride& given : overrides) {
      if (given.joint >= joints) return ErrorCode::index_out_of_range;
      if (!is_finite(given.transform)) return ErrorCode::not_finite;
    }
  }
  return ErrorCode::ok;
}

}  // namespace

std::size_t pose_program_bytes(const PoseProgramAssets& assets, std::size_t slots) noexcept {
  return PoseSlots(assets, slots, nullptr, {}).bytes();
}

ErrorCode check(const PoseProgramJob& job) noexcept {
  if (job.assets == nullptr) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_assets(*job.assets); error != ErrorCode::ok) return error;
  const PoseProgramLimits limits{.clips = job.assets->clips.size(),
                                 .externals = job.externals.size(),
                                 .masks = job.assets->masks.size(),
                                 .overrides = job.overrides.size(),
                                 .mirror = job.assets->mirror != nullptr,
                                 .slots = kMostPoseOps};
  if (const ErrorCode error = check(job.program, limits); error != ErrorCode::ok) return error;
  const bool is_output_sized = is_pose_of(job.pose, job.assets->skeleton->joint_count()) &&
                               job.weights.size() == job.assets->rest_weights.size() &&
                               job.properties.size() == job.assets->rest_properties.size();
  if (!is_output_sized || job.memory.size() < pose_program_bytes(*job.assets, pose_slots(job.program)))
    return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_samples(job); error != ErrorCode::ok) return error;
  return check_poses_of_caller(job);
}

void run_unchecked(const PoseProgramJob& job) noexcept {
  PoseProgramWork uncounted;
  Machine(job, job.work != nullptr ? *job.work : uncounted).run();
}

}  // namespace sinew
