// SPDX-License-Identifier: MIT
#include "runtime/pose/simd/choose_instruction_set.h"

#include <hwy/targets.h>

namespace sinew {

void choose_instruction_set() noexcept {
  if (!hwy::GetChosenTarget().IsInitialized()) hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace sinew
