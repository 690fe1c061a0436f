// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <memory>
#include <string>

#include <fmt/format.h>

#include "importer/tool/info_clips.h"
#include "importer/tool/info_json.h"
#include "importer/tool/info_text.h"
#include "importer/tool/load_file.h"

namespace sinew::tool {
namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

ExitCode tell_about(const InfoOptions& options) {
  if (const auto outcome = tell_about_clips(options.file, options.json)) return *outcome;
  ImportOptions import;
  import.decode_images = false;
  import.probe_images = true;
  const auto file = load_file(options.file, import);
  if (!file) return ExitCode::input_at_fault;
  const nlohmann::ordered_json info = info_json(options.file, *file);
  if (options.json)
    fmt::print("{}\n", info.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    fmt::print("{}", info_text(info));
  return ExitCode::done;
}

}  // namespace

void add_info(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand(
      "info",
      "Tell what is inside: nodes, meshes, skins, morph targets, clips, materials, images, extensions, warnings.");
  command->add_option("FILE", options->file, "A .gltf or .glb file, or compiled clips")->required();
  command->add_flag("--json", options->json, "Print the same as JSON");
  command->callback([options, &outcome] { outcome = tell_about(*options); });
}

}  // namespace sinew::tool
