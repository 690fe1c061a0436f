// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/math/affine.h"
#include "runtime/model/scene.h"

namespace sinew::cost {

/// How far normals are from the great arc between the normals of two vertices, in degrees, for one way to interpolate.
struct ArcError {
  double largest = 0.0, mean = 0.0;
};

/// The errors of both ways in which the viewer interpolates normals, over all edges of a scene.
struct NormalAngles {
  ArcError linear, quaternion;
  std::size_t samples = 0;  ///< 0 = no mesh has its own normals
};

/// Compares points at a quarter, a half and three quarters of every edge whose vertices have normals. Each is seen
/// along the six axes, because quaternions depend on the view. Only points that face the eye count.
/// eq   linear: (1 - t) a + t b, normalised;  quaternion: Hast 2005, eqs. 16 and 17
///      (viewer/shaders/quaternion_normal.glsl)
/// cost O(triangles)
NormalAngles normal_angles(const Scene& scene);

}  // namespace sinew::cost
