// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_machine.h"

#include <algorithm>
#include <cassert>

#include "runtime/math/negligible.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"
#include "runtime/pose_program/mix_poses.h"
#include "runtime/pose_program/override_joints.h"

namespace sinew {
namespace {

void copy_planes(const PoseSpan& from, const PoseSpan& to) noexcept {
  std::copy_n(from.planes, PoseSpan::floats_for(from.joint_count), to.planes);
}

void copy_or_rest(std::span<const float> from, std::span<const float> rest, std::span<float> to) noexcept {
  const std::span<const float> source = from.empty() ? rest : from;
  std::copy_n(source.begin(), to.size(), to.begin());
}

DeltaFrame frame_of(const PoseOp& op) noexcept { return static_cast<DeltaFrame>(op.index); }

}  // namespace

void PoseMachine::run(const PoseOp& op, const Step& step) noexcept {
  step_ = step;
  switch (op.kind) {
    case PoseOpKind::rest: push_rest(); break;
    case PoseOpKind::rest_mirrored: push_mirrored_rest(); break;
    case PoseOpKind::sample: sample(op, slot(depth_++), step.holds_clip); break;
    case PoseOpKind::sample_mirrored: push_mirrored_sample(op); break;
    case PoseOpKind::external: push_external(op.index); break;
    case PoseOpKind::mean: mean(op.index, op.time_s); break;
    case PoseOpKind::overlay: overlay(false); break;
    case PoseOpKind::overlay_model: overlay(true); break;
    case PoseOpKind::add_to_rest: add_to_rest(frame_of(op)); break;
    case PoseOpKind::add: add_to_reference(frame_of(op)); break;
    case PoseOpKind::override_joints: override_top(op); break;
    case PoseOpKind::procedure: run_procedure(op); break;
    case PoseOpKind::inertialize: inertialize(op); break;
    case PoseOpKind::dead_blend: dead_blend(op); break;
    case PoseOpKind::cached: cache_top(); break;
  }
  slots_.share(depth_ - 1) = {op.weight, op.mask};
}

void PoseMachine::skip(const PoseOp& op) noexcept {
  depth_ += 1;
  depth_ -= operands_of(op);
  slots_.share(depth_ - 1) = {op.weight, op.mask};
}

PoseMask PoseMachine::mask(std::uint8_t index) const noexcept {
  if (index == PoseOp::kNoMask) return {};
  const std::size_t shared = assets_.masks.size();
  return index < shared ? PoseMask{.joints = assets_.masks[index]} : inputs_.masks[index - shared];
}

void PoseMachine::push_rest() noexcept {
  const PoseSlot to = slot(depth_++);
  copy_planes(rest_, to.pose);
  copy_or_rest({}, assets_.rest_weights, to.weights);
  copy_or_rest({}, assets_.rest_properties, to.properties);
}

void PoseMachine::push_external(std::size_t index) noexcept {
  const ExternalPose& from = inputs_.externals[index];
  const PoseSlot to = slot(depth_++);
  copy_planes(from.pose, to.pose);
  copy_or_rest(from.weights, assets_.rest_weights, to.weights);
  copy_or_rest(from.properties, assets_.rest_properties, to.properties);
  ++work_.poses_copied;
  ended(PosePhase::external);
}

void PoseMachine::sample(const PoseOp& op, const PoseSlot& to, bool holds_clip) noexcept {
  const std::uint32_t clip = step_.clip != kNone ? step_.clip : op.index;
  const SampleClipJob sample{.clip = step_.page != nullptr ? step_.page : &assets_.clips[clip],
                             .time_s = op.time_s,
                             .pose = to.pose,
                             .weights = to.weights,
                             .properties = to.properties,
                             .holds_clip = holds_clip};
  assert(check(sample) == ErrorCode::ok);
  run_unchecked(sample);
  ++work_.clips_sampled;
  if (!assets_.clip_tracks.empty()) {
    const ClipTracks& tracks = assets_.clip_tracks[clip];
    work_.tracks_sampled += tracks.joints + (to.weights.empty() ? 0 : tracks.weights);
    work_.properties_sampled += to.properties.empty() ? 0 : tracks.properties;
  }
  ended(PosePhase::sample);
}

void PoseMachine::mirror(const PoseSpan& from, std::span<const float> weights, const PoseSlot& to) noexcept {
  const MirrorPoseJob mirrored{.tables = assets_.mirror, .pose = from, .mirrored = to.pose};
  assert(check(mirrored) == ErrorCode::ok);
  run_unchecked(mirrored);
  const std::span<const std::uint32_t> source = assets_.mirrored_weight_source;
  for (std::size_t w = 0; w < to.weights.size(); ++w) to.weights[w] = weights[source.empty() ? w : source[w]];
  ++work_.poses_mirrored;
  ended(PosePhase::mirror);
}

/// Pushes a mirrored sample. Its properties are not mirrored.
void PoseMachine::push_mirrored_sample(const PoseOp& op) noexcept {
  const PoseSlot to = slot(depth_++), other_side = slots_.unmirrored();
  sample(op, {other_side.pose, other_side.weights.first(to.weights.size()), to.properties}, false);
  mirror(other_side.pose, other_side.weights, to);
}

void PoseMachine::push_mirrored_rest() noexcept {
  const PoseSlot to = slot(depth_++);
  mirror(rest_, assets_.rest_weights, to);
  copy_or_rest({}, assets_.rest_properties, to.properties);
}

/// Weighted mean of the topmost poses. The mean of a single pose of full weight has the bits of that pose.
void PoseMachine::mean(std::size_t operands, double threshold) noexcept {
  if (operands == 0) return push_rest();
  depth_ -= operands;
  const std::span<BlendLayer> layers(slots_.blend_layers(), operands);
  bool has_masks = false;
  for (std::size_t l = 0; l < operands; ++l) {
    const PoseShare& share = slots_.share(depth_ + l);
    has_masks |= share.mask != PoseOp::kNoMask;
    layers[l] = {.pose = slots_.slot(depth_ + l).pose,
                 .weight = static_cast<float>(static_cast<double>(share.weight) / threshold),
                 .joint_weights = mask(share.mask).joints};
  }
  const PoseSlot to = slot(depth_++);
  if (operands == 1 && layers[0].weight >= 1.0f && slots_.share(depth_ - 1).mask == PoseOp::kNoMask) return;
  const BlendPosesJob blend{.layers = layers, .rest = rest_, .pose = to.pose};
  assert(check(blend) == ErrorCode::ok);
  run_unchecked(blend);
  if (has_masks) {
    blend_masked(layers, &PoseSlot::weights, &PoseMask::weights, assets_.rest_weights);
    blend_masked(layers, &PoseSlot::properties, &PoseMask::properties, assets_.rest_properties);
  } else {
    const std::size_t others = operands - 1;
    blend_weights(layers, assets_.rest_weights, to.weights,
                  {slots_.weights_above(depth_ - 1), others * to.weights.size()});
    blend_weights(layers, assets_.rest_properties, to.properties,
                  {slots_.properties_above(depth_ - 1), others * to.properties.size()});
  }
  work_.poses_blended += operands;
  ended(PosePhase::blend);
}

/// Means of the morph weights or properties of the operands, whose lowest one is at the top of the stack.
void PoseMachine::blend_masked(std::span<const BlendLayer> layers, std::span<float> PoseSlot::*numbers,
                               std::span<const float> PoseMask::*masks, std::span<const float> rest) noexcept {
  const std::size_t first = depth_ - 1;
  const auto layer = [&](std::size_t l) -> NumberLayer {
    return {slots_.slot(first + l).*numbers, layers[l].weight, mask(slots_.share(first + l).mask).*masks};
  };
  blend_masked_numbers(layers.size(), layer, rest, slot(first).*numbers);
}

void PoseMachine::overlay(bool in_model_space) noexcept {
  const PoseSlot above = slot(--depth_), below = slot(depth_ - 1);
  const PoseShare& above_share = slots_.share(depth_);
  const PoseMask above_mask = mask(above_share.mask);
  const MixShare share{above_share.weight, above_mask.joints};
  if (in_model_space)
    overlay_pose_in_model_space(*assets_.skeleton, above.pose, share, slots_.model_rotations(), below.pose);
  else
    overlay_pose(above.pose, share, below.pose);
  mix_numbers(above.weights, {share.weight, above_mask.weights}, below.weights);
  mix_numbers(above.properties, {share.weight, above_mask.properties}, below.properties);
  ++work_.poses_overlaid;
  ended(PosePhase::overlay);
}

void PoseMachine::add(const PoseSlot& layer, const PoseShare& share, const PoseSpan& reference,
                      std::span<const float> reference_weights, DeltaFrame frame) noexcept {
  const PoseSlot base = slots_.slot(depth_ - 1);
  const PoseMask of_layer = mask(share.mask);
  const AddPoseJob added{.layer = layer.pose,
                         .reference = reference,
                         .weight = share.weight,
                         .joint_weights = of_layer.joints,
                         .pose = base.pose,
                         .frame = frame};
  assert(check(added) == ErrorCode::ok);
  run_unchecked(added);
  const NumberLayer weights{layer.weights, share.weight, of_layer.weights};
  for (std::size_t i = 0; i < base.weights.size(); ++i)
    base.weights[i] = flushed(base.weights[i] + weights.of(i) * (layer.weights[i] - reference_weights[i]));
  ++work_.poses_added;
  ended(PosePhase::add);
}

void PoseMachine::add_to_rest(DeltaFrame frame) noexcept {
  --depth_;
  add(slots_.slot(depth_), slots_.share(depth_), rest_, assets_.rest_weights, frame);
}

void PoseMachine::add_to_reference(DeltaFrame frame) noexcept {
  depth_ -= 2;
  const PoseSlot reference = slots_.slot(depth_ + 1);
  add(slots_.slot(depth_), slots_.share(depth_), reference.pose, reference.weights, frame);
}

void PoseMachine::override_top(const PoseOp& op) noexcept {
  if (op.time_s == 0.0) return;
  const std::span<const JointOverride> joints = inputs_.overrides[op.index].joints;
  override_joints(*assets_.skeleton, joints, static_cast<float>(op.time_s), root_, top().pose);
  work_.joints_overridden += joints.size();
  ended(PosePhase::override_joints);
}

void PoseMachine::run_procedure(const PoseOp& op) noexcept {
  if (op.time_s == 0.0) return;
  const PoseProcedure& procedure = inputs_.procedures[op.index];
  const PoseSlot pose = slot(depth_ - 1);
  procedure.run(procedure.context,
                {*assets_.skeleton, pose.pose, pose.weights, pose.properties, static_cast<float>(op.time_s)});
  ++work_.procedures_run;
  ended(PosePhase::procedure);
}

}  // namespace sinew
