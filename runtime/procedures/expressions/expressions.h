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
  float value = 1.0f;        ///< weight when the expression has the value 1
};

/// A facial expression of a character (VRM 1.0).
struct Expression {
  /// Parts of the face. Expressions of a part other than `other` can be weakened by other expressions.
  enum class Part : std::uint8_t { other, blink, look_at, mouth };
  /// How an expression weakens the expressions of a part.
  enum class Override : std::uint8_t {
    none,
    block,  ///< turns them off as soon as its own value is above 0
    blend,  ///< subtracts its own value from their factor
  };

  std::string name;
  bool is_binary = false;  ///< the value counts as 1 above 0.5, else as 0
  Part part = Part::other;
  Override blink = Override::none, look_at = Override::none, mouth = Override::none;
  std::vector<ExpressionBind> binds;
};

/// The part of the face that a preset of VRM 1.0 belongs to: "blinkLeft", "lookUp", "aa", ...
SINEW_API Expression::Part part_of_preset(const std::string& preset) noexcept;

/// Morph weights of a face from the values of its expressions.
/// eq   v = value, or for a binary expression 1 above 0.5, else 0   (VRMC_vrm 1.0, expressions)
///      f(part) = max(0, 1 - sum of v over expressions that blend the part - count of active expressions that block it)
///      weight += bind (v f(part of the expression)); a binary expression with f below 1 is off
/// in   expressions[E];   values[E]  0 to 1
/// out  weights[W]  morph weights of the pose, to which expressions add
/// err  size_mismatch, not_a_fraction, index_out_of_range     cost O(binds), no allocation
struct ExpressionsJob {
  std::span<const Expression> expressions;
  std::span<const float> values;
  std::span<float> weights;
};

SINEW_API ErrorCode check(const ExpressionsJob& job) noexcept;
SINEW_API void run_unchecked(const ExpressionsJob& job) noexcept;

}  // namespace sinew
