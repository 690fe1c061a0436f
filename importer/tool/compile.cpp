// SPDX-License-Identifier: MIT
#include "importer/graph/graph_files.h"
#include "importer/platform/files.h"
#include "importer/tool/commands.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/annotations_option.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/clip_choice.h"
#include "importer/tool/files/output.h"
#include "importer/tool/fit_clips.h"
#include "importer/tool/left_out_joints.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/model_size.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/graph/graph_bytes.h"
#include "runtime/lod/compile_skeleton_lod.h"

namespace sinew::tool {
namespace {

struct CompileOptions {
  BatchOptions files;
  std::string out, budget = "0.1mm";
  std::vector<std::string> clips, parts{"skeleton", "model", "clips"};
  std::vector<std::string> joint_tolerances;
  std::optional<std::string> annotations;
  std::vector<std::string> graphs;
  bool truth = false;
  double page_s = 0.0;
  int zstd_level = 0;
};

/// The clips that --clip names, each once; all clips if the option is not given.
/// err   a sentence for the user that lists the clips of the file
tl::expected<ClipChoice, std::string> clips_of(const Scene& scene, const std::vector<std::string>& names) {
  ClipChoice clips(names.empty() ? scene.animations.size() : 0);
  std::iota(clips.begin(), clips.end(), 0u);
  for (const std::string& name : names) {
    const auto chosen = choose_clips(scene, name);
    if (!chosen) return tl::unexpected(chosen.error());
    if (chosen->front() == kNone)
      return tl::unexpected(std::string("--clip none: the rest pose has no keys to compile"));
    if (std::find(clips.begin(), clips.end(), chosen->front()) == clips.end()) clips.push_back(chosen->front());
  }
  return clips;
}

/// Parses the values of --joint-tolerance.
/// err   what is wrong, as a sentence for the user
tl::expected<std::vector<Length>, std::string> joint_tolerances(const std::vector<std::string>& texts) {
  std::vector<Length> tolerances;
  for (const std::string& text : texts) {
    const auto tolerance = parse_length(text);
    if (!tolerance) return tl::unexpected("--joint-tolerance: " + tolerance.error());
    tolerances.push_back(*tolerance);
  }
  return tolerances;
}

/// A skeleton LOD for each tolerance, of the clips that the scene has.
std::vector<CompiledSkeletonLod> lods_of(const Scene& scene, const std::vector<Length>& tolerances) {
  std::vector<CompiledSkeletonLod> lods;
  for (const Length& tolerance : tolerances) lods.push_back(compile_skeleton_lod(scene, metres_of(tolerance, scene)));
  return lods;
}

/// The graphs of --graph, compiled and checked against the model; each has the name of its file.
/// err   what is wrong, as a sentence for the user
tl::expected<std::vector<StoredGraph>, std::string> graphs_of(const std::vector<std::string>& files,
                                                              const Scene& scene) {
  std::vector<StoredGraph> graphs;
  for (const std::string& file : files) {
    const auto loaded = load_graph(file, scene);
    if (!loaded) return tl::unexpected(loaded.error());
    graphs.push_back({platform::text_of(platform::path_of(file).stem()), write_graph_bytes(loaded->graph.tables())});
    for (std::size_t g = 0; g + 1 < graphs.size(); ++g)
      if (graphs[g].name == graphs.back().name) return tl::unexpected(file + ": another graph has this name");
  }
  return graphs;
}

/// Compiles the chosen clips and removes all others from the scene.
void compile_clips_of(Scene& scene, const ClipChoice& chosen, double budget_m) {
  std::vector<Animation> animations;
  for (const std::uint32_t clip : chosen) animations.push_back(scene.animations[clip]);
  std::vector<Clip> clips;
  for (ClipWithin& fitted : fit_clips(scene, animations, budget_m)) clips.push_back(std::move(fitted.clip));
  scene.clips = std::move(clips);
  scene.animations = std::move(animations);
}

AssetFileOptions blocks_of(const CompileOptions& options) {
  const auto has = [&](const char* part) {
    return std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
  };
  return {.skeleton = has("skeleton"),
          .model = has("model"),
          .clips = has("clips"),
          .truth = options.truth,
          .page_s = options.page_s,
          .zstd_level = options.zstd_level};
}

ExitCode compile_file(const CompileOptions& options, const std::string& in, const std::string& out, bool many) {
  const ResultsToStderr redirected(is_standard_output(platform::path_of(out)));
  const auto budget = parse_length(options.budget);
  if (!budget) return fail_with(ExitCode::wrong_usage, "--budget: " + budget.error());
  const auto tolerances = joint_tolerances(options.joint_tolerances);
  if (!tolerances) return fail_with(ExitCode::wrong_usage, tolerances.error());
  ImportOptions import;
  AssetFileOptions blocks = blocks_of(options);
  import.decode_images = false;
  import.make_tangents = import.keep_encoded_images = blocks.model;
  auto file = load_file(in, import);
  if (!file) return ExitCode::input_at_fault;
  if (const auto error = find_output_error(platform::path_of(out), file->facts.files))
    return fail_with(ExitCode::wrong_usage, *error);
  if (const ExitCode code = annotate_from(options.annotations, file->scene.animations); code != ExitCode::done)
    return code;
  const auto chosen = clips_of(file->scene, options.clips);
  if (!chosen) return fail_with(ExitCode::wrong_usage, chosen.error());
  const auto graphs = graphs_of(options.graphs, file->scene);
  if (!graphs) return fail_with(ExitCode::input_at_fault, graphs.error());
  blocks.graphs = *graphs;
  Scene& scene = file->scene;
  compile_clips_of(scene, blocks.clips ? *chosen : ClipChoice(), metres_of(*budget, scene));
  const std::vector<CompiledSkeletonLod> lods = lods_of(scene, *tolerances);
  blocks.skeleton_lods = lods;
  const ClipBoxes boxes = blocks.model && blocks.clips ? bound_clips(scene) : ClipBoxes();
  blocks.clip_boxes = boxes;
  const std::vector<std::byte> bytes = write_asset_file(scene, blocks);
  if (const ExitCode code = write_output(platform::path_of(out), bytes); code != ExitCode::done) return code;
  if (!many)
    print_result_text(certificate_table(scene.clips, scene.skeleton.names) +
                      lod_lines(lods, scene.skeleton.joint_count()));
  print_result("{}: {}, {}\n", out, counted(scene.clips.size(), "clip"), counted(bytes.size(), "byte"));
  return ExitCode::done;
}

}  // namespace

Command compile_command() {
  auto options = std::make_shared<CompileOptions>();
  Command command(
      "compile",
      "Compile models for engines, with clips within an error budget\n"
      "At no time is a vertex farther than the budget from where the file puts it. Prints what was measured "
      "of each clip; OUT stores that as well, and `sinew info OUT` shows it again. An engine reads OUT with "
      "read_scene (runtime/asset_file/read_assets.h) and without the importer; images stay encoded.");
  add_batch_options(command, options->files, ".gltf or .glb files, and folders of them; - is the standard input")
      .required();
  command.option("-o,--output", "OUT", &options->out, "The file to write; of several files the folder for their .sinew")
      .required();
  command.option("--clip", "INDEX|NAME", &options->clips,
                 "A clip to compile, by number or name; may be given several times (default: all clips)");
  command.option("--budget", "LENGTH", &options->budget,
                 fmt::format("Largest error, {}; 0 keeps every bit (default: {})", kLengthHelp, options->budget));
  command
      .option("--parts", "PART[,...]", &options->parts,
              "What OUT holds (default: skeleton,model,clips). With clips alone it belongs to the skeleton of FILE")
      .list()
      .one_of({"skeleton", "model", "clips"});
  add_annotations_option(command, options->annotations);
  command.option("--graph", "FILE.json", &options->graphs,
                 "A motion graph of these clips to store, compiled; may be given several times");
  command.flag("--truth", options->truth, "Also store the keys of FILE, in full");
  command.option("--joint-tolerance", "LENGTH", &options->joint_tolerances,
                 fmt::format("Also store which joints can be left out while no vertex moves farther than this in the "
                             "clips of OUT, {}; may be given several times, a level each",
                             kLengthHelp));
  command
      .option("--page", "SECONDS", &options->page_s,
              "Store clips that are longer in pages of this length, so that an engine can play them from a bounded "
              "part of OUT (runtime/paging/paged_clip.h); 4 is a good start")
      .within(0.1, 3600.0);
  command.option("--zstd", "LEVEL", &options->zstd_level, "Pack what gets smaller by it, at a level from 1 to 19")
      .within(1, 19);
  command.run = [options] {
    const auto run = [&](const Input& file, bool many) {
      return compile_file(*options, file.path, many ? file.output : options->out, many);
    };
    return run_batch(options->files, {run, {}, BatchOutput{options->out, ".sinew"}});
  };
  return command;
}

}  // namespace sinew::tool
