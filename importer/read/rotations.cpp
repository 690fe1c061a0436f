// SPDX-License-Identifier: MIT
#include "importer/read/rotations.h"

#include <cmath>

namespace sinew {
namespace {

constexpr double kNoLength = 1e-12;
constexpr double kKeyTolerance = 0.00769;  // rounding error of normalised bytes and shorts

}  // namespace

UnitRotation unit_rotation(double x, double y, double z, double w) noexcept {
  constexpr double kFloatRounding = 2.5e-7;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  UnitRotation out;
  out.length = length;
  if (!(length > kNoLength)) return out;
  const double factor = std::abs(length - 1.0) <= kFloatRounding ? 1.0 : 1.0 / length;
  out.rotation = quat_xyzw(static_cast<float>(x * factor), static_cast<float>(y * factor),
                           static_cast<float>(z * factor), static_cast<float>(w * factor));
  return out;
}

void RotationTally::add(double length) noexcept {
  if (length <= kNoLength)
    ++zeros_;
  else if (std::abs(length - 1.0) > std::abs(worst_ - 1.0))
    worst_ = length;
}

bool RotationTally::has_issues() const noexcept { return zeros_ > 0 || std::abs(worst_ - 1.0) > kKeyTolerance; }

void RotationTally::report(const std::string& place, const char* one, const char* many, IssueLog& log) const {
  if (zeros_ > 0)
    log.report(Rule::rotation_zero, place,
               std::to_string(zeros_) + ' ' + many + " have no length; taken as no rotation");
  if (std::abs(worst_ - 1.0) > kKeyTolerance)
    log.report(Rule::rotation_length, place,
               std::string(one) + " has length " + std::to_string(worst_) + "; normalised");
}

}  // namespace sinew
