// SPDX-License-Identifier: MIT
#include "runtime/plan/reuse/reuse.h"

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/plan/reuse/program_versions.h"

namespace sinew {
namespace {

bool same_played(const PlayedGeometry& a, const PlayedGeometry& b) noexcept {
  if (!same_bits(a.weight, b.weight)) return false;
  return a.weight == 0.0f ||
         (a.content == b.content && a.moment == b.moment && a.space == b.space && a.turned == b.turned &&
          same_bits(a.world_from_source, b.world_from_source) && same_bits(a.world_from_pose, b.world_from_pose));
}

/// True if the root has an influence on the pose.
bool has_world_override(const PoseProgramInputs& inputs) noexcept {
  return std::any_of(inputs.overrides.begin(), inputs.overrides.end(), [](const JointOverrides& overrides) {
    return std::any_of(overrides.joints.begin(), overrides.joints.end(),
                       [](const JointOverride& joint) { return joint.space == OverrideSpace::world; });
  });
}

/// Morph weights of one instance.
std::span<float> weights_of(const CompiledPlan& plan, std::span<float> weights, std::size_t instance) noexcept {
  const std::size_t first = plan.scene->first_weight[instance];
  return weights.subspan(first, plan.scene->first_weight[instance + 1] - first);
}

}  // namespace

Reuse::Reuse(const CompiledPlan& plan, const FrameTables& tables, const Run& last, const Run& before,
             std::uint64_t number) noexcept
    : plan_(plan),
      memory_(last.memory),
      memory_before_(before.memory),
      tables_(tables),
      before_(last.memory.start == before.memory.start ? tables_ : other_tables_.emplace(plan, before.memory)),
      number_(number) {}

Reuse::Reuse(const CompiledPlan& plan, const FrameInput& input, const FrameTables& tables, const Run& last,
             const Run& before, bool had_it, std::uint64_t number) noexcept
    : Reuse(plan, tables, last, before, number) {
  stands_ = find_what_stands(plan, input, {last.input, tables_}, {before.input, before_}, had_it);
  last_input_ = &last.input;
}

/// If a frame's input gives all morph weights, its kept operands hold none. They only fit inputs that also give them.
LastProgram Reuse::last_program(const FrameInput& input) const noexcept {
  if (last_input_ == nullptr || !last_input_->is_known || last_input_->asleep) return {};
  if (input.weights.empty() != (last_input_->weight_count == 0)) return {};
  return {tables_.input_program.first(last_input_->op_count),
          has_versions(input.program_inputs, tables_.input_versions.first(last_input_->version_count)) &&
              (same_bits(input.root, last_input_->root) || !has_world_override(input.program_inputs)),
          plan_.masks.size()};
}

bool Reuse::find_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept {
  const auto has = [&](const FrameTables& tables, FrameMemory memory, std::size_t u) {
    return tables.updates[u].is_there &&
           same_layers(layers, memory.of(plan_.layout.tables.update_layers[u]).first(tables.updates[u].layer_count));
  };
  if (has(tables_, memory_, update)) return true;
  const PoseNumbers own = memory_.of(plan_.layout.updates[update]);
  const auto take = [&](const PoseNumbers& from) {
    copy_pose(from.pose, own.pose);
    copy_numbers(from, own);
    return true;
  };
  for (std::size_t u = 0; u < 2; ++u) {
    if (has(tables_, memory_, u)) return take(memory_.of(plan_.layout.updates[u]));
    if (has(before_, memory_before_, u)) return take(memory_before_.of(plan_.layout.updates[u]));
  }
  return false;
}

void Reuse::keep_update(std::size_t update, std::span<const ClipLayer> layers) const noexcept {
  const std::span<ClipLayer> room = memory_.of(plan_.layout.tables.update_layers[update]);
  KeptUpdate& kept = tables_.updates[update];
  kept.is_there = layers.size() <= room.size();
  kept.layer_count = kept.is_there ? layers.size() : 0;
  std::copy_n(layers.begin(), kept.layer_count, room.begin());
}

bool Reuse::palette_stands(std::size_t skin) const noexcept {
  return stands_.matrices == StandingMatrices::all && tables_.palettes[skin].since_frame != 0;
}

std::span<const JointMatrix> Reuse::palette_before(std::size_t skin) const noexcept {
  return before_.palettes[skin].matrices;
}

void Reuse::keep_palette(std::size_t skin) const noexcept {
  SkinPalette& kept = tables_.palettes[skin];
  const SkinPalette& before = before_.palettes[skin];
  const bool as_before =
      !before.matrices.empty() && (stands_.all_since_before || same_bits(kept.matrices, before.matrices));
  kept.since_frame = as_before ? before.since_frame : number_;
}

bool Reuse::add_palette(std::size_t skin, std::span<const JointMatrix> palette, bool as_before) const noexcept {
  SkinPalette& kept = tables_.palettes[skin];
  const std::uint64_t since = as_before ? before_.palettes[skin].since_frame : number_;
  const bool had_it = since == kept.since_frame;
  kept = {palette, since};
  return had_it;
}

void Reuse::add_instance(std::size_t instance, std::span<const float> weights, bool mirrored) const noexcept {
  const auto number = [&](std::span<std::uint64_t> since, std::span<std::uint64_t> since_before, bool same) {
    since[instance] = same && since_before[instance] != 0 ? since_before[instance] : number_;
  };
  const std::span<float> weights_before = weights_of(plan_, before_.last_weights, instance);
  number(tables_.weights_since, before_.weights_since, same_bits<float>(weights, weights_before));
  number(tables_.winding_since, before_.winding_since, before_.instances[instance].mirrored == mirrored);
}

void Reuse::add_geometry(std::size_t slot, const PlayedGeometry& played) const noexcept {
  const std::uint64_t since_before = before_.geometry_since[slot];
  const bool same = since_before != 0 && same_played(played, before_.played[slot]);
  tables_.geometry_since[slot] = same ? since_before : number_;
  tables_.played[slot] = played;
}

std::uint64_t Reuse::vertices_since(const PrimitivePlan& planned) const noexcept {
  std::uint64_t since = 0;
  const std::uint32_t i = planned.instance;
  if (planned.flat_normals) since = std::max(since, tables_.winding_since[i]);
  if (planned.cached.any()) {
    const std::uint32_t slot = geometry_slot_of(plan_, i);
    since = std::max(since, tables_.geometry_since[slot]);
    if (tables_.played[slot].in_full()) return since;
  }
  if (planned.skin.any()) since = std::max(since, tables_.palettes[plan_.scene->instances[i].skin].since_frame);
  if (planned.morph.any() || planned.morph_colors) since = std::max(since, tables_.weights_since[i]);
  return since;
}

bool Reuse::box_stands(std::size_t instance, const Affine& world_from_mesh) const noexcept {
  const InstanceResult& last = tables_.instances[instance];
  if (last.bounds.empty() || !same_bits(last.world_from_mesh, world_from_mesh)) return false;
  for (std::uint32_t p = plan_.first_primitive[instance]; p < plan_.first_primitive[instance + 1]; ++p)
    if (!vertices_stand(p, vertices_since(plan_.primitives[p]))) return false;
  return true;
}

void Reuse::add_weights(std::span<const float> weights) const noexcept {
  std::copy(weights.begin(), weights.end(), tables_.last_weights.begin());
}

void Reuse::keep_all() const noexcept {
  if (&before_ == &tables_) return;  // it used the same memory, where all parts already have their numbers
  for (std::size_t s = 0; s < tables_.palettes.size(); ++s)
    if (tables_.palettes[s].since_frame != 0) keep_palette(s);
  for (std::size_t i = 0; i < tables_.instances.size(); ++i)
    if (tables_.weights_since[i] != 0)  // 0 means that the character sleeps
      add_instance(i, weights_of(plan_, tables_.last_weights, i), tables_.instances[i].mirrored);
  for (std::size_t slot = 0; slot < tables_.geometry_since.size(); ++slot)
    if (tables_.geometry_since[slot] != 0) add_geometry(slot, PlayedGeometry(tables_.played[slot]));
  for (std::size_t p = 0; p < tables_.primitives.size(); ++p)
    if (tables_.primitives[p].since_frame != 0) tables_.primitives[p].since_frame = vertices_since(plan_.primitives[p]);
}

void Reuse::forget_all() const noexcept {
  std::fill(tables_.palettes.begin(), tables_.palettes.end(), SkinPalette{});
  std::fill(tables_.weights_since.begin(), tables_.weights_since.end(), 0);
  std::fill(tables_.winding_since.begin(), tables_.winding_since.end(), 0);
  std::fill(tables_.geometry_since.begin(), tables_.geometry_since.end(), 0);
}

}  // namespace sinew
