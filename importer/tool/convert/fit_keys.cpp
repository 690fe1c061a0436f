// SPDX-License-Identifier: MIT
#include "importer/tool/convert/fit_keys.h"

#include "importer/import_gltf.h"
#include "importer/tool/certificate_table.h"
#include "importer/tool/progress_line.h"
#include "runtime/base/contract.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew::tool {
namespace {

/// The clips of animations that were reduced, written and read again, each measured against its original animation.
std::vector<Clip> certify_clips(const Scene& scene, std::span<const Animation> truths,
                                const std::vector<Animation>& written, double budget_m) {
  CONTRACT(written.size() == truths.size());
  const VirtualVertices vertices = virtual_vertices(scene);
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < written.size(); ++i)
    clips.push_back(compile_and_measure(scene, written[i], truths[i], vertices, budget_m));
  return clips;
}

}  // namespace

std::vector<Animation> fit_keys(const Scene& scene, std::span<const Animation> truths, double budget_m) {
  const VirtualVertices vertices = virtual_vertices(scene);
  ProgressLine progress;
  std::vector<Animation> reduced;
  for (const Animation& truth : truths) {
    progress.show("fitting clips", static_cast<double>(reduced.size()) / static_cast<double>(truths.size()));
    reduced.push_back(compile_clip_within(scene, truth, vertices, budget_m).keys);
  }
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
