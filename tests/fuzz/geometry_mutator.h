// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/json_mutator.h"

namespace sinew::fuzz {

/// Makes one change of a geometry cache: in the unpacked bytes of a section, in a frame, in the order of frames, or in
/// the directory. Sizes and checksums are corrected, so that the code behind their checks runs. Bytes that are not a
/// cache are changed as plain bytes.
std::vector<std::byte> mutate_geometry(Bytes file, std::uint64_t seed, const MutateBytes& mutate_bytes);

}  // namespace sinew::fuzz
