// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/tool/exit_code.h"
#include "importer/tool/poses/pose_sampler.h"
#include "importer/tool/poses/pose_writer.h"

namespace sinew::tool {

/// A clip and the times at which it is sampled.
struct SampledClip {
  std::uint32_t clip = kNone;  ///< kNone = the rest pose
  std::vector<double> times_s;
};

/// Samples clips and writes the poses. Prints what went wrong, and progress on a terminal.
/// in    input    the name of the model that the poses are of
///       output   empty = the standard output
ExitCode write_poses(const Scene& scene, const std::vector<SampledClip>& clips, const PoseContent& content,
                     PoseFormat format, const std::string& input, const std::string& output);

}  // namespace sinew::tool
