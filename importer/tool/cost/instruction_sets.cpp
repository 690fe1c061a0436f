// SPDX-License-Identifier: MIT
#include "importer/tool/cost/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "importer/tool/cost/instruction_sets.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::cost::HWY_NAMESPACE {

std::size_t float_lanes() { return hwy::HWY_NAMESPACE::Lanes(hwy::HWY_NAMESPACE::ScalableTag<float>()); }

}  // namespace sinew::cost::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew::cost {
namespace {

HWY_EXPORT(float_lanes);

/// True if the instruction set has fused multiply-add. SSE and the plain fallbacks round products and sums separately.
bool fuses(std::int64_t target) {
  constexpr std::int64_t kRoundTwice = HWY_SSSE3 | HWY_SSE4 | HWY_EMU128 | HWY_SCALAR
#ifdef HWY_SSE2
                                       | HWY_SSE2
#endif
      ;
  return (target & kRoundTwice) == 0;
}

void choose(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

void allow_only(const InstructionSet& set) { choose(set.target); }
void allow_all_instruction_sets() { choose(0); }

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    InstructionSet set{target, hwy::TargetName(target), 1, fuses(target), sets.empty()};
    allow_only(set);
    set.float_lanes = HWY_DYNAMIC_DISPATCH(float_lanes)();
    sets.push_back(std::move(set));
  }
  allow_all_instruction_sets();
  return sets;
}

}  // namespace sinew::cost
#endif  // HWY_ONCE
