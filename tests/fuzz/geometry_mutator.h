// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/json_mutator.h"

namespace sinew::fuzz {

/// One change of a geometry cache: of the unpacked bytes of a section, of a frame, of their order, or of the directory.
/// Sizes and checksums are written again, so that the code behind their comparison is reached. Bytes that are no cache
/// are changed as bytes.
std::vector<std::byte> mutate_geometry(Bytes file, std::uint64_t seed, const MutateBytes& mutate_bytes);

}  // namespace sinew::fuzz
