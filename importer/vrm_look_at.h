// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "importer/vrm.h"
#include "runtime/procedures/look_at/look_at.h"

namespace sinew {

/// Eyes of a character, for prepare_eyes. Nothing if the file names no head or no way to look. A character of VRM 0
/// faces -z, one of VRM 1 +z.
/// cost O(bones)
std::optional<EyesSetup> eyes_of(const VrmCharacter& vrm);

/// Indices into VrmCharacter::expressions of the presets lookLeft, lookRight, lookUp and lookDown; kNone = the file has
/// none.
struct LookExpressions {
  std::uint32_t left = kNone, right = kNone, up = kNone, down = kNone;
};
LookExpressions look_expressions_of(const VrmCharacter& vrm);

/// Writes the weights of a gaze to the values of expressions (ExpressionsJob::values).
/// in   values  [expressions of the file]
void set_look_values(const LookExpressions& of, const Gaze& gaze, std::span<float> values) noexcept;

}  // namespace sinew
