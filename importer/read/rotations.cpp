// SPDX-License-Identifier: MIT
#include "importer/read/rotations.h"

#include <cmath>

namespace sinew {

UnitRotation unit_rotation(double x, double y, double z, double w) noexcept {
  constexpr double kFloatRounding = 2.5e-7;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  UnitRotation out;
  out.length = length;
  if (!(length > 1e-12)) return out;
  const double factor = std::abs(length - 1.0) <= kFloatRounding ? 1.0 : 1.0 / length;
  out.rotation = quat_xyzw(static_cast<float>(x * factor), static_cast<float>(y * factor), static_cast<float>(z * factor),
                           static_cast<float>(w * factor));
  return out;
}

}  // namespace sinew
