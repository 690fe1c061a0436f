// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew::showcase {

/// A built-in, procedural scene, to show the runtime without a file.
struct ShowcaseScene {
  std::string name;             ///< short, for a menu
  std::string what_to_look_at;  ///< a sentence for the user about what the scene shows
  Scene scene;
  Needs needs;
  std::span<const std::byte> geometry_cache = {};  ///< a file that plays over the scene; empty = none
  glm::vec3 eye{0.0f}, target{0.0f};
  float fov_y_rad = 0.7f;
};

/// A skull flies between rows of columns with copper spheres, past a ball of lacquer and one of gold. Shows shadows,
/// reflections and ambient occlusion. One BoneAnimation of five keyframes moves the skull.
ShowcaseScene skull_flight();

/// The same arm three times, twisted by 0 to 180 degrees: linear blend skinning collapses, dual quaternions and centers
/// of rotation keep the volume. Call add_centers_of_rotation before showing it; without centers the third arm is
/// skinned like the first.
ShowcaseScene twisted_arms();

/// Twisted arms, the left one with linear blend skinning and corrective shapes: pose space deformation restores the
/// volume that dual quaternions keep. Shown by samples/correct_a_twist. It is not in showcase(), because files cannot
/// contain correctives.
ShowcaseScene corrected_arms();

/// A face of morph targets, with weights below 0 and above 1.
ShowcaseScene morphed_face();

/// A flag on a pole: flat in the scene, animated by a geometry cache.
/// in   cache  flag_cache(), or empty for the scene alone
ShowcaseScene flag_in_wind(std::span<const std::byte> cache);

inline constexpr char kFlagMesh[] = "flag";
inline constexpr double kFlagBudget_m = 5e-4;  ///< a tenth of a pixel if the flag fills a picture of 720 rows

/// The geometry cache (.sgeo) of that flag: flag_flight(), baked within kFlagBudget_m when the library is built.
std::span<const std::byte> flag_cache();

/// skull_flight, twisted_arms, morphed_face, and flag_in_wind if its cache is given, in this order.
std::vector<ShowcaseScene> showcase(std::span<const std::byte> flag_cache = {});

}  // namespace sinew::showcase
