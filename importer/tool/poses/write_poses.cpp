// SPDX-License-Identifier: MIT
#include "importer/tool/poses/write_poses.h"

#include <cerrno>
#include <cstring>
#include <string_view>

#include <fmt/core.h>

#include "importer/tool/files/streamed_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/progress_line.h"

namespace sinew::tool {
namespace {

std::size_t sample_count(const std::vector<SampledClip>& tasks) {
  std::size_t count = 0;
  for (const SampledClip& task : tasks) count += task.times_s.size();
  return count;
}

/// Samples all tasks.
/// err  as run_plan
ErrorCode sample_all(const Scene& scene, const std::vector<SampledClip>& tasks, PoseSampler& sampler,
                     PoseWriter& writer) {
  ProgressLine progress;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto& [clip, times_s] = tasks[i];
    writer.begin_clip(clip, clip == kNone ? std::string_view{} : std::string_view(scene.animations[clip].name));
    for (std::size_t k = 0; k < times_s.size(); ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(times_s.size());
      progress.show("sampling", (static_cast<double>(i) + part) / static_cast<double>(tasks.size()));
      if (const ErrorCode code = sampler.run(clip, times_s[k]); code != ErrorCode::ok) return code;
      writer.begin_sample(sampler.pose());
      for (std::size_t p = 0; p < sampler.primitive_count(); ++p) writer.add(sampler.primitive(p));
      writer.end_sample();
    }
    writer.end_clip();
  }
  return ErrorCode::ok;
}

}  // namespace

ExitCode write_poses(const Scene& scene, const std::vector<SampledClip>& clips, const PoseContent& content,
                     PoseFormat format, const std::string& input, const std::string& output) {
  PoseSampler sampler(scene, content);
  const std::string name = output.empty() ? "stdout" : output;
  errno = 0;
  StreamedFile out(output);
  if (!out.opened()) return fail_with(ExitCode::wrong_usage, fmt::format("{}: {}", name, std::strerror(errno)));
  const auto writer = make_pose_writer(format, scene, sample_count(clips), out);
  writer->begin(input, model_size_m(scene));
  if (const ErrorCode code = sample_all(scene, clips, sampler, *writer); code != ErrorCode::ok)
    return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", input, describe(code)));
  writer->end();
  if (out.finish()) return ExitCode::done;
  return fail_with(ExitCode::machine_lacks,
                   fmt::format("{}: cannot be written to the end: {}", name, std::strerror(errno)));
}

}  // namespace sinew::tool
