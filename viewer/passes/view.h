// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// A camera that looks along -z of its own space, +y up. Depth is reversed, 0 where nothing was drawn (N30). Double
/// precision, because the product with a mesh's matrix is where large world coordinates cancel (N25).
/// eq   perspective:  clip = (x * c / aspect, y * c, near * (far + z) / (far - near), -z),  c = cot(fov_y/2);
///                    with the far plane at infinity the depth is near / distance
///      parallel:     clip = (x / (h * aspect), y / h, (far + z) / (far - near), 1),  h = half_height_m
struct View {
  Affined view_from_world;
  double fov_y_rad = 0.8;
  double near_m = 0.01;
  double half_height_m = 0.0;  ///< above 0: parallel projection, which shows this much above the middle
  double far_m = 0.0;          ///< above near_m; 0 = infinite, which a parallel projection cannot have

  bool parallel() const noexcept { return half_height_m > 0.0; }
};

/// No point of the box can be in the picture.
/// in   view_from_box  from the box's space, also with scale and shear;   aspect  width / height of the picture
/// cost O(1); keeps a margin of a ten-thousandth for the rounding of the GPU. An empty box is taken for one of unknown
/// size.
bool is_out_of_view(const View& view, double aspect, const Affined& view_from_box, const Aabb& box) noexcept;

/// Rotation and position from an eye point towards a target; any `up` that is not parallel to the line of sight, and a
/// safe substitute when it is.
/// in   eye, target  world space, metres
View look_at(const glm::dvec3& eye, const glm::dvec3& target, double fov_y_rad, double near_m,
             const glm::dvec3& up = {0.0, 1.0, 0.0});

/// Where `look_at` stands.
glm::dvec3 eye_of(const View& view);

/// A view that shows the whole box from the front, slightly from the right and above, with a near plane to match.
/// in   bounds  world space; an empty box gives a view of the unit cube;   aspect  width / height
View view_of_all(const Aabb& bounds, double fov_y_rad, double aspect);

/// A near plane for an eye at this distance from the middle of `bounds`: as far out as it can be without cutting them.
double near_plane_for(const glm::dvec3& eye, const Aabb& bounds);

}  // namespace sinew::viewer
