// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include "importer/tool/poses/pose_writer.h"

namespace sinew::tool {

/// One row for each node of each sample: clip, clip_name, time_s, node, node_name, and the world matrix by rows: m00 to
/// m23, so that x' = m00 x + m01 y + m02 z + m03. The last row of the matrix is 0 0 0 1. The rest pose has no clip.
/// Nine digits reproduce every float. Morph weights and vertices are not in it.
class PoseCsv final : public PoseWriter {
 public:
  PoseCsv(const Scene& scene, StreamedFile& out) : scene_(scene), out_(out) {}

  void begin(std::string_view model, double extent) override;
  void begin_clip(std::uint32_t clip, std::string_view name) override;
  void begin_sample(const Pose& pose) override;
  void add(const PrimitivePose&) override {}
  void end_sample() override;
  void end_clip() override {}
  void end() override {}

 private:
  const Scene& scene_;
  StreamedFile& out_;
  std::string clip_;  // the first two fields of each row
  fmt::memory_buffer text_;
};

/// A field with quotes around it, control characters escaped.
std::string csv_field(std::string_view text);

}  // namespace sinew::tool
