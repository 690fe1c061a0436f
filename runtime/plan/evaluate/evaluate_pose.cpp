// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/evaluate_pose.h"

#include <algorithm>
#include <cassert>

#include "runtime/math/negligible.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"

namespace sinew {
namespace {

void mirror_weights(const CompiledPlan& plan, std::span<const float> from, std::span<float> to) noexcept {
  const std::vector<std::uint32_t>& source = plan.assets.mirror->weight_source;
  for (std::size_t w = 0; w < to.size(); ++w) to[w] = from[source.empty() ? w : source[w]];
}

void mirror(const CompiledPlan& plan, const PoseSpan& from, const PoseSpan& to, FrameWork& work) noexcept {
  const MirrorPoseJob job{.tables = &plan.mirror_tables, .pose = from, .mirrored = to};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.poses_mirrored += 1;
}

void sample_plainly(const CompiledPlan& plan, const ClipLayer& layer, const PoseNumbers& output, bool with_weights,
                    bool has_base, FrameWork& work) noexcept {
  const SampleClipJob job{.clip = layer.page != nullptr ? layer.page : &plan.assets.clips[layer.clip],
                          .time_s = layer.time_s,
                          .pose = output.pose,
                          .weights = with_weights ? output.weights : std::span<float>{},
                          .properties = output.properties,
                          .holds_clip = has_base};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  const ClipTracks& tracks = plan.clip_tracks[layer.clip];
  work.tracks_sampled += tracks.joints + (with_weights ? tracks.weights : 0);
  if (!output.properties.empty()) work.properties_sampled += tracks.properties;
  work.spent_on(Stage::sample);
}

void sample(const CompiledPlan& plan, const ClipLayer& layer, FrameMemory memory, const PoseNumbers& output,
            bool with_weights, bool has_base, FrameWork& work) noexcept {
  if (!layer.mirrored) return sample_plainly(plan, layer, output, with_weights, has_base, work);
  PoseNumbers other_side = memory.of(plan.layout.unmirrored);
  other_side.properties = output.properties;  // properties are not mirrored
  sample_plainly(plan, layer, other_side, with_weights, false, work);
  mirror(plan, other_side.pose, output.pose, work);
  if (with_weights) mirror_weights(plan, other_side.weights, output.weights);
  work.spent_on(Stage::mirror);
}

std::span<const float> mask_of(const CompiledPlan& plan, const ClipLayer& layer) noexcept {
  return layer.mask == kNone ? std::span<const float>{} : std::span<const float>(plan.masks[layer.mask]);
}

bool takes_part(const CompiledPlan& plan, const ClipLayer& layer, bool adds) noexcept {
  return plan.sample && layer.weight != 0.0f && (layer.kind != LayerKind::blend) == adds;
}

/// The mean of the layers that blend. Their morph weights are averaged too, unless the input gives weights.
PoseSpan blend(const CompiledPlan& plan, std::span<const ClipLayer> input, FrameMemory memory, bool own_weights,
               bool has_base, FrameWork& work) noexcept {
  const std::span<BlendLayer> layers = memory.of(plan.layout.tables.blend_layers);
  const PoseSpan rest = memory.of(plan.layout.rest_pose);
  const PoseNumbers first = memory.of(plan.layout.pose);
  std::size_t count = 0;
  for (const ClipLayer& layer : input) {
    if (!takes_part(plan, layer, false)) continue;
    const PoseNumbers output = memory.of(plan.layout.layer(count));
    sample(plan, layer, memory, output, own_weights, has_base, work);
    layers[count++] = {.pose = output.pose, .weight = layer.weight, .joint_weights = mask_of(plan, layer)};
  }
  if (own_weights && count == 0) std::copy(plan.rest_weights.begin(), plan.rest_weights.end(), first.weights.begin());
  const std::span<const float> rest_properties = plan.scene->properties.rest;
  if (plan.properties && count == 0)
    std::copy(rest_properties.begin(), rest_properties.end(), first.properties.begin());
  if (count == 0) return rest;
  if (count == 1 && layers[0].weight >= 1.0f && layers[0].joint_weights.empty()) return first.pose;

  const BlendPosesJob job{.layers = layers.first(count), .rest = rest, .pose = first.pose};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.poses_blended += count;
  if (own_weights)
    blend_weights(layers.first(count), plan.rest_weights, first.weights,
                  memory.of(plan.layout.layer_weights.part(0, (count - 1) * first.weights.size())));
  if (plan.properties)
    blend_weights(layers.first(count), rest_properties, first.properties,
                  memory.of(plan.layout.layer_properties.part(0, (count - 1) * first.properties.size())));
  work.spent_on(Stage::blend);
  return first.pose;
}

/// Baseline of an additive layer: its delta is the sampled pose minus the baseline.
struct AdditiveBaseline {
  PoseSpan pose;
  std::span<const float> weights;
};

AdditiveBaseline baseline_of(const CompiledPlan& plan, const ClipLayer& layer, FrameMemory memory, bool own_weights,
                             FrameWork& work) noexcept {
  const PoseSpan rest = memory.of(plan.layout.rest_pose);
  if (layer.kind == LayerKind::add_to_rest && !layer.mirrored) return {rest, plan.rest_weights};
  const PoseNumbers own = memory.of(plan.layout.reference);
  if (layer.kind == LayerKind::add_to_start) {
    sample(plan, {.clip = layer.clip, .mirrored = layer.mirrored}, memory, own, own_weights, false, work);
  } else {
    mirror(plan, rest, own.pose, work);
    mirror_weights(plan, plan.rest_weights, own.weights);
    work.spent_on(Stage::mirror);
  }
  return {own.pose, own.weights};
}

/// Adds one layer to the frame's own pose, and to its morph weights unless the input gives them. Properties are not
/// added.
void add(const CompiledPlan& plan, const ClipLayer& layer, FrameMemory memory, bool own_weights,
         FrameWork& work) noexcept {
  const PoseNumbers own = memory.of(plan.layout.pose), added = memory.of(plan.layout.added);
  sample(plan, layer, memory, added, own_weights, false, work);
  const AdditiveBaseline baseline = baseline_of(plan, layer, memory, own_weights, work);
  const AddPoseJob job{.layer = added.pose,
                       .reference = baseline.pose,
                       .weight = layer.weight,
                       .joint_weights = mask_of(plan, layer),
                       .pose = own.pose};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.poses_added += 1;
  if (own_weights)
    for (std::size_t i = 0; i < own.weights.size(); ++i)
      own.weights[i] = flushed(own.weights[i] + layer.weight * (added.weights[i] - baseline.weights[i]));
  work.spent_on(Stage::add);
}

}  // namespace

PoseSpan evaluate_pose(const CompiledPlan& plan, std::span<const ClipLayer> layers,
                       std::span<const float> given_weights, FrameMemory memory, bool has_base,
                       FrameWork& work) noexcept {
  const PoseNumbers own = memory.of(plan.layout.pose);
  const bool own_weights = given_weights.empty() && !own.weights.empty();
  if (!own_weights) std::copy(given_weights.begin(), given_weights.end(), own.weights.begin());
  PoseSpan pose = blend(plan, layers, memory, own_weights, has_base, work);
  for (const ClipLayer& layer : layers) {
    if (!takes_part(plan, layer, true)) continue;
    if (pose.planes != own.pose.planes) copy_pose(pose, own.pose);
    pose = own.pose;
    add(plan, layer, memory, own_weights, work);
  }
  return pose;
}

}  // namespace sinew
