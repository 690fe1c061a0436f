// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// A camera that looks along -z of view space, with +y up. Depth is reversed; 0 means nothing was drawn. Stored in
/// double precision, because large world coordinates cancel in the product with a mesh's matrix.
/// eq   perspective:  clip = (x * c / aspect, y * c, near * (far + z) / (far - near), -z),  c = cot(fov_y/2); with an
///      infinite far plane, depth = near / distance
///      parallel:     clip = (x / (h * aspect), y / h, (far + z) / (far - near), 1),  h = half_height_m
struct View {
  Affined view_from_world;
  double fov_y_rad = 0.8;
  double near_m = 0.01;
  double half_height_m = 0.0;  ///< above 0: orthographic, with this half height; 0 = perspective
  double far_m = 0.0;          ///< above near_m; 0 = infinite (perspective only)

  bool parallel() const noexcept { return half_height_m > 0.0; }
};

/// True if the box is certainly outside the view frustum. An empty box means unknown bounds and is never out of view. A
/// margin of 1e-4 allows for GPU rounding.
/// in   view_from_box  may scale and shear;   aspect  width / height of the picture
/// cost O(1)
bool is_out_of_view(const View& view, double aspect, const Affined& view_from_box, const Aabb& box) noexcept;

/// A view from an eye point towards a target. If both are equal, it looks along -z of the world.
/// eq   rows r, u, v with v = eye - target, r = up x v, u = v x r, each unit; translation -(rows eye) (Real-Time
///      Rendering, eqs. 4.18, 4.19). If `up` is parallel to v or zero, -z or +x of the world replaces it.
/// in   eye, target  world space, metres
View look_at(const glm::dvec3& eye, const glm::dvec3& target, double fov_y_rad, double near_m,
             const glm::dvec3& up = {0.0, 1.0, 0.0});

/// Position of the eye, world space.
glm::dvec3 eye_of(const View& view);

/// A view of the whole box from the front, slightly from the right and above. The near plane is chosen to fit.
/// in   bounds  world space; an empty box gives a view of the unit cube;   aspect  width / height
View view_of_all(const Aabb& bounds, double fov_y_rad, double aspect);

/// Matrix from view space to clip space, with reversed depth and y up.
/// in   aspect  width / height of the picture
Mat4<double> clip_from_view(const View& view, double aspect);

/// The largest near distance for this eye that does not clip `bounds`.
double near_plane_for(const glm::dvec3& eye, const Aabb& bounds);

}  // namespace sinew::viewer
