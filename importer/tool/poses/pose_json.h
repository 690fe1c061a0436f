// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include "importer/tool/poses/pose_writer.h"

namespace sinew::tool {

/// The format that `sinew verify` reads. Besides the format's own keys each sample has "bits": hashes of all joints and
/// weights ("pose") and of all vertices for each skinning method. Memory does not grow with the number of poses.
class PoseJson final : public PoseWriter {
 public:
  explicit PoseJson(StreamedFile& out) : out_(out) {}

  void begin(std::string_view model, double extent) override;
  void begin_clip(std::uint32_t clip, std::string_view name) override;
  void begin_sample(const Pose& pose) override;
  void add(const PrimitivePose& primitive) override;
  void end_sample() override;
  void end_clip() override;
  void end() override;

 private:
  void add_nodes(const Pose& pose);
  void flush();

  StreamedFile& out_;
  fmt::memory_buffer text_;
  bool first_clip_ = true, first_sample_ = true, first_primitive_ = true;
};

}  // namespace sinew::tool
