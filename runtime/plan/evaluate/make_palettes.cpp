// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/make_palettes.h"

#include <algorithm>
#include <cassert>

#include "runtime/deform/blend_combinations.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {
namespace {

void split(const CompiledPlan& plan, std::size_t skin, std::span<const JointMatrix> palette, FrameMemory memory,
           FrameWork& work) noexcept {
  const SplitPaletteJob job{.palette = palette,
                            .split = memory.of(plan.layout.splits[skin]),
                            .any_stretch = &memory.of(plan.layout.stretch)[skin],
                            .follow = plan.hemisphere_edges[skin]};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.palette_entries_split += palette.size();
  work.spent_on(Stage::split_palette);
}

/// Blends one matrix for each combination of joints and weights that several vertices share. The blended matrices
/// follow the joint matrices in the palette.
void combine(const CompiledPlan& plan, std::size_t skin, std::span<const JointMatrix> palette, FrameMemory memory,
             FrameWork& work) noexcept {
  for (const CombinedInfluences& combined : plan.combined[skin]) {
    if (!combined.used()) continue;
    const std::span<JointMatrix> blended =
        memory.of(plan.layout.palettes[skin].part(combined.first_matrix, combined.combination_count));
    const BlendCombinationsJob job{.combinations = &combined.combinations, .palette = palette, .blended = blended};
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    work.combinations_blended += combined.combination_count;
    work.spent_on(Stage::combinations);
  }
}

/// Computes the palette of a skin from model matrices. Returns true if it has the bits of the palette of the frame
/// before.
bool compute(const CompiledPlan& plan, std::size_t s, std::span<const Affine> model, std::span<JointMatrix> palette,
             const FrameStep& step, FrameWork& work) noexcept {
  bool unchanged = false;
  const JointPaletteJob job{.skin = plan.assets.skins[s],
                            .model = model,
                            .palette = palette,
                            .before = step.reuse.palette_before(s),
                            .unchanged = &unchanged};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.palette_entries += palette.size();
  work.spent_on(Stage::palette);
  return unchanged;
}

void make_palette(const CompiledPlan& plan, std::size_t s, std::span<const Affine> model, const FrameStep& step,
                  FrameWork& work) noexcept {
  if (step.reuse.palette_stands(s)) return step.reuse.keep_palette(s);
  const std::size_t count = plan.assets.skins[s]->joints.size();
  const std::span<JointMatrix> palette = step.memory.of(plan.layout.palettes[s].part(0, count));
  const bool as_before = compute(plan, s, model, palette, step, work);
  if (step.reuse.add_palette(s, palette, as_before)) return;
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

}  // namespace sinew
