// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec4.hpp>

#include "viewer/passes/frame_uniforms.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// The part of the ground that a frame may darken.
struct GroundReach {
  glm::vec4 rectangle{0.0f};  ///< min x, min z, max x, max z, relative to the center; the whole ground with a grid
  glm::vec4 contact{0.0f};    ///< likewise, where something near may hide ambient light; empty = nowhere
  bool darkened = false;      ///< a shadow may fall on it, or something is near enough to hide ambient light
};

/// in   standing   bounds of everything that casts shadows or hides light, world space; empty = unknown
///      contact_m  reach of ambient occlusion; 0 = none
GroundReach ground_reach(const Ground& ground, const Aabb& standing, const ShadowLights& shadows, double contact_m);

}  // namespace sinew::viewer
