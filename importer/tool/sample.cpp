// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "importer/tool/clip_choice.h"
#include "importer/tool/files/output_check.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/pose_output.h"
#include "importer/tool/pose_sampler.h"
#include "importer/tool/progress_line.h"
#include "importer/tool/sample_times.h"
#include "importer/tool/skinning_choice.h"

namespace sinew::tool {
namespace {

struct SampleOptions {
  std::string file, output;
  std::optional<std::string> clip, times;
  std::optional<double> fps;
  std::string skinning = "all", vertices = "64";
};

constexpr double kMostFrames = 1e6;  // of one clip, so that a typing error in --fps does not fill the disk

/// One clip and the times to sample.
struct Task {
  std::uint32_t clip = kNone;
  std::vector<double> times_s;
};

tl::expected<std::size_t, std::string> vertex_limit(const std::string& text) {
  if (text == "all") return kAllVertices;
  std::size_t limit = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), limit);
  if (error == std::errc{} && stop == text.data() + text.size()) return limit;
  return tl::unexpected(fmt::format("--vertices {}: neither a number nor 'all'", text));
}

tl::expected<std::vector<Task>, std::string> tasks_for(const Scene& scene, const SampleOptions& options) {
  const auto clips = choose_clips(scene, options.clip);
  if (!clips) return tl::unexpected(clips.error());
  std::optional<std::vector<double>> named;
  if (options.times) {
    const auto parsed = parse_times(*options.times);
    if (!parsed) return tl::unexpected(parsed.error());
    named = *parsed;
  }
  std::vector<Task> tasks;
  for (const std::uint32_t clip : *clips) {
    Task task{clip, {0.0}};  // the rest pose is written once, unless the user names it
    const double duration_s = clip == kNone ? 0.0 : scene.animations[clip].duration_s;
    if (named && (clip != kNone || options.clip))
      task.times_s = *named;
    else if (options.fps && duration_s * *options.fps > kMostFrames)
      return tl::unexpected(fmt::format("--fps {}: more than {} frames of clip {}", *options.fps, kMostFrames, clip));
    else if (options.fps)
      task.times_s = frame_times(duration_s, *options.fps);
    else if (clip != kNone)
      task.times_s = telling_times(scene.animations[clip]);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

/// Samples and writes all tasks; prints what went wrong.
ExitCode write_poses(const Scene& scene, const std::vector<Task>& tasks, const SampleOptions& options,
                     const PoseContent& content) {
  const double size_m = model_size_m(scene);
  PoseSampler sampler(scene, content);
  errno = 0;
  PoseOutput out(options.output);
  if (!out.opened())
    return fail_with(ExitCode::wrong_usage, fmt::format("{}: {}", options.output, std::strerror(errno)));
  ProgressLine progress;
  out.begin(options.file, size_m);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto& [clip, times_s] = tasks[i];
    out.begin_clip(clip, clip == kNone ? std::string_view{} : std::string_view(scene.animations[clip].name));
    for (std::size_t k = 0; k < times_s.size(); ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(times_s.size());
      progress.show("sampling", (static_cast<double>(i) + part) / static_cast<double>(tasks.size()));
      if (const ErrorCode code = sampler.run(clip, times_s[k]); code != ErrorCode::ok)
        return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", options.file, describe(code)));
      out.begin_sample(sampler.pose());
      for (std::size_t p = 0; p < sampler.primitive_count(); ++p) out.add(sampler.primitive(p));
      out.end_sample();
    }
    out.end_clip();
  }
  progress.wipe();
  if (out.end()) return ExitCode::done;
  return fail_with(ExitCode::machine_lacks,
                   fmt::format("{}: cannot be written to the end", options.output.empty() ? "stdout" : options.output));
}

ExitCode sample_file(const SampleOptions& options) {
  const auto limit = vertex_limit(options.vertices);
  if (!limit) return fail_with(ExitCode::wrong_usage, limit.error());
  if (options.times)
    if (const auto times = parse_times(*options.times); !times) return fail_with(ExitCode::wrong_usage, times.error());

  ImportOptions import;
  import.decode_images = false;
  const auto asks_for = [&](const char* kind) { return options.skinning == kind || options.skinning == "all"; };
  const PoseContent content{asks_for("linear"), asks_for("dual-quaternion"), asks_for("center-of-rotation"), *limit};
  import.make_centers_of_rotation = content.center_of_rotation;
  import.animate_default_weights = false;  // a pose file holds only what channels of nodes animate
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  if (!options.output.empty())
    if (const auto why = objection_to_output(options.output, file->facts.files))
      return fail_with(ExitCode::wrong_usage, *why);
  const auto tasks = tasks_for(file->scene, options);
  if (!tasks) return fail_with(ExitCode::wrong_usage, tasks.error());
  return write_poses(file->scene, *tasks, options, content);
}

}  // namespace

void add_sample(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<SampleOptions>();
  CLI::App* command = program.add_subcommand(
      "sample",
      "Write poses as JSON: world matrices of nodes, morph weights, deformed vertices.\n"
      "Without --clip: the rest pose and all clips. Without --times or --fps: the start, the first and last\n"
      "key, and some keys and middles between them.");
  command->add_option("FILE", options->file, "A .gltf or .glb file")->required();
  command->add_option("--clip", options->clip, "One clip only; none = the rest pose")->type_name("INDEX|NAME|none");
  auto* times = command->add_option("--times", options->times, "Seconds in the clip, for example 0,0.5,1.25")
                    ->type_name("T,T,...");
  command->add_option("--fps", options->fps, "Frames per second, from 0 to the clip's end")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->excludes(times);
  command
      ->add_option("--skinning", options->skinning,
                   "linear: positions, normals, tangents; dual-quaternion: dqs, dqsNormals;\n"
                   "center-of-rotation: cors, corNormals; all (default)")
      ->type_name("METHOD")
      ->check(CLI::IsMember(skinning_names({"all"})));
  command
      ->add_option("--vertices", options->vertices, "At most N vertices of each primitive, spread evenly (default: 64)")
      ->type_name("N|all");
  command->add_option("-o,--output", options->output, "Write here (compressed if it ends in .gz), not to stdout")
      ->type_name("OUT.json");
  command->callback([options, &outcome] { outcome = sample_file(*options); });
}

}  // namespace sinew::tool
