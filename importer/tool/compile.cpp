// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/certificate_table.h"
#include "importer/tool/files/output_check.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "importer/write/replace_file.h"
#include "runtime/clip/clip_file.h"
#include "runtime/compress/compile_clip_within.h"

namespace sinew::tool {
namespace {

struct CompileOptions {
  std::string in, out, budget = "0.1mm";
};

std::vector<Clip> compile_clips(const Scene& scene, double budget_m) {
  const VirtualVertices vertices = virtual_vertices(scene);
  ProgressLine progress;
  std::vector<Clip> clips;
  for (const Animation& truth : scene.animations) {
    progress.show("fitting clips", static_cast<double>(clips.size()) / static_cast<double>(scene.animations.size()));
    clips.push_back(compile_clip_within(scene, truth, vertices, budget_m).clip);
  }
  return clips;
}

ExitCode compile_file(const CompileOptions& options) {
  const auto budget_m = parse_length(options.budget);
  if (!budget_m) return fail_with(ExitCode::wrong_usage, "--budget: " + budget_m.error());
  ImportOptions import;
  import.decode_images = import.make_tangents = false;
  const auto file = load_file(options.in, import);
  if (!file) return ExitCode::input_at_fault;
  if (const auto why = objection_to_output(options.out, file->facts.files))
    return fail_with(ExitCode::wrong_usage, *why);
  const std::vector<Clip> clips = compile_clips(file->scene, *budget_m);
  std::vector<const Clip*> saved;
  for (const Clip& clip : clips) saved.push_back(&clip);
  const std::vector<std::byte> bytes = save_clips(saved);
  if (const auto fault = write::replace_file(options.out, bytes))
    return fail_with(ExitCode::machine_lacks, options.out, {Severity::error, "write-file", "", *fault});
  fmt::print("{}{}: {}, {}\n", certificate_table(clips, file->scene.skeleton.names), options.out,
             counted(clips.size(), "clip"), counted(bytes.size(), "byte"));
  return ExitCode::done;
}

}  // namespace

void add_compile(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<CompileOptions>();
  CLI::App* command = program.add_subcommand(
      "compile",
      "Compile the clips of a file for playback, as small as a budget allows: at no time is a vertex farther than the\n"
      "budget from where the file puts it. Prints what was measured of each clip; OUT stores that as well, and\n"
      "`sinew info OUT` shows it again. OUT belongs to the skeleton of FILE; load_clips (runtime/clip/clip_file.h)\n"
      "reads it.");
  command->add_option("FILE", options->in, "A .gltf or .glb file")->required();
  command->add_option("-o,--output", options->out, "The file to write")->required();
  command->add_option("--budget", options->budget, "Largest error: 0.1mm, 1e-4; 0 keeps every bit")
      ->capture_default_str();
  command->callback([options, &outcome] { outcome = compile_file(*options); });
}

}  // namespace sinew::tool
