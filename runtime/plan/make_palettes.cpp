// SPDX-License-Identifier: MIT
#include "runtime/plan/make_palettes.h"

#include <algorithm>
#include <cassert>

#include "runtime/base/same_bits.h"
#include "runtime/deform/blend_combinations.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {
namespace {

void split(const CompiledPlan& plan, std::size_t skin, std::span<const JointMatrix> palette, FrameMemory memory,
           FrameWork& work) noexcept {
  const SplitPaletteJob job{.palette = palette,
                            .split = memory.array<RigidStretch>(plan.layout.split_at[skin], palette.size()),
                            .any_stretch = &memory.array<bool>(plan.layout.stretch_at, plan.split.size())[skin],
                            .follow = plan.hemisphere_edges[skin]};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.palette_entries_split += palette.size();
  work.spent_on(Stage::split_palette);
}

/// The matrices that vertices share, behind those of the joints.
void combine(const CompiledPlan& plan, std::size_t skin, std::span<const JointMatrix> palette, FrameMemory memory,
             FrameWork& work) noexcept {
  for (const CombinedInfluences& combined : plan.combined[skin]) {
    if (!combined.used()) continue;
    const std::span<JointMatrix> all =
        memory.array<JointMatrix>(plan.layout.palette_at[skin], combined.first_matrix + combined.combination_count);
    const BlendCombinationsJob job{
        .combinations = &combined.combinations, .palette = palette, .blended = all.subspan(combined.first_matrix)};
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    work.combinations_blended += combined.combination_count;
    work.spent_on(Stage::combinations);
  }
}

/// The palette of the frame before; empty when it had none.
std::span<const JointMatrix> palette_before(const CompiledPlan& plan, std::size_t s, const FrameStep& step) noexcept {
  const bool has_one = step.tables_before.palettes[s].since_frame != 0;
  return step.memory_before.array<const JointMatrix>(plan.layout.palette_at[s],
                                                     has_one ? plan.assets.skins[s]->joints.size() : 0);
}

/// Palette of a skin from the model matrices. Returns whether it is that of the frame before.
bool compute(const CompiledPlan& plan, std::size_t s, std::span<const Affine> model, std::span<JointMatrix> palette,
             const FrameStep& step, FrameWork& work) noexcept {
  bool unchanged = false;
  const JointPaletteJob job{.skin = plan.assets.skins[s],
                            .model = model,
                            .palette = palette,
                            .before = palette_before(plan, s, step),
                            .unchanged = &unchanged};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.palette_entries += palette.size();
  work.spent_on(Stage::palette);
  return unchanged;
}

/// Whether a palette that is there already is that of the frame before.
bool is_as_before(const CompiledPlan& plan, std::size_t s, std::span<const JointMatrix> palette,
                  const FrameStep& step) noexcept {
  const std::span<const JointMatrix> before = palette_before(plan, s, step);
  return !before.empty() && (step.changes.nothing_since_before || same_bits(palette, before));
}

/// The frame since which a palette holds.
std::uint64_t since_of(std::size_t s, bool as_before, const FrameStep& step) noexcept {
  return as_before ? step.tables_before.palettes[s].since_frame : step.number;
}

void make_palette(const CompiledPlan& plan, std::size_t s, std::span<const Affine> model, const FrameStep& step,
                  FrameWork& work) noexcept {
  const std::size_t count = plan.assets.skins[s]->joints.size();
  const std::span<JointMatrix> palette = step.memory.array<JointMatrix>(plan.layout.palette_at[s], count);
  SkinPalette& kept = step.tables.palettes[s];
  const bool is_there = step.changes.current_matrices == CurrentMatrices::all && kept.since_frame != 0;
  const bool as_before = is_there ? is_as_before(plan, s, palette, step) : compute(plan, s, model, palette, step, work);
  const std::uint64_t since = since_of(s, as_before, step);
  const bool is_current = is_there || since == kept.since_frame;
  kept = {palette, since};
  if (is_current) return;
  if (plan.split[s]) split(plan, s, palette, step.memory, work);
  combine(plan, s, palette, step.memory, work);
}

}  // namespace

void make_palettes(const CompiledPlan& plan, std::span<const Affine> model, std::span<const bool> wanted,
                   const FrameStep& step, FrameWork& work) noexcept {
  for (std::size_t s = 0; s < plan.palette.size(); ++s) {
    if (!plan.palette[s]) continue;
    if (wanted.empty() || wanted[s])
      make_palette(plan, s, model, step, work);
    else
      step.tables.palettes[s] = {};
  }
}

void number_kept_palettes(const CompiledPlan& plan, const FrameStep& step) noexcept {
  for (std::size_t s = 0; s < plan.palette.size(); ++s) {
    SkinPalette& kept = step.tables.palettes[s];
    if (kept.since_frame != 0) kept.since_frame = since_of(s, is_as_before(plan, s, kept.matrices, step), step);
  }
}

}  // namespace sinew
