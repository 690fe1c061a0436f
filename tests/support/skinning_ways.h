// SPDX-License-Identifier: MIT
#pragma once
#include <ostream>
#include <span>
#include <vector>

#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "runtime/deform/skin_linear.h"
#include "tests/support/skinned_vertices.h"

namespace sinew::test {

/// Every kind of skinning and rule for normals that the jobs have.
enum class Way { linear, linear_cofactor, dual_quaternion, center_of_rotation };

inline constexpr Way kWays[] = {Way::linear, Way::linear_cofactor, Way::dual_quaternion, Way::center_of_rotation};

inline std::ostream& operator<<(std::ostream& out, Way way) {
  constexpr const char* kNames[] = {"linear", "linear_cofactor", "dual_quaternion", "center_of_rotation"};
  return out << kNames[static_cast<int>(way)];
}

/// Skins `s` into its outputs by `influences`. `centers` are the vertices' centers of rotation.
inline void skin(Way way, SkinnedVertices& s, std::span<const glm::vec3> centers, const InfluenceStreams& influences) {
  if (way == Way::linear || way == Way::linear_cofactor) {
    const auto rule = way == Way::linear ? NormalRule::linear : NormalRule::cofactor;
    return run_unchecked(SkinLinearJob{influences, s.palette, s.in(), s.out(), rule});
  }
  std::vector<RigidStretch> split(s.palette.size());
  bool any_stretch = false;
  run_unchecked(SplitPaletteJob{s.palette, split, &any_stretch});
  if (way == Way::dual_quaternion)
    run_unchecked(SkinDualQuaternionJob{influences, split, any_stretch, s.in(), s.out()});
  else
    run_unchecked(SkinCenterOfRotationJob{influences, s.palette, split, any_stretch, centers, s.in(), s.out()});
}

/// The same by the influences of `s`.
inline void skin(Way way, SkinnedVertices& s, std::span<const glm::vec3> centers) {
  skin(way, s, centers, &s.influences);
}

}  // namespace sinew::test
