// SPDX-License-Identifier: MIT
#include "importer/platform/files.h"
#include "importer/tool/commands.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "importer/tool/batch/run_batch.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/files/cache_folder.h"
#include "importer/tool/files/output.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "importer/tool/poses/write_poses.h"
#include "importer/tool/sample_times.h"
#include "importer/tool/skinning_choice.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

struct SampleOptions {
  BatchOptions files;
  std::string file, output;
  std::optional<std::string> clip, times;
  std::optional<double> fps;
  std::vector<std::string> skinning;  // empty = linear and dual-quaternion
  std::optional<std::string> vertices;
  std::string cache;
  std::optional<std::string> format_name;
  PoseFormat format = PoseFormat::json;
};

const std::map<std::string, PoseFormat> kFormatNames = {
    {"json", PoseFormat::json}, {"csv", PoseFormat::csv}, {"npy", PoseFormat::npy}, {"npz", PoseFormat::npz}};

constexpr double kMostFrames = 1e6;  // limit for one clip, so that a typing error in --fps does not fill the disk

tl::expected<std::size_t, std::string> vertex_limit(const std::string& text) {
  if (text == "all") return kAllVertices;
  std::size_t limit = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), limit);
  if (error == std::errc{} && stop == text.data() + text.size()) return limit;
  return tl::unexpected(fmt::format("--vertices {}: neither a number nor 'all'", text));
}

tl::expected<std::vector<SampledClip>, std::string> tasks_for(const Scene& scene, const SampleOptions& options) {
  const auto clips = choose_clips(scene, options.clip);
  if (!clips) return tl::unexpected(clips.error());
  std::optional<std::vector<double>> named;
  if (options.times) {
    const auto parsed = parse_times(*options.times);
    if (!parsed) return tl::unexpected(parsed.error());
    named = *parsed;
  }
  std::vector<SampledClip> tasks;
  for (const std::uint32_t clip : *clips) {
    SampledClip task{clip, {0.0}};  // the rest pose is written once, unless the user names it
    const double duration_s = clip == kNone ? 0.0 : scene.animations[clip].duration_s;
    if (named && (clip != kNone || options.clip))
      task.times_s = *named;
    else if (options.fps && duration_s * *options.fps > kMostFrames)
      return tl::unexpected(fmt::format("--fps {}: more than {} frames of clip {}", *options.fps, kMostFrames, clip));
    else if (options.fps)
      task.times_s = frame_times(duration_s, *options.fps);
    else if (clip != kNone)
      task.times_s = representative_times(scene.animations[clip]);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

/// The parts of a pose that are sampled. A format without vertices needs no skinning.
PoseContent content_of(const SampleOptions& options, std::size_t vertices) {
  if (!holds_vertices(options.format)) return {true, false, false, 0, false};
  const auto asks_for = [&](const char* method) { return names_skinning(options.skinning, method); };
  return {asks_for("linear"), asks_for("dual-quaternion"), asks_for("center-of-rotation"), vertices,
          options.format == PoseFormat::json};
}

ExitCode sample_file(SampleOptions options) {
  const auto limit = vertex_limit(options.vertices.value_or("64"));
  if (!limit) return fail_with(ExitCode::wrong_usage, limit.error());
  if (options.times)
    if (const auto times = parse_times(*options.times); !times) return fail_with(ExitCode::wrong_usage, times.error());
  options.format = options.format_name ? kFormatNames.at(*options.format_name) : format_of_name(options.output);
  if (!holds_vertices(options.format) && (options.vertices || !options.skinning.empty()))
    return fail_with(ExitCode::wrong_usage,
                     "--vertices, --skinning: csv and npy hold nodes only; json and npz hold both");
  if (options.skinning.empty()) options.skinning = {"linear", "dual-quaternion"};

  ImportOptions import;
  import.decode_images = false;
  const PoseContent content = content_of(options, *limit);
  if (content.center_of_rotation) request_centers(import, options.cache);
  import.animate_default_weights = false;  // pose files leave out channels of mesh.weights
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  if (!options.output.empty())
    if (const auto error = find_output_error(platform::path_of(options.output), file->facts.files))
      return fail_with(ExitCode::wrong_usage, *error);
  const auto tasks = tasks_for(file->scene, options);
  if (!tasks) return fail_with(ExitCode::wrong_usage, tasks.error());
  return write_poses(file->scene, *tasks, content, options.format, options.file, options.output);
}

ExitCode sample_input(SampleOptions options, const Input& input, bool many) {
  options.file = input.path;
  if (many) options.output = input.output;
  if (is_standard_output(platform::path_of(options.output))) options.output.clear();
  const ExitCode code = sample_file(options);
  if (many && code == ExitCode::done) print_result("{}: written\n", visible_text(options.output));
  return code;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const auto& [name, format] : kFormatNames) names.push_back(name);
  return names;
}

}  // namespace

Command sample_command() {
  auto options = std::make_shared<SampleOptions>();
  Command command(
      "sample",
      "Write poses: world matrices of nodes, morph weights, deformed vertices\n"
      "Without --clip: the rest pose and all clips. Without --times or --fps: the start, the first and last "
      "key, and some keys and middles between them.");
  add_batch_options(command, options->files, ".gltf or .glb files, and folders of them; - is the standard input")
      .required();
  command.option("--clip", "INDEX|NAME|none", &options->clip,
                 "One clip only; NAME#2 = the second of that name, none = the rest pose");
  command.option("--times", "T,T,...", &options->times, "Seconds in the clip, for example 0,0.5,1.25");
  command.option("--fps", "N", &options->fps, "Frames per second, from 0 to the clip's end")
      .within(1e-3, 1e6)
      .excludes("--times");
  command
      .option("--skinning", "METHOD[,METHOD...]", &options->skinning,
              "linear: positions, normals, tangents; dual-quaternion: dqs, dqsNormals; center-of-rotation: cors, "
              "corNormals; all (default: linear,dual-quaternion, since centers of rotation take long to compute the "
              "first time)")
      .list()
      .one_of(skinning_names({"all"}));
  command.option("--vertices", "N|all", &options->vertices,
                 "At most N vertices of each primitive, spread evenly (default: 64)");
  command
      .option("--format", "FORMAT", &options->format_name,
              "json: what `sinew verify` reads; csv: a row for each node and time; npy: the world matrices as one "
              "NumPy array [time, node, 4, 4]; npz: everything as NumPy arrays by name (default: what OUT's name ends "
              "in, else json)")
      .one_of(format_names());
  command.option("-o,--output", "OUT", &options->output,
                 "Write here (compressed if it ends in .gz), not to stdout; of several files the folder for their "
                 "poses");
  add_cache_option(command, options->cache);
  command.run = [options] {
    const auto run = [&](const Input& file, bool many) { return sample_input(*options, file, many); };
    return run_batch(options->files,
                     {run, {}, BatchOutput{options->output, "." + options->format_name.value_or("json")}});
  };
  return command;
}

}  // namespace sinew::tool
