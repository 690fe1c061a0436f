// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/model/scene_look.h"
#include "runtime/plan/frame_result.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// Offsets of the deformed attributes of a primitive in the slot's buffer; kAbsent = the primitive's own are used.
struct DeformedBuffers {
  VkDeviceSize positions = kAbsent, normals = kAbsent, tangents = kAbsent, colors = kAbsent;
  std::uint64_t frame = 0;  ///< the frame that these vertices belong to
  glm::vec3 centre{0.0f};   ///< of the box of the vertices, mesh space: blended draws are sorted by it
};

/// A mesh instance as it is drawn.
struct PlacedInstance {
  Affine world_from_mesh;
  bool mirrored = false, visible = true;
  bool hidden = false;                ///< why it is not visible: true = its node is hidden, false = it is out of view
  Aabb bounds;                        ///< of all vertices, world space; empty = unknown
  std::uint32_t first_primitive = 0;  ///< into FrameVertices::primitives
};

/// The contents of one slot.
struct FrameVertices {
  Buffer buffer;
  std::vector<PlacedInstance> instances;
  std::vector<DeformedBuffers> primitives;
  std::vector<Affine> world_from_light;  ///< [lights of the scene]
  std::vector<bool> light_shines;        ///< [lights of the scene] it is on a node that is not hidden
  SceneLook look;                        ///< materials, lights and cameras of this frame
  std::uint64_t frame = 0, source = 0;
  bool filled = false;
};

/// What an update copied.
struct UploadCounts {
  std::uint32_t written = 0, unchanged = 0;  ///< primitives with deformed vertices: copied, and already in the slot
  std::uint64_t bytes = 0;
  double time_us = 0.0;
};

/// The parts of a scene that change from frame to frame, on the GPU. Each frame in flight has its own slot, so that the
/// CPU fills one while the GPU reads the other.
class FrameUpload {
 public:
  FrameUpload(Device& device, const Scene& scene, std::uint32_t slot_count);
  ~FrameUpload();
  FrameUpload(const FrameUpload&) = delete;
  FrameUpload& operator=(const FrameUpload&) = delete;

  /// Copies the deformed vertices of the frame into the slot. Skips attributes that are not deformed, so a rigid scene
  /// copies nothing, and primitives that have not changed since the slot was filled (DeformedPrimitive::since_frame).
  /// The result is not read after the call.
  /// in   slot    the GPU must be done with its last use
  ///      source  identifies the frame buffer: frame numbers of different sources are not compared
  void update(std::uint32_t slot, const FrameResult& result, std::uint64_t source = 0);

  /// Bytes copied by all updates so far.
  std::uint64_t uploaded_bytes() const noexcept;
  const UploadCounts& last_update() const noexcept;

  /// Materials, lights and cameras as animated in the slot's frame.
  const SceneLook& look(std::uint32_t slot) const noexcept;

  const FrameVertices& vertices(std::uint32_t slot) const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
