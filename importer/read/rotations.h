// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/issue_log.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// A normalised rotation, and its original length.
struct UnitRotation {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  double length = 1.0;  ///< length in the file
};

/// Normalises a quaternion. A length within float rounding of 1 is left unchanged, so that keys stay exact; zero
/// becomes the identity.
/// in    all numbers are finite
UnitRotation unit_rotation(double x, double y, double z, double w) noexcept;

/// Counts invalid rotations of a list, so that they are reported once.
class RotationTally {
 public:
  void add(double length) noexcept;

  /// True if report() has something to report, so that callers need not make a place before.
  bool has_issues() const noexcept;

  /// Reports each kind of invalid rotation once, with its count.
  /// in       one, many   nouns for the report: "a rotation key", "rotation keys"
  /// warning  rotation-zero, rotation-length (if beyond the rounding of normalised integers)
  void report(const std::string& place, const char* one, const char* many, IssueLog& log) const;

 private:
  std::size_t zeros_ = 0;
  double worst_ = 1.0;
};

}  // namespace sinew
