// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

inline constexpr std::uint32_t kNone = 0xffffffffu;  ///< "no index": no parent, no skin, no material

}  // namespace sinew
