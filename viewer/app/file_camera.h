// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// What the camera sees from its joint; scale of the joint has no effect. Where the picture has another shape than the
/// camera, it shows more at two sides and never less: nothing is cut off or stretched. An orthographic camera without
/// far plane gets one behind `bounds`. Angles and lengths that a clip moves out of their range count as the nearest
/// that make sense. in   camera   of this frame's look;   world_from_camera   of its joint;   aspect   width / height
/// of the picture
View view_of_camera(const Camera& camera, const Affine& world_from_camera, double aspect, const Aabb& bounds);

}  // namespace sinew::viewer
