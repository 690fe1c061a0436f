// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {

/// Imports the bytes. A refused file must name a rule. An accepted file must pass the checks of the runtime, and one
/// frame of its first clip must run.
void import_and_evaluate(Bytes file);

/// The .glb that read_accessors() builds from an input.
std::vector<std::byte> accessor_file(Bytes input);

}  // namespace sinew::fuzz
