// SPDX-License-Identifier: MIT
#include "runtime/plan/frame_changes.h"

#include <algorithm>

#include "runtime/base/same_bits.h"

namespace sinew {
namespace {

using Layers = std::span<const ClipLayer>;

/// Nothing where it is not looked at.
Layers next_layers_of(const FrameInput& input) noexcept {
  return input.interpolation_factor == 0.0f ? Layers{} : input.next_layers;
}

/// As FrameTables::input_out_of_view.
std::uint8_t out_of_view(const FrameInput& input, std::size_t instance) noexcept {
  return !input.out_of_view.empty() && input.out_of_view[instance] != 0;
}

/// At most one clip plays, not mirrored, and alone makes up the pose: where it moves no joints they have their rest
/// pose to the last bit.
bool plays_alone(Layers layers) noexcept {
  std::size_t active = 0;
  for (const ClipLayer& layer : layers)
    if (layer.weight != 0.0f && (++active > 1 || layer.weight < 1.0f || layer.mask != kNone ||
                                 layer.kind != LayerKind::blend || layer.mirrored))
      return false;
  return true;
}

/// The clip that plays first; kNone: none does.
std::uint32_t playing_clip(Layers layers) noexcept {
  const auto playing =
      std::find_if(layers.begin(), layers.end(), [](const ClipLayer& layer) { return layer.weight != 0.0f; });
  return playing != layers.end() ? playing->clip : kNone;
}

/// No clip that plays moves joints.
bool leave_joints_at_rest(const CompiledPlan& plan, Layers layers) noexcept {
  return std::none_of(layers.begin(), layers.end(), [&](const ClipLayer& layer) {
    return layer.weight != 0.0f && plan.clip_tracks[layer.clip].moves_joints;
  });
}

/// in   both_alone  one clip or none plays alone in this frame and in the last
CurrentMatrices find_current_matrices(const CompiledPlan& plan, const FrameInput& input, Layers last_layers,
                                      const LastInput& last, bool both_alone) noexcept {
  if (!same_bits(input.root, last.root)) return CurrentMatrices::none;
  const bool between = input.interpolation_factor != 0.0f || last.interpolation_factor != 0.0f;
  const bool at_rest =
      !between && both_alone && leave_joints_at_rest(plan, input.layers) && leave_joints_at_rest(plan, last_layers);
  return at_rest || plan.moved_joints.empty() ? CurrentMatrices::all : CurrentMatrices::of_unmoved_joints;
}

/// As FrameTables::input_geometry.
GeometryInput playing(const FrameTables& tables, const FrameInput& input, std::size_t slot) noexcept {
  const bool plays =
      !input.geometry.empty() && input.geometry[slot].plays() && out_of_view(input, tables.cached_instances[slot]) == 0;
  return plays ? input.geometry[slot] : GeometryInput{};
}

bool had_same_geometry(const FrameTables& tables, const FrameInput& input) noexcept {
  for (std::size_t s = 0; s < tables.input_geometry.size(); ++s)
    if (!same_geometry(playing(tables, input, s), tables.input_geometry[s])) return false;
  return true;
}

}  // namespace

bool had_same_input(const LastFrame& frame, const FrameInput& input) noexcept {
  const LastInput& last = frame.input;
  const FrameTables& tables = frame.tables;
  if (!last.is_known || input.asleep != last.asleep) return false;
  if (input.asleep) return true;  // whatever it would do
  if (last.is_late || !had_same_geometry(tables, input)) return false;
  if (input.layers.size() != last.layer_count || input.weights.size() != last.weight_count) return false;
  if (!same_bits(input.interpolation_factor, last.interpolation_factor)) return false;
  if (next_layers_of(input).size() != last.next_layer_count) return false;
  for (std::size_t i = 0; i < tables.input_out_of_view.size(); ++i)
    if (out_of_view(input, i) != tables.input_out_of_view[i]) return false;
  return same_layers(input.layers, tables.input_layers.first(last.layer_count)) &&
         same_layers(next_layers_of(input), tables.input_next_layers.first(last.next_layer_count)) &&
         same_bits<float>(input.weights, tables.input_weights.first(last.weight_count)) &&
         same_bits(input.root, last.root);
}

FrameChanges find_changes(const CompiledPlan& plan, const FrameInput& input, const LastFrame& last,
                          const LastFrame& before) noexcept {
  FrameChanges changes;
  changes.nothing = had_same_input(last, input);
  changes.nothing_since_before = &before.input == &last.input ? changes.nothing : had_same_input(before, input);
  if (changes.nothing || input.asleep) return changes;
  const bool alone = plays_alone(input.layers);
  changes.mixes_poses = plan.sample && (input.interpolation_factor != 0.0f || !alone);
  if (!last.input.is_known || last.input.asleep) return changes;
  const Layers last_layers = last.tables.input_layers.first(last.input.layer_count);
  const bool both_alone = alone && plays_alone(last_layers);
  changes.current_matrices = find_current_matrices(plan, input, last_layers, last.input, both_alone);
  const std::uint32_t clip = playing_clip(input.layers);
  changes.same_clip = both_alone && clip != kNone && clip == playing_clip(last_layers);
  return changes;
}

void remember(const FrameInput& input, const FrameTables& tables, LastInput& last) noexcept {
  last.is_known = last.asleep = input.asleep;
  last.is_late = false;
  if (input.asleep) return;
  const Layers next_layers = next_layers_of(input);
  last.is_known =
      input.layers.size() <= tables.input_layers.size() && next_layers.size() <= tables.input_next_layers.size();
  if (!last.is_known) return;
  last.layer_count = input.layers.size();
  last.next_layer_count = next_layers.size();
  last.weight_count = input.weights.size();
  last.interpolation_factor = input.interpolation_factor;
  last.root = input.root;
  std::copy(input.layers.begin(), input.layers.end(), tables.input_layers.begin());
  std::copy(next_layers.begin(), next_layers.end(), tables.input_next_layers.begin());
  std::copy(input.weights.begin(), input.weights.end(), tables.input_weights.begin());
  for (std::size_t i = 0; i < tables.input_out_of_view.size(); ++i) tables.input_out_of_view[i] = out_of_view(input, i);
  for (std::size_t s = 0; s < tables.input_geometry.size(); ++s) {
    tables.input_geometry[s] = playing(tables, input, s);
    last.is_late |= tables.shown[s].is_late;
  }
}

}  // namespace sinew
