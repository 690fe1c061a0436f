// SPDX-License-Identifier: MIT
#include "viewer/app/exhibit.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "importer/add_centers_of_rotation.h"
#include "importer/import_gltf.h"
#include "samples/showcase/showcase.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

std::vector<Exhibit> built_in() {
  std::vector<Exhibit> exhibits;
  for (auto& shown : showcase::showcase()) {
    auto& exhibit = exhibits.emplace_back();
    exhibit.name = std::move(shown.name);
    exhibit.note = std::move(shown.what_to_look_at);
    exhibit.scene = std::move(shown.scene);
    exhibit.instance_skinning = std::move(shown.needs.instance_skinning);
    exhibit.camera = PlacedCamera{shown.eye, shown.target};
    exhibit.fov_y_rad = static_cast<double>(shown.fov_y_rad);
  }
  return exhibits;
}

/// Warns about what the scene has and the viewer does not show.
void say_what_is_left_out(const std::string& file, const Scene& scene,
                          const std::function<void(const std::string&)>& say) {
  if (scene.lights.size() > kMaxLights)
    say(file + ": warning: " + std::to_string(scene.lights.size()) + " lights; the viewer uses the first " +
        std::to_string(kMaxLights));
  for (const Material& material : scene.materials)
    for (const TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                                  &material.normal_texture, &material.occlusion_texture, &material.emissive_texture})
      if (use->used() && use->texcoord > 1)
        say(file + ": warning: material \"" + material.name + "\" uses TEXCOORD_" + std::to_string(use->texcoord) +
            "; the viewer takes TEXCOORD_0 instead");
}

tl::expected<Exhibit, LoadError> from_file(const std::string& file, const std::function<void(const std::string&)>& say,
                                           const std::function<void(double)>& progress) {
  ImportOptions how;
  if (progress) how.progress = [&](const char*, double done) { progress(done); };
  auto imported = import_gltf(std::filesystem::path(file), how);
  const auto& warnings = imported ? imported->warnings : imported.error().warnings;
  for (const auto& warning : warnings) say(describe(file, warning));
  if (!imported) return tl::unexpected(LoadError{1, describe(file, imported.error().issue)});
  say_what_is_left_out(file, imported->scene, say);
  Exhibit exhibit;
  exhibit.name = std::filesystem::path(file).filename().string();
  exhibit.scene = std::move(imported->scene);
  return exhibit;
}

}  // namespace

Needs needs_of(const Exhibit& exhibit, const Evaluation& evaluation) {
  Needs needs;
  needs.bounds = true;
  needs.max_layers = 1;
  needs.skinning = evaluation.skinning;
  needs.instance_skinning = exhibit.instance_skinning;
  needs.stage_times = evaluation.stage_times;
  needs.between_updates = evaluation.updates == Updates::interpolated;
  return needs;
}

tl::expected<std::vector<Exhibit>, LoadError> load_exhibits(const Options& options,
                                                            const std::function<void(const std::string&)>& say,
                                                            const std::function<void(double)>& progress) {
  std::vector<Exhibit> exhibits;
  if (options.file.empty()) {
    exhibits = built_in();
    if (options.showcase_scene >= exhibits.size())
      return tl::unexpected(LoadError{2, "--scene " + std::to_string(options.showcase_scene) +
                                             ": the built-in scenes are 0 to " + std::to_string(exhibits.size() - 1)});
  } else {
    auto exhibit = from_file(options.file, say, progress);
    if (!exhibit) return tl::unexpected(std::move(exhibit.error()));
    exhibits.push_back(std::move(*exhibit));
  }
  return exhibits;
}

void add_missing_centers(Exhibit& exhibit, Skinning skinning, const std::function<void(double)>& progress) {
  const auto& own = exhibit.instance_skinning;
  const bool asked_for = own.empty() ? skinning == Skinning::center_of_rotation
                                     : std::find(own.begin(), own.end(), Skinning::center_of_rotation) != own.end();
  if (!asked_for) return;
  CentersOptions how;
  how.progress = progress;
  add_centers_of_rotation(exhibit.scene, how);
}

}  // namespace sinew::viewer
