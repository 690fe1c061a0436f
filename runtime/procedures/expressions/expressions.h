// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"

namespace sinew {

/// A morph weight that an expression sets.
struct ExpressionBind {
  std::uint32_t weight = 0;  ///< index into the morph weights of a pose
  float value = 1.0f;        ///< at full expression
};

/// A facial expression of a character (VRM 1.0).
struct Expression {
  /// Expressions that others can hold back.
  enum class Part : std::uint8_t { other, blink, look_at, mouth };
  /// How an expression holds back a part of the face.
  enum class Override : std::uint8_t {
    none,
    block,  ///< wholly, as soon as the expression has a value above 0
    blend,  ///< by its value
  };

  std::string name;
  bool is_binary = false;  ///< fully on above 0.5, else off
  Part part = Part::other;
  Override blink = Override::none, look_at = Override::none, mouth = Override::none;
  std::vector<ExpressionBind> binds;
};

/// The part of the face that a preset of VRM 1.0 belongs to: "blinkLeft", "lookUp", "aa", ...
SINEW_API Expression::Part part_of_preset(const std::string& preset) noexcept;

/// Morph weights of a face from the values of its expressions.
/// eq   v = value, or for a binary expression 1 above 0.5, else 0   (VRMC_vrm 1.0, expressions)
///      f(part) = max(0, 1 - sum of v over expressions that blend the part - count of those that block it)
///      weight += bind (v f(part of the expression)); a binary expression that is held back at all is off
/// in   expressions[E];   values[E]  0 to 1
/// out  weights[W]  of the pose; expressions add to them
/// err  size_mismatch, not_a_fraction, index_out_of_range     cost O(binds), no allocation
struct ExpressionsJob {
  std::span<const Expression> expressions;
  std::span<const float> values;
  std::span<float> weights;
};

SINEW_API ErrorCode check(const ExpressionsJob& job) noexcept;
SINEW_API void run_unchecked(const ExpressionsJob& job) noexcept;

}  // namespace sinew
