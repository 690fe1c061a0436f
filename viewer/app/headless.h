// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "viewer/passes/frame_renderer.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {

/// 8-bit sRGB pixels with straight (not premultiplied) alpha, the top row first.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws frames of one scene into pictures in memory, without a window.
class Headless {
 public:
  /// in   visibility  per-vertex ambient visibility for OcclusionMethod::rays, null = none; copied, not kept
  Headless(Device& device, const Scene& scene, std::uint32_t width, std::uint32_t height,
           const OcclusionShape& occlusion = {}, const VertexVisibility* visibility = nullptr,
           const TextureFilter& filter = {});
  ~Headless();

  /// Draws one frame. Equal inputs give equal bytes on the same driver.
  /// in   variant  index of a material variant; kNone = the primitives' default materials
  ///      source   identifies the frame buffer of `frame`: for an equal number, unchanged vertices are not uploaded
  ///               again; 0 = unknown, all vertices are uploaded
  Picture render(const FrameResult& frame, const View& view, const RenderOptions& options,
                 std::span<const LineVertex> lines = {}, std::uint32_t variant = kNone,
                 const VisibilityBlend& visibility = {}, std::uint64_t source = 0);

  // Of the last picture:
  std::span<const PassTime> pass_times() const;
  const FrameReport& report() const;
  const UploadCounts& upload_counts() const;

  /// Size of all textures in bytes, mip levels included.
  std::uint64_t texel_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
