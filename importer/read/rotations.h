// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/issue_log.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// A rotation after normalisation, with the length that the file stored.
struct UnitRotation {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  double length = 1.0;  ///< as stored
};

/// Makes a stored quaternion a unit quaternion. A length within float rounding of 1 is left alone, so that stored keys
/// stay exact (G06); zero becomes the identity (G52).
/// in    finite numbers
UnitRotation unit_rotation(double x, double y, double z, double w) noexcept;

/// Counts what is odd about a list of rotations, so that it is reported once for the whole list.
class RotationTally {
 public:
  void add(double length) noexcept;

  /// in       one, many   name the rotations: "a rotation key", "rotation keys"
  /// warning  rotation-zero, rotation-length (beyond the rounding of normalised bytes and shorts)
  void report(const std::string& place, const char* one, const char* many, IssueLog& log) const;

 private:
  std::size_t zeros_ = 0;
  double worst_ = 1.0;
};

}  // namespace sinew
