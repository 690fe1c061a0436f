// SPDX-License-Identifier: MIT
#pragma once
#include <hwy/highway.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sinew::test {

/// Instruction sets that this build has kernels for and this machine can run.
inline std::vector<std::int64_t> simd_targets() { return hwy::SupportedAndGeneratedTargets(); }

inline std::string simd_name(std::int64_t target) { return hwy::TargetName(target); }

/// True if `a * b + c` rounds once with this instruction set. SSE and the scalar fallback round twice.
inline bool fuses_multiply_add(std::int64_t target) {
  constexpr std::int64_t kRoundTwice = HWY_SSSE3 | HWY_SSE4 | HWY_EMU128 | HWY_SCALAR
#ifdef HWY_SSE2
                                       | HWY_SSE2
#endif
      ;
  return (target & kRoundTwice) == 0;
}

/// Restricts the jobs to one instruction set until allow_all_targets().
inline void allow_only(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}
inline void allow_all_targets() { allow_only(0); }

/// Restricts the jobs to one instruction set during its lifetime.
class OnlyTarget {
 public:
  explicit OnlyTarget(std::int64_t target) { allow_only(target); }
  ~OnlyTarget() { allow_all_targets(); }
  OnlyTarget(const OnlyTarget&) = delete;
  OnlyTarget& operator=(const OnlyTarget&) = delete;
};

}  // namespace sinew::test
