// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "importer/tool/files/streamed_file.h"
#include "importer/tool/poses/pose.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Writes poses in some format while they are made: begin(), then for each clip begin_clip(), its samples, end_clip(),
/// and at last end().
class PoseWriter {
 public:
  virtual ~PoseWriter() = default;
  virtual void begin(std::string_view model, double extent) = 0;
  virtual void begin_clip(std::uint32_t clip, std::string_view name) = 0;  ///< kNone = rest pose
  virtual void begin_sample(const Pose& pose) = 0;                         ///< with the primitives that the pose holds
  virtual void add(const PrimitivePose& primitive) = 0;
  virtual void end_sample() = 0;
  virtual void end_clip() = 0;
  virtual void end() = 0;
};

/// The formats of `sinew sample`.
enum class PoseFormat : std::uint8_t { json, csv, npy, npz };

/// The format that the name of a file tells: poses.csv, poses.npy, poses.npz; json for other names.
PoseFormat format_of_name(std::string_view file) noexcept;

/// True if a format holds deformed vertices, and not only nodes.
bool holds_vertices(PoseFormat format) noexcept;

/// Makes the writer of a format.
/// in   scene, out  must outlive the writer
///      samples     how many there will be, of all clips together
std::unique_ptr<PoseWriter> make_pose_writer(PoseFormat format, const Scene& scene, std::size_t samples,
                                             StreamedFile& out);

}  // namespace sinew::tool
