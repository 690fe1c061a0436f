// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew::showcase {

// A human skull that looks along +Z, in centimetres, as signed distances. The origin lies between the ear canals, at
// the height of the lower rims of the eye sockets. Sizes are those of a grown man.

/// The skull without the lower jaw and without teeth.
float cranium(const glm::vec3& p);

/// The lower jaw, a little open, without teeth.
float mandible(const glm::vec3& p);

/// Teeth stand on half an ellipse of `radii` around (0, y, z). The lower row moves with the jaw.
struct ToothRow {
  glm::vec2 radii;
  float y, z;
};
inline constexpr float kJawDrop = 0.7f;
inline constexpr ToothRow kUpperRow{{2.9f, 4.9f}, -4.55f, 3.8f}, kLowerRow{{2.75f, 4.7f}, -6.4f - kJawDrop, 3.7f};

/// Bounds of the two bones.
inline constexpr Aabb kCranium{{-7.5f, -5.4f, -10.2f}, {7.5f, 12.3f, 10.8f}};
inline constexpr Aabb kMandible{{-6.6f, -11.0f, -0.3f}, {6.6f, 0.0f, 10.2f}};

}  // namespace sinew::showcase
