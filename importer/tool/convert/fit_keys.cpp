// SPDX-License-Identifier: MIT
#include "importer/tool/convert/fit_keys.h"

#include "importer/import_gltf.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/fit_clips.h"

namespace sinew::tool {

std::vector<Animation> fit_keys(const Scene& scene, std::span<const Animation> truths, double budget_m) {
  std::vector<Animation> reduced;
  for (ClipWithin& clip : fit_clips(scene, truths, budget_m)) reduced.push_back(std::move(clip.keys));
  return reduced;
}

ImportResult<std::string> certificates(const Scene& scene, std::span<const Animation> truths,
                                       const std::filesystem::path& file, double budget_m) {
  ImportOptions plain;
  plain.decode_images = plain.make_tangents = false;
  const auto again = import_gltf(file, plain);
  if (!again) return tl::unexpected(again.error());
  return certificate_table(certify_clips(scene, truths, again->scene.animations, budget_m), scene.skeleton.names);
}

}  // namespace sinew::tool
