// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "importer/export_glb.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/length_text.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "importer/write/replace_file.h"
#include "runtime/base/contract.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew::tool {
namespace fs = std::filesystem;
namespace {

struct ConvertOptions {
  std::string in, out;
  std::optional<std::string> budget;
};

/// Why OUT cannot be written, found before any work is done; empty when it can.
std::string objection(const ConvertOptions& options) {
  const fs::path out(options.out), folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  std::error_code error;
  if (out.extension() != ".glb") return "OUT must end in .glb: binary glTF is what is written";
  if (fs::equivalent(options.in, out, error)) return "OUT is the file that is read; it is left as it is";
  if (!fs::is_directory(folder, error)) return fmt::format("there is no folder {}", folder.string());
  return {};
}

/// The scene's animations without the keys that the budget allows to leave out.
std::vector<Animation> reduced_animations(const Scene& scene, const VirtualVertices& vertices, double budget_m,
                                          ProgressLine& progress) {
  std::vector<Animation> reduced;
  for (const Animation& truth : scene.animations) {
    progress.show("fitting clips", static_cast<double>(reduced.size()) / static_cast<double>(scene.animations.size()));
    reduced.push_back(compile_clip_within(scene, truth, vertices, budget_m).keys);
  }
  return reduced;
}

/// The clips of animations that were reduced, written and read again, each measured against its original animation.
std::vector<Clip> certify_clips(const Scene& scene, const VirtualVertices& vertices,
                                const std::vector<Animation>& written, double budget_m) {
  CONTRACT(written.size() == scene.animations.size());
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < written.size(); ++i)
    clips.push_back(compile_and_measure(scene, written[i], scene.animations[i], vertices, budget_m));
  return clips;
}

/// The scene as the bytes of a .glb, with progress on a terminal.
ImportResult<std::vector<std::byte>> export_shown(const ImportedFile& file) {
  ProgressLine progress;
  return export_glb(file.scene,
                    {file.facts.copyright, [&](const char* stage, double done) { progress.show(stage, done); }});
}

/// The same with as few keys as the budget allows. Prints what is measured after reading these bytes again.
ImportResult<std::vector<std::byte>> export_within(ImportedFile& file, double budget_m) {
  Scene& scene = file.scene;
  const VirtualVertices vertices = virtual_vertices(scene);
  ProgressLine progress;
  std::vector<Animation> animations = reduced_animations(scene, vertices, budget_m, progress);
  progress.wipe();
  std::swap(scene.animations, animations);
  auto bytes = export_shown(file);
  std::swap(scene.animations, animations);
  if (!bytes) return bytes;
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = false;
  const auto again = import_gltf(*bytes, "the written file", plain);
  if (!again) return tl::unexpected(again.error());
  fmt::print(
      "{}", certificate_table(certify_clips(scene, vertices, again->scene.animations, budget_m), scene.skeleton.names));
  return bytes;
}

ExitCode convert_file(const ConvertOptions& options) {
  if (const std::string why = objection(options); !why.empty())
    return fail_with(ExitCode::wrong_usage, fmt::format("{}: {}", options.out, why));
  const auto budget_m = parse_length(options.budget.value_or("0"));
  if (!budget_m) return fail_with(ExitCode::wrong_usage, "--budget: " + budget_m.error());
  ImportOptions import;
  import.decode_images = false;
  import.probe_images = import.keep_encoded_images = true;
  auto file = load_file(options.in, import);
  if (!file) return ExitCode::input_at_fault;
  const auto bytes = options.budget ? export_within(*file, *budget_m) : export_shown(*file);
  if (!bytes) return fail_with(ExitCode::input_at_fault, options.in, bytes.error().issue);
  if (const auto fault = write::replace_file(options.out, *bytes))
    return fail_with(ExitCode::machine_lacks, options.out, {Severity::error, "write-file", "", *fault});
  fmt::print("{}: {} bytes\n", options.out, bytes->size());
  return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand(
      "convert",
      "Write a file again as one binary file: nodes, meshes, skins, clips, morph targets, materials, images, cameras,\n"
      "lights. Compressed and quantised data become plain floats; images keep their bytes. Reading OUT gives the same\n"
      "scene, bit for bit. OUT appears complete or not at all.\n"
      "With a budget, keys are left out of clips as long as no vertex of the model ever moves farther than the budget\n"
      "from where it was; the written file is read again and measured.");
  command->add_option("IN", options->in, "A .gltf or .glb file")->required();
  command->add_option("OUT.glb", options->out, "The file to write; it must not be the one that is read")->required();
  command->add_option("--budget", options->budget,
                      "Largest distance by which leaving out keys may move anything: 0.1mm, 1e-4");
  command->callback([options, &outcome] { outcome = convert_file(*options); });
}

}  // namespace sinew::tool
