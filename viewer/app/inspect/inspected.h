// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/index.h"

namespace sinew::viewer {

/// A vertex of a mesh instance.
struct VertexPlace {
  std::uint32_t instance = kNone, primitive = 0, vertex = 0;  ///< instance = kNone: no vertex

  friend bool operator==(const VertexPlace&, const VertexPlace&) = default;
};

/// Colours that replace the materials of the scene.
enum class Paint : std::uint8_t {
  materials,  ///< those of the file
  weights,    ///< how much the inspected joint moves each vertex: blue 0, green half, red 1
  uv          ///< a checkered texture, 16 squares along u and v
};

/// The joint and the vertex that the user looks at, and what is drawn to show them.
struct Inspected {
  std::uint32_t joint = kNone;
  VertexPlace vertex;
  Paint paint = Paint::materials;
  bool wireframe = false;
  bool boxes = false;   ///< bounds of each mesh
  bool trail = false;   ///< the way of the joint through the clip
  bool ghosts = false;  ///< skeletons shortly before and after: onion skin

  bool draws_lines() const noexcept {
    return wireframe || boxes || joint != kNone || vertex.instance != kNone || ghosts;
  }

  friend bool operator==(const Inspected&, const Inspected&) = default;
};

}  // namespace sinew::viewer
