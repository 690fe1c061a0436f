// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace sinew {

/// The executor used when an engine gives none: oneTBB, in the arena of the calling thread.
void run_with_tbb(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace sinew
