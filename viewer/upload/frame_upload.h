// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/model/scene_look.h"
#include "runtime/plan/frame_result.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// Offsets of the deformed attributes of a primitive in the slot's buffer; kAbsent = not deformed, the static attribute
/// is used.
struct DeformedBuffers {
  VkDeviceSize positions = kAbsent, normals = kAbsent, tangents = kAbsent, colors = kAbsent;
  std::uint64_t frame = 0;  ///< frame number of these vertices
  std::uint64_t since = 0;  ///< DeformedPrimitive::since_frame: the frame in which they changed last; 0 = unknown
  glm::vec3 centre{0.0f};   ///< center of the vertices' bounds, mesh space; blended draws are sorted by it
};

/// State of a mesh instance in one frame.
struct PlacedInstance {
  Affine world_from_mesh;
  bool mirrored = false, visible = true;
  bool hidden = false;                ///< if not visible: true = its node is hidden, false = out of view
  Aabb bounds;                        ///< of all vertices, world space; empty = unknown
  std::uint32_t first_primitive = 0;  ///< into FrameVertices::primitives
};

/// GPU data of one frame in flight.
struct FrameVertices {
  Buffer buffer;
  std::vector<PlacedInstance> instances;
  std::vector<DeformedBuffers> primitives;
  std::vector<Affine> world_from_light;  ///< [lights of the scene]
  std::vector<bool> light_shines;        ///< [lights of the scene] false = its node is hidden
  SceneLook look;                        ///< materials, lights and cameras of this frame
  std::uint64_t frame = 0, source = 0;
  bool filled = false;
};

/// Statistics of an update.
struct UploadCounts {
  std::uint32_t written = 0, unchanged = 0;  ///< number of deformed primitives: copied, and already in the slot
  std::uint64_t bytes = 0;
  double time_us = 0.0;
};

/// GPU copies of the per-frame parts of a scene. Each frame in flight has its own slot, so that the CPU fills one while
/// the GPU reads another.
class FrameUpload {
 public:
  FrameUpload(Device& device, const Scene& scene, std::uint32_t slot_count);
  ~FrameUpload();
  FrameUpload(const FrameUpload&) = delete;
  FrameUpload& operator=(const FrameUpload&) = delete;

  /// Copies the frame's deformed vertices into the slot. Skips attributes that are not deformed, and primitives
  /// unchanged since the slot was filled (DeformedPrimitive::since_frame). `result` is not used after the call.
  /// in   slot    the GPU must have finished its last use
  ///      source  identifies the frame buffer: frame numbers of different sources are not compared
  void update(std::uint32_t slot, const FrameResult& result, std::uint64_t source = 0);

  /// Bytes copied by all updates so far.
  std::uint64_t uploaded_bytes() const noexcept;
  const UploadCounts& last_update() const noexcept;

  /// Materials, lights and cameras with the animated values of the slot's frame.
  const SceneLook& look(std::uint32_t slot) const noexcept;

  const FrameVertices& vertices(std::uint32_t slot) const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
