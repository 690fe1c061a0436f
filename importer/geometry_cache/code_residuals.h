// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "importer/geometry_cache/fit_block.h"

namespace sinew {

/// Takes the code and the width of each axis that need the fewest bits; packed residuals (no code) are one choice.
void choose_codes(FittedBlock& block);

/// Writes the codes section of a frame (residual_code.h).
/// out  empty if no block has a code
std::vector<std::uint8_t> write_codes(std::span<const FittedBlock> blocks);

}  // namespace sinew
