// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate_pose.h"

#include <algorithm>
#include <cassert>

#include "runtime/math/negligible.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose/blend_weights.h"
#include "runtime/pose/mirror_pose.h"
#include "runtime/pose/sample_clip.h"

namespace sinew {
namespace {

/// Where a layer is sampled to. Layer 0 has the frame's own pose and numbers, later layers have memory of their own.
struct LayerOutput {
  PoseSpan pose;
  std::span<float> weights, properties;
};

std::span<float> numbers_of_layer(FrameMemory memory, std::size_t first_at, std::size_t others_at, std::size_t count,
                                  std::size_t index) noexcept {
  return memory.array<float>(index == 0 ? first_at : others_at + (index - 1) * sizeof(float) * count, count);
}

LayerOutput output_of_layer(const CompiledPlan& plan, FrameMemory memory, std::size_t index) noexcept {
  const std::size_t joints = plan.assets.joint_count(), weights = plan.rest_weights.size();
  const std::size_t properties = plan.properties ? plan.scene->properties.rest.size() : 0;
  const std::size_t later_at = plan.layout.layer_poses_at + (index - 1) * sizeof(float) * PoseSpan::floats_for(joints);
  return {memory.pose(index == 0 ? plan.layout.pose_at : later_at, joints),
          numbers_of_layer(memory, plan.layout.weights_at, plan.layout.layer_weights_at, weights, index),
          numbers_of_layer(memory, plan.layout.properties_at, plan.layout.layer_properties_at, properties, index)};
}

/// Memory of a layer before it is mirrored. Properties have their place already.
LayerOutput unmirrored(const CompiledPlan& plan, FrameMemory memory, const LayerOutput& output) noexcept {
  return {memory.pose(plan.layout.unmirrored_pose_at, plan.assets.joint_count()),
          memory.array<float>(plan.layout.unmirrored_weights_at, plan.rest_weights.size()), output.properties};
}

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

void sample_plainly(const CompiledPlan& plan, const ClipLayer& layer, LayerOutput output, bool with_weights,
                    bool same_clip, FrameWork& work) noexcept {
  const SampleClipJob job{.clip = layer.page != nullptr ? layer.page : &plan.assets.clips[layer.clip],
                          .time_s = layer.time_s,
                          .pose = output.pose,
                          .weights = with_weights ? output.weights : std::span<float>{},
                          .properties = output.properties,
                          .holds_clip = same_clip};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  const ClipTracks& tracks = plan.clip_tracks[layer.clip];
  work.tracks_sampled += tracks.joints + (with_weights ? tracks.weights : 0);
  if (!output.properties.empty()) work.properties_sampled += tracks.properties;
  work.spent_on(Stage::sample);
}

void sample(const CompiledPlan& plan, const ClipLayer& layer, FrameMemory memory, LayerOutput output, bool with_weights,
            bool same_clip, FrameWork& work) noexcept {
  if (!layer.mirrored) return sample_plainly(plan, layer, output, with_weights, same_clip, work);
  const LayerOutput other_side = unmirrored(plan, memory, output);
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
PoseSpan blend(const CompiledPlan& plan, std::span<const ClipLayer> input, FrameMemory memory,
               std::span<BlendLayer> layers, bool own_weights, bool same_clip, FrameWork& work) noexcept {
  const PoseSpan rest = memory.pose(plan.layout.rest_pose_at, plan.assets.joint_count());
  const LayerOutput first = output_of_layer(plan, memory, 0);
  std::size_t count = 0;
  for (const ClipLayer& layer : input) {
    if (!takes_part(plan, layer, false)) continue;
    const LayerOutput output = output_of_layer(plan, memory, count);
    sample(plan, layer, memory, output, own_weights, same_clip, work);
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
                  memory.array<float>(plan.layout.layer_weights_at, (count - 1) * first.weights.size()));
  if (plan.properties)
    blend_weights(layers.first(count), rest_properties, first.properties,
                  memory.array<float>(plan.layout.layer_properties_at, (count - 1) * first.properties.size()));
  work.spent_on(Stage::blend);
  return first.pose;
}

/// What the difference of a layer that adds is taken from.
struct AddReference {
  PoseSpan pose;
  std::span<const float> weights;
};

AddReference reference_of(const CompiledPlan& plan, const ClipLayer& layer, FrameMemory memory, bool own_weights,
                          FrameWork& work) noexcept {
  const PoseSpan rest = memory.pose(plan.layout.rest_pose_at, plan.assets.joint_count());
  if (layer.kind == LayerKind::add_to_rest && !layer.mirrored) return {rest, plan.rest_weights};
  const LayerOutput own{memory.pose(plan.layout.reference_pose_at, plan.assets.joint_count()),
                        memory.array<float>(plan.layout.reference_weights_at, plan.rest_weights.size()),
                        {}};
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
  const std::size_t joints = plan.assets.joint_count(), weights = plan.rest_weights.size();
  const LayerOutput own = output_of_layer(plan, memory, 0);
  const LayerOutput added{
      memory.pose(plan.layout.added_pose_at, joints), memory.array<float>(plan.layout.added_weights_at, weights), {}};
  sample(plan, layer, memory, added, own_weights, false, work);
  const AddReference reference = reference_of(plan, layer, memory, own_weights, work);
  const AddPoseJob job{.layer = added.pose,
                       .reference = reference.pose,
                       .weight = layer.weight,
                       .joint_weights = mask_of(plan, layer),
                       .pose = own.pose};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.poses_added += 1;
  if (own_weights)
    for (std::size_t i = 0; i < weights; ++i)
      own.weights[i] = flushed(own.weights[i] + layer.weight * (added.weights[i] - reference.weights[i]));
  work.spent_on(Stage::add);
}

}  // namespace

PoseSpan evaluate_pose(const CompiledPlan& plan, std::span<const ClipLayer> layers,
                       std::span<const float> given_weights, FrameMemory memory, std::span<BlendLayer> blend_layers,
                       bool same_clip, FrameWork& work) noexcept {
  const LayerOutput own = output_of_layer(plan, memory, 0);
  const bool own_weights = given_weights.empty() && !own.weights.empty();
  if (!own_weights) std::copy(given_weights.begin(), given_weights.end(), own.weights.begin());
  PoseSpan pose = blend(plan, layers, memory, blend_layers, own_weights, same_clip, work);
  for (const ClipLayer& layer : layers) {
    if (!takes_part(plan, layer, true)) continue;
    if (pose.planes != own.pose.planes)
      std::copy_n(pose.planes, PoseSpan::floats_for(pose.joint_count), own.pose.planes);
    pose = own.pose;
    add(plan, layer, memory, own_weights, work);
  }
  return pose;
}

}  // namespace sinew
