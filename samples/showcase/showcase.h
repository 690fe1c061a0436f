// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew::showcase {

/// A built-in scene, made by code: no file is needed to see what the runtime does.
struct ShowcaseScene {
  std::string name;             ///< short, for a menu
  std::string what_to_look_at;  ///< one sentence for the person watching
  Scene scene;
  Needs needs;
  glm::vec3 eye{0.0f}, target{0.0f};
  float fov_y_rad = 0.7f;
};

/// A stylised skull flies over a floor with a box and rows of columns that carry spheres: contact shadows by ambient
/// occlusion. One BoneAnimation of five keyframes drives it.
ShowcaseScene skull_flight();

/// The same arm twisted 0..180 degrees three times: linear-blend skinning collapses, dual quaternions and centers of
/// rotation keep its volume. Who shows it makes the centers (add_centers_of_rotation); without them the third arm is
/// the first again.
ShowcaseScene twisted_arms();

/// Twisted arms again, the left one under linear blending with corrective shapes: pose-space deformation gives it the
/// volume that dual quaternions keep. Played by samples/correct_a_twist; not in the list below, since files cannot
/// carry correctives.
ShowcaseScene corrected_arms();

/// A face of morph targets, with weights below 0 and above 1.
ShowcaseScene morphed_face();

/// All of them, in this order.
std::vector<ShowcaseScene> showcase();

}  // namespace sinew::showcase
