// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "importer/tool/pose.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Writes a pose file while poses are made, so that memory does not grow with their number. Besides the format's own
/// keys each sample has "bits": hashes of all joints and weights ("pose") and of all vertices for each skinning method.
/// A file name that ends in .gz is compressed; an empty name means stdout. The file is written beside its place and
/// takes it in end(), so that it appears complete or not at all; behind a symbolic link the file that it names is
/// replaced.
/// err   end() returns false when something could not be written; errno has the reason of the first failure
class PoseOutput {
 public:
  explicit PoseOutput(const std::string& file_or_empty);
  ~PoseOutput();
  PoseOutput(const PoseOutput&) = delete;
  PoseOutput& operator=(const PoseOutput&) = delete;

  bool opened() const noexcept { return file_ != nullptr; }
  void begin(std::string_view model, double extent);
  void begin_clip(std::uint32_t clip, std::string_view name);  ///< kNone = rest pose
  void begin_sample(const Pose& pose);                         ///< with the primitives that the pose holds
  void add(const PrimitivePose& primitive);
  void end_sample();
  void end_clip();
  bool end();  ///< false: something could not be written

 private:
  void add_nodes(const Pose& pose);
  void flush();

  std::filesystem::path target_, unfinished_;  // empty for stdout
  void* file_ = nullptr;                       // gzFile
  fmt::memory_buffer text_;
  bool first_clip_ = true, first_sample_ = true, first_primitive_ = true, failed_ = false;
};

}  // namespace sinew::tool
