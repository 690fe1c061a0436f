// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "runtime/model/scene_look.h"
#include "runtime/plan/frame_result.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

struct FrameVertices;  // frame_vertices.h: for the passes

/// What one update copied.
struct UploadCounts {
  std::uint32_t written = 0, unchanged = 0;  ///< primitives with deformed vertices: copied, and left as they were
  std::uint64_t bytes = 0;
  double time_us = 0.0;
};

/// The parts of a scene that change per frame. One copy per slot, so that the CPU can fill the next frame while the GPU
/// still draws the last.
class FrameUpload {
 public:
  FrameUpload(Device& device, const Scene& scene, std::uint32_t slot_count);
  ~FrameUpload();
  FrameUpload(const FrameUpload&) = delete;
  FrameUpload& operator=(const FrameUpload&) = delete;

  /// Copies what the frame deformed into the slot; does nothing when the slot holds that frame already. Only deformed
  /// attributes are copied, so a rigid scene uploads no vertex at all, and only of primitives that the slot does not
  /// have already (DeformedPrimitive::since_frame, P19). The result is not read after the call. in   slot    the GPU
  /// must be done with its last use
  ///      source  tells characters or plans apart whose frames are shown in turn: frame numbers of different sources
  ///      differ
  void update(std::uint32_t slot, const FrameResult& result, std::uint64_t source = 0);

  /// Bytes written by all updates so far.
  std::uint64_t uploaded_bytes() const noexcept;
  const UploadCounts& last_update() const noexcept;

  /// Materials, lights and cameras of the slot's frame.
  const SceneLook& look(std::uint32_t slot) const noexcept;

  const FrameVertices& vertices(std::uint32_t slot) const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
