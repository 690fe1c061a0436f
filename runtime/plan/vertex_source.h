// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/model/aabb.h"

namespace sinew {

/// Where the vertices of a source lie.
enum class VertexSpace : std::uint8_t {
  scene,  ///< in the space below FrameInput::root, for sources baked from a whole scene
  mesh    ///< in the mesh's own space; the joint of the instance places them in the world
};

/// The answer of VertexSource::show: which vertices the source shows for a mesh instance.
struct ShownVertices {
  bool is_there = false;             ///< the source has vertices to write; false: the instance keeps its pose
  bool is_late = false;              ///< the requested frame is not loaded yet, so these vertices are older
  std::uint64_t moment = 0;          ///< equal numbers mean equal vertices
  Aabb bounds;                       ///< holds all vertices of the instance
  std::uint32_t frames_decoded = 0;  ///< number of frames that this call decoded
};

/// A source of vertices that replaces the pose of mesh instances: GeometryPlayer (runtime/geometry_cache), or an
/// engine's own simulation. It is a set of functions with a context, so that frames need no library of any source. Each
/// character needs its own source. run_plan calls it on the thread that runs the frame, and runs one frame of a
/// character at a time. The functions must not allocate.
struct SINEW_API VertexSource {
  /// True if the source has vertices for all primitives of the instance.
  bool (*has)(const void* context, std::uint32_t instance) noexcept = nullptr;

  /// Gets ready to write the instance at a time on the source's clock. Called once in a frame for each instance that
  /// plays and is seen. All instances of a source have the same time in a frame.
  ShownVertices (*show)(void* context, std::uint32_t instance, double time_s) noexcept = nullptr;

  /// Writes the vertices of the last `show`.
  /// out  positions[V]  metres, in the source's space;   normals[V]  unit; empty = not wanted
  ///      returns true if normals were written; else frames derive them from the triangles
  bool (*write)(void* context, std::uint32_t instance, std::uint32_t primitive, std::span<glm::vec3> positions,
                std::span<glm::vec3> normals) noexcept = nullptr;

  void* context = nullptr;
  std::uint64_t content = 0;  ///< identifies the content, for example by a checksum of the file: sources with equal
                              ///< numbers show the same vertices of an instance at the same time
  VertexSpace space = VertexSpace::scene;

  bool is_there() const noexcept { return show != nullptr; }
};

}  // namespace sinew
