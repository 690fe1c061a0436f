// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/issue_log.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// How a stored quaternion became a unit one.
struct UnitRotation {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  double length = 1.0;  ///< as stored
};

/// Numbers of a quaternion as stored, as a unit quaternion. Within the rounding of floats they are left alone, so that
/// stored keys stay exact (G06); zero becomes the identity (G52). Finite input.
UnitRotation unit_rotation(double x, double y, double z, double w) noexcept;

/// What was odd about a list of rotations, said once for all of them.
class RotationTally {
 public:
  void add(double length) noexcept;

  /// `one` and `many` name them: "a rotation key", "rotation keys".
  /// warning rotation-zero, rotation-length (beyond what normalised bytes and shorts lose)
  void report(const std::string& place, const char* one, const char* many, IssueLog& log) const;

 private:
  std::size_t zeros_ = 0;
  double worst_ = 1.0;
};

}  // namespace sinew
