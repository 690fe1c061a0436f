// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "runtime/animation/mirror_map.h"
#include "runtime/math/transform.h"

/// The rows of a MirrorMap in plain double loops. The test mirror_map_test checks the rows against their definition.
namespace sinew::reference {

template <std::size_t kCount>
double row_times(const MirrorRow<kCount>& row, const double* numbers) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) sum += row[i] * numbers[i];
  return sum;
}

/// eq   rows * numbers of the partner, + offset
inline Transformd mirrored_plainly(const MirroredJoint& to, const Transformd& from) {
  const double q[] = {from.rotation.x, from.rotation.y, from.rotation.z, from.rotation.w};
  const auto vector = [](const std::array<MirrorRow<3>, 3>& rows, const Vec3<double>& v) {
    return Vec3<double>(row_times(rows[0], &v.x), row_times(rows[1], &v.x), row_times(rows[2], &v.x));
  };
  return {vector(to.translation, from.translation) + to.offset,
          quat_xyzw(row_times(to.rotation[0], q), row_times(to.rotation[1], q), row_times(to.rotation[2], q),
                    row_times(to.rotation[3], q)),
          vector(to.scale, from.scale)};
}

}  // namespace sinew::reference
