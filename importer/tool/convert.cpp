// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "importer/export_glb.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"

namespace sinew::tool {
namespace fs = std::filesystem;
namespace {

struct ConvertOptions {
  std::string in, out;
};

/// Why OUT cannot be what is written, before any work is done; empty when it can.
std::string objection(const ConvertOptions& options) {
  const fs::path out(options.out), folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  std::error_code error;
  if (out.extension() != ".glb") return "OUT must end in .glb: binary glTF is what is written";
  if (fs::equivalent(options.in, out, error)) return "OUT is the file that is read; it is left as it is";
  if (!fs::is_directory(folder, error)) return fmt::format("there is no folder {}", folder.string());
  return {};
}

ExitCode convert_file(const ConvertOptions& options) {
  if (const std::string why = objection(options); !why.empty())
    return say_error(fmt::format("{}: {}", options.out, why)), ExitCode::wrong_usage;
  ImportOptions import;
  import.keep_encoded_images = true;
  const auto file = load_file(options.in, import);
  if (!file) return ExitCode::input_at_fault;
  ProgressLine progress;
  const auto show = [&](const char* stage, double done) { progress.show(stage, done); };
  const auto written = export_glb(file->scene, options.out, {file->facts.copyright, show});
  progress.wipe();
  if (written) {
    fmt::print("{}: {} bytes\n", options.out, *written);
    return ExitCode::done;
  }
  const bool disk = written.error().issue.rule == "write-file";
  say_issue(disk ? options.out : options.in, written.error().issue);
  return disk ? ExitCode::machine_lacks : ExitCode::input_at_fault;
}

}  // namespace

void add_convert(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand(
      "convert",
      "Write what was read as one binary file: nodes, meshes, skins, clips, morph targets, materials, images, cameras,\n"
      "lights. Compressed and quantised data are written as plain floats, images stay as they are. Reading OUT gives the\n"
      "same scene, bit for bit. OUT appears complete or not at all.");
  command->add_option("IN", options->in, "A .gltf or .glb file")->required();
  command->add_option("OUT.glb", options->out, "The file to write, never the one that is read")->required();
  command->callback([options, &outcome] { outcome = convert_file(*options); });
}

}  // namespace sinew::tool
