// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/model/aabb.h"

namespace sinew {

/// Where the vertices of a source lie.
enum class VertexSpace : std::uint8_t {
  scene,  ///< below FrameInput::root, as a whole scene is baked
  mesh    ///< in the mesh's own space: its joint places them
};

/// Answer of a source: the vertices that it shows of a mesh instance.
struct ShownVertices {
  bool is_there = false;             ///< there are vertices to write; false: the instance keeps its pose
  bool is_late = false;              ///< the frame asked for is not loaded yet: these vertices are older
  std::uint64_t moment = 0;          ///< equal numbers mean equal vertices
  Aabb bounds;                       ///< holds all vertices of the instance
  std::uint32_t frames_decoded = 0;  ///< by this call
};

/// Where a frame takes the vertices of mesh instances from, in place of their pose: GeometryPlayer
/// (runtime/geometry_cache), or an engine's own simulation. Functions and a context, so that the frame needs no library
/// of any source. A character has sources of its own: run_plan calls them on the thread that it runs on, and one frame
/// of a character runs at a time. Functions allocate nothing.
struct SINEW_API VertexSource {
  /// True if the source has vertices for all primitives of the instance.
  bool (*has)(const void* context, std::uint32_t instance) noexcept = nullptr;

  /// Gets ready to write the instance at a time on the source's clock. Called once in a frame for each instance that
  /// plays and is seen. All instances of a source have the same time in a frame.
  ShownVertices (*show)(void* context, std::uint32_t instance, double time_s) noexcept = nullptr;

  /// Writes the vertices of the last `show`.
  /// out  positions[V]  metres, in the source's space;   normals[V]  unit; empty = not wanted
  ///      answers true if normals were written; else frames derive them from the triangles
  bool (*write)(void* context, std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
                std::span<glm::vec3> normals) noexcept = nullptr;

  void* context = nullptr;
  std::uint64_t content = 0;  ///< sources of one number show the same vertices of an instance at a moment, such as a
                              ///< checksum of the file
  VertexSpace space = VertexSpace::scene;

  bool is_there() const noexcept { return show != nullptr; }
};

}  // namespace sinew
