// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/vrm.h"
#include "runtime/model/scene.h"
#include "runtime/procedures/expressions/expressions.h"

namespace sinew {

/// Expressions of a character, in the order of the file, for ExpressionsJob. Binds whose mesh has no such target are
/// left out.
/// in   scene  that the character belongs to
/// cost O(binds), allocates
std::vector<Expression> expressions_of(const VrmCharacter& vrm, const Scene& scene);

}  // namespace sinew
