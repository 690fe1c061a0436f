// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/assets/asset_info.h"
#include "importer/tool/bake/geometry_table.h"
#include "importer/tool/bake/read_cache.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/info/info_json.h"
#include "importer/tool/info/info_text.h"
#include "importer/tool/info/node_tree.h"
#include "importer/tool/json.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

struct InfoOptions {
  BatchOptions files;
  bool tree = false, all = false;
};

/// Prints what an asset file or a file of compiled clips contains; no value if the file is neither.
std::optional<ExitCode> print_asset_info(const std::string& file, bool json, bool many) {
  const auto info = asset_info(file);
  if (!info) return std::nullopt;
  if (!*info) return fail_with(ExitCode::input_at_fault, fmt::format("{}: {}", file, info->error()));
  if (json) {
    print_json((*info)->json, many);
    return ExitCode::done;
  }
  print_result("{}{}{}\n", visible_text(file), many ? ": " : "\n", (*info)->headline);
  if (!many) print_result_text((*info)->tables);
  return ExitCode::done;
}

/// Prints what a geometry cache contains; no value if the file is none. Reads only its head.
std::optional<ExitCode> print_geometry_info(const std::string& file, bool json, bool many) {
  const auto read = read_cache(file, false);
  if (!read) return std::nullopt;
  if (!*read) return read->error();
  const GeometryCache& cache = (*read)->cache;
  if (json) {
    print_json({{"file", file}, {"geometry_cache", geometry_json(cache)}}, many);
    return ExitCode::done;
  }
  print_result("{}{}geometry cache, version {}\n", visible_text(file), many ? ": " : "\n", kGeometryFileVersion);
  if (!many) print_result_text(geometry_table(cache));
  return ExitCode::done;
}

ExitCode print_info(const InfoOptions& options, const std::string& path, bool many) {
  if (const auto outcome = print_asset_info(path, options.files.json, many)) return *outcome;
  if (const auto outcome = print_geometry_info(path, options.files.json, many)) return *outcome;
  ImportOptions import;
  import.decode_images = false;
  import.probe_images = true;
  import.carry_document = true;
  auto file = import_with_progress(path, import);
  std::vector<ImportIssue> not_carried;
  if (!file) {  // a file with faulty animations can be read, but not written
    import.carry_document = false;
    if (auto read = import_with_progress(path, import)) {
      not_carried.push_back(std::move(file.error().issue));
      file = std::move(read);
    }
  }
  if (!file) {
    print_import_error(path, file.error());
    return ExitCode::input_at_fault;
  }
  Json info = info_json(path, *file, not_carried);
  if (options.tree) info["node_list"] = node_list_json(file->scene);
  if (options.files.json)
    print_json(info, many);
  else if (!many)
    print_result_text(info_text(info, options.all));
  else
    print_result("{}{}", info_line(info), options.tree ? node_tree_text(info["node_list"]) : std::string());
  return ExitCode::done;
}

}  // namespace

Command info_command() {
  auto options = std::make_shared<InfoOptions>();
  Command command("info",
                  "Show what files hold: nodes, meshes, skins, clips, materials, images, extensions\n"
                  "Also bounds, warnings, and what `sinew convert` would lose. Several files have one line each.");
  add_batch_options(
      command, options->files,
      ".gltf or .glb files, .sinew files, geometry caches, and folders of models; - is the standard input")
      .required();
  command.flag("--tree", options->tree, "Also show the tree of nodes, and what hangs on each");
  command.flag("--all", options->all, "List every warning and joint, not one warning of each rule");
  command.flag("--json", options->files.json, "Print the same as JSON, of several files one document a line");
  command.run = [options] {
    return run_batch(options->files,
                     {[&](const Input& file, bool many) { return print_info(*options, file.path, many); }});
  };
  return command;
}

}  // namespace sinew::tool
