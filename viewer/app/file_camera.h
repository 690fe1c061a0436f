// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The view of a camera of the file from its joint. The scale of the joint has no effect. If the picture has another
/// aspect than the camera, it shows more at two sides, never less, and is not stretched. An orthographic camera without
/// a far plane gets one behind `bounds`. Angles and lengths that a clip animates out of their valid range are clamped.
/// in   camera             as animated in this frame;   world_from_camera  of its joint
///      aspect             width / height of the picture;   bounds  of the clip, world space
View view_of_camera(const Camera& camera, const Affine& world_from_camera, double aspect, const Aabb& bounds);

}  // namespace sinew::viewer
