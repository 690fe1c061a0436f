// SPDX-License-Identifier: MIT
#include "runtime/animation/skeleton.h"

#include <algorithm>

namespace sinew {

std::optional<std::uint32_t> Skeleton::find(std::string_view name) const noexcept {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - names.begin());
}

}  // namespace sinew
