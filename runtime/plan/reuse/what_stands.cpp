// SPDX-License-Identifier: MIT
#include "runtime/plan/reuse/what_stands.h"

#include <algorithm>
#include <cstring>

#include "runtime/base/same_bits.h"
#include "runtime/plan/playing_layers.h"
#include "runtime/plan/reuse/program_versions.h"

namespace sinew {
namespace {

using Layers = std::span<const ClipLayer>;

/// The value to store in FrameTables::input_out_of_view.
std::uint8_t out_of_view(const FrameInput& input, std::size_t instance) noexcept {
  return !input.out_of_view.empty() && input.out_of_view[instance] != 0;
}

/// True if no clip of the layers moves joints. Layers of weight 0 do not count.
bool leave_joints_at_rest(const CompiledPlan& plan, Layers layers) noexcept {
  return std::none_of(layers.begin(), layers.end(), [&](const ClipLayer& layer) {
    return layer.weight != 0.0f && plan.clip_tracks[layer.clip].moves_joints;
  });
}

/// in   both_alone  true if plays_alone() holds in this frame and in the last
StandingMatrices find_standing_matrices(const CompiledPlan& plan, const FrameInput& input, Layers last_layers,
                                        const LastInput& last, bool both_alone) noexcept {
  if (!same_bits(input.root, last.root)) return StandingMatrices::none;
  const bool between = input.interpolation_factor != 0.0f || last.interpolation_factor != 0.0f;
  const bool at_rest =
      !between && both_alone && leave_joints_at_rest(plan, input.layers) && leave_joints_at_rest(plan, last_layers);
  return at_rest || plan.moved_joints.empty() ? StandingMatrices::all : StandingMatrices::of_unmoved_joints;
}

/// True if each list is empty or has an entry for each of its instances.
bool has_lengths(const FrameTables& tables, const FrameInput& input) noexcept {
  return (input.out_of_view.empty() || input.out_of_view.size() == tables.input_out_of_view.size()) &&
         (input.geometry.empty() || input.geometry.size() == tables.input_geometry.size());
}

/// The value to store in FrameTables::input_geometry.
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

bool had_same_program(const LastFrame& frame, const FrameInput& input) noexcept {
  if (input.program.size() != frame.input.op_count) return false;
  if (input.program.empty() && input.program_inputs.masks.empty()) return frame.input.version_count == 0;
  const std::span<const PoseOp> last = frame.tables.input_program.first(frame.input.op_count);
  return (last.empty() || std::memcmp(input.program.data(), last.data(), last.size_bytes()) == 0) &&
         has_versions(inputs_in_use(input), frame.tables.input_versions.first(frame.input.version_count));
}

}  // namespace

bool had_same_input(const LastFrame& frame, const FrameInput& input) noexcept {
  const LastInput& last = frame.input;
  const FrameTables& tables = frame.tables;
  if (!last.is_known || input.asleep != last.asleep) return false;
  if (input.asleep) return true;  // a sleeping character shows nothing, whatever its layers are
  if (!has_lengths(tables, input)) return false;
  if (last.is_late || !had_same_geometry(tables, input) || !had_same_program(frame, input)) return false;
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

WhatStands find_what_stands(const CompiledPlan& plan, const FrameInput& input, const LastFrame& last,
                            const LastFrame& before, bool had_it) noexcept {
  WhatStands stands;
  stands.all = had_it;
  stands.all_since_before = &before.input == &last.input ? stands.all : had_same_input(before, input);
  if (stands.all || input.asleep || !last.input.is_known || last.input.asleep) return stands;
  const Layers last_layers = last.tables.input_layers.first(last.input.layer_count);
  const bool both_alone =
      input.program.empty() && last.input.op_count == 0 && plays_alone(input.layers) && plays_alone(last_layers);
  stands.matrices = find_standing_matrices(plan, input, last_layers, last.input, both_alone);
  const std::uint32_t clip = playing_clip(input.layers);
  stands.base_pose = both_alone && clip != kNone && clip == playing_clip(last_layers);
  return stands;
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
  last.op_count = input.program.size();
  const bool has_lists = !input.program.empty() || !input.program_inputs.masks.empty();
  last.version_count = has_lists ? version_count(inputs_in_use(input)) : 0;
  last.interpolation_factor = input.interpolation_factor;
  last.root = input.root;
  std::copy(input.layers.begin(), input.layers.end(), tables.input_layers.begin());
  std::copy(next_layers.begin(), next_layers.end(), tables.input_next_layers.begin());
  std::copy(input.weights.begin(), input.weights.end(), tables.input_weights.begin());
  std::copy(input.program.begin(), input.program.end(), tables.input_program.begin());
  if (has_lists) copy_versions(inputs_in_use(input), tables.input_versions);
  for (std::size_t i = 0; i < tables.input_out_of_view.size(); ++i) tables.input_out_of_view[i] = out_of_view(input, i);
  for (std::size_t s = 0; s < tables.input_geometry.size(); ++s) {
    tables.input_geometry[s] = playing(tables, input, s);
    last.is_late |= tables.shown[s].is_late;
  }
}

}  // namespace sinew
