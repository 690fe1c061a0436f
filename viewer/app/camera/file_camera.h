// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The view of one of the file's cameras, placed by its joint. The joint's scale has no effect. If picture and camera
/// differ in aspect, the picture shows more on two sides; it is never cropped or stretched. An orthographic camera
/// without a far plane gets one behind `bounds`. Angles and lengths that a clip animates out of their valid range are
/// clamped.
/// in   camera             with this frame's animated values;   world_from_camera  matrix of its joint
///      aspect             width / height of the picture;   bounds  of the clip, world space
View view_of_camera(const Camera& camera, const Affine& world_from_camera, double aspect, const Aabb& bounds);

}  // namespace sinew::viewer
