// SPDX-License-Identifier: MIT
#pragma once
#include <ostream>
#include <span>
#include <vector>

#include "runtime/jobs/skin_center_of_rotation.h"
#include "runtime/jobs/skin_dual_quaternion.h"
#include "runtime/jobs/skin_linear.h"
#include "tests/support/skinned_vertices.h"

namespace sinew::test {

/// Every way in which the jobs skin a vertex and its normal.
enum class Way { linear, linear_cofactor, dual_quaternion, center_of_rotation };

inline constexpr Way kWays[] = {Way::linear, Way::linear_cofactor, Way::dual_quaternion, Way::center_of_rotation};

inline std::ostream& operator<<(std::ostream& out, Way way) {
  constexpr const char* kNames[] = {"linear", "linear_cofactor", "dual_quaternion", "center_of_rotation"};
  return out << kNames[static_cast<int>(way)];
}

/// Skins `s` into its outputs. `centers` are the vertices' centers of rotation.
inline void skin(Way way, SkinnedVertices& s, std::span<const glm::vec3> centers) {
  if (way == Way::linear || way == Way::linear_cofactor) {
    const auto rule = way == Way::linear ? NormalRule::linear : NormalRule::cofactor;
    return run(SkinLinearJob{&s.influences, s.palette, s.in(), s.out(), rule});
  }
  std::vector<RigidStretch> split(s.palette.size());
  bool any_stretch = false;
  run(SplitPaletteJob{s.palette, split, &any_stretch});
  if (way == Way::dual_quaternion) run(SkinDualQuaternionJob{&s.influences, split, any_stretch, s.in(), s.out()});
  else run(SkinCenterOfRotationJob{&s.influences, s.palette, split, any_stretch, centers, s.in(), s.out()});
}

}  // namespace sinew::test
