// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew::test {

/// Expects every asset that a glTF file can hold to be bit-equal, and names the first difference of each kind. Not
/// compared: node numbering of the source file, compiled clips (they follow from the animations) and vertex provenance.
void expect_equal(const Scene& before, const Scene& after);

}  // namespace sinew::test
