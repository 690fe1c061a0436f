// SPDX-License-Identifier: MIT
#include "importer/export_glb.h"

#include <algorithm>
#include <utility>

#include "importer/platform/files.h"
#include "importer/write/glb_file.h"
#include "importer/write/replace_file.h"
#include "importer/write/write_scene.h"

namespace sinew {
namespace {

ImportError failure(ImportIssue issue) { return {"", std::move(issue), {}, {}}; }

}  // namespace

void write::declare_extension(tinygltf::Model& model, const char* name) {
  auto& used = model.extensionsUsed;
  if (std::find(used.begin(), used.end(), name) == used.end()) used.emplace_back(name);
}

ImportResult<std::vector<std::byte>> export_glb(const Scene& scene, const ExportOptions& options) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "sinew";
  model.asset.copyright = options.copyright;
  const auto begin = [&](const char* stage, double done) {
    if (options.progress) options.progress(stage, done);
  };
  write::GlbBuffer buffer(model);
  begin("writing images", 0.0);
  write::write_images(scene, model, buffer);
  write::write_materials(scene, model);
  begin("writing meshes", 0.3);
  write::write_meshes(scene, model, buffer);
  write::write_variants(scene, model);
  write::write_cameras_and_lights(scene, model);
  begin("writing clips", 0.6);
  const std::vector<int> node_of_instance = write::write_nodes(scene, model, buffer);
  if (auto issue = write::write_animations(scene, node_of_instance, model, buffer))
    return tl::unexpected(failure(*std::move(issue)));
  begin("writing the file", 0.9);
  if (auto file = write::glb_file(model)) return *std::move(file);
  return tl::unexpected(
      failure({Severity::error, "glb-size", "/buffers/0", "the scene does not fit into a GLB of 4 GiB"}));
}

ImportResult<std::size_t> export_glb(const Scene& scene, const std::filesystem::path& file,
                                     const ExportOptions& options) {
  auto bytes = export_glb(scene, options);
  if (!bytes) return tl::unexpected(std::move(bytes).error());
  if (auto fault = write::replace_file(file, *bytes))
    return tl::unexpected(
        ImportError{platform::text_of(file), {Severity::error, "write-file", "", *std::move(fault)}, {}, {}});
  return bytes->size();
}

}  // namespace sinew
