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
#include "importer/tool/reduce_clips.h"
#include "importer/write/replace_file.h"

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
  std::vector<Animation> animations =
      reduced_animations(scene, vertices, budget_m, [&](double done) { progress.show("fitting clips", done); });
  progress.wipe();
  std::swap(scene.animations, animations);
  auto bytes = export_shown(file);
  std::swap(scene.animations, animations);
  if (!bytes) return bytes;
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = false;
  const auto again = import_gltf(*bytes, "what was written", plain);
  if (!again) return tl::unexpected(again.error());
  fmt::print(
      "{}", certificate_table(certify_clips(scene, vertices, again->scene.animations, budget_m), scene.skeleton.names));
  return bytes;
}

ExitCode convert_file(const ConvertOptions& options) {
  if (const std::string why = objection(options); !why.empty())
    return say_error(fmt::format("{}: {}", options.out, why)), ExitCode::wrong_usage;
  const auto budget_m = parse_length(options.budget.value_or("0"));
  if (!budget_m) return say_error("--budget: " + budget_m.error()), ExitCode::wrong_usage;
  ImportOptions import;
  import.decode_images = false;
  import.probe_images = import.keep_encoded_images = true;
  auto file = load_file(options.in, import);
  if (!file) return ExitCode::input_at_fault;
  const auto bytes = options.budget ? export_within(*file, *budget_m) : export_shown(*file);
  if (!bytes) return say_issue(options.in, bytes.error().issue), ExitCode::input_at_fault;
  if (const auto fault = write::replace_file(options.out, *bytes))
    return say_issue(options.out, {Severity::error, "write-file", "", *fault}), ExitCode::machine_lacks;
  fmt::print("{}: {} bytes\n", options.out, bytes->size());
  return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand("convert",
                                             "Write what was read as one binary file: nodes, meshes, skins, clips, "
                                             "morph targets, materials, images, cameras,\n"
                                             "lights. Compressed and quantised data are written as plain floats, "
                                             "images stay as they are. Reading OUT gives the\n"
                                             "same scene, bit for bit. OUT appears complete or not at all.\n"
                                             "With a budget, keys are left out of clips as long as no vertex of the "
                                             "model moves farther than that from where it\n"
                                             "was, at any time; what was written is read again and measured.");
  command->add_option("IN", options->in, "A .gltf or .glb file")->required();
  command->add_option("OUT.glb", options->out, "The file to write, never the one that is read")->required();
  command->add_option("--budget", options->budget,
                      "Largest distance by which leaving out keys may move anything: 0.1mm, 1e-4");
  command->callback([options, &outcome] { outcome = convert_file(*options); });
}

}  // namespace sinew::tool
