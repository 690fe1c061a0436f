// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Straight (not premultiplied) sRGB with alpha, rows from the top.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Draws frames of one scene into pictures, without any window.
class Headless {
 public:
  Headless(Device& device, const Scene& scene, std::uint32_t width, std::uint32_t height,
           const OcclusionShape& occlusion = {});
  ~Headless();

  /// One frame; the same input gives the same bytes on the same driver.
  /// in   variant  of the scene's materials, kNone = as the primitives say
  Picture render(const FrameResult& frame, const View& view, const RenderOptions& options,
                 std::span<const LineVertex> lines = {}, std::uint32_t variant = kNone);

  /// Of the last picture.
  std::span<const PassTime> pass_times() const;
  const FrameReport& report() const;
  const UploadCounts& upload_counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes pictures as PNG on a thread of its own, because encoding takes longer than drawing. At most a few pictures
/// wait; then `write` blocks.
class PngWriter {
 public:
  PngWriter();
  ~PngWriter();                                             ///< waits for all pictures
  void write(std::filesystem::path file, Picture picture);  ///< alpha is kept as it is
  std::vector<std::string> finish();  ///< waits; names the files that could not be written, and why

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
