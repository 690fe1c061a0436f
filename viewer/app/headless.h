// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "viewer/passes/frame_renderer.h"
#include "viewer/upload/access_blend.h"

namespace sinew::viewer {

/// 8-bit sRGB pixels with straight (not premultiplied) alpha, the top row first.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws frames of one scene into pictures, without a window.
class Headless {
 public:
  /// in   access  ambient access of the vertices for OcclusionMethod::rays, null = none; not read after the call
  Headless(Device& device, const Scene& scene, std::uint32_t width, std::uint32_t height,
           const OcclusionShape& occlusion = {}, const VertexAccess* access = nullptr,
           const TextureFilter& filter = {});
  ~Headless();

  /// Draws one frame. The same input gives the same bytes on the same driver.
  /// in   variant  material variant of the scene, kNone = the materials of the primitives
  Picture render(const FrameResult& frame, const View& view, const RenderOptions& options,
                 std::span<const LineVertex> lines = {}, std::uint32_t variant = kNone, const AccessBlend& access = {});

  // Of the last picture:
  std::span<const PassTime> pass_times() const;
  const FrameReport& report() const;
  const UploadCounts& upload_counts() const;

  /// Bytes of the texels of all textures, with their levels.
  std::uint64_t texel_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
