// SPDX-License-Identifier: MIT
#include "importer/tool/reduce_clips.h"

#include "runtime/base/contract.h"
#include "runtime/compress/compile_clip_within.h"

namespace sinew::tool {

std::vector<Animation> reduced_animations(const Scene& scene, const VirtualVertices& vertices, double budget_m,
                                          const ClipProgress& progress) {
  std::vector<Animation> reduced;
  for (const Animation& truth : scene.animations) {
    progress(static_cast<double>(reduced.size()) / static_cast<double>(scene.animations.size()));
    reduced.push_back(compile_clip_within(scene, truth, vertices, budget_m).keys);
  }
  return reduced;
}

std::vector<Clip> certify_clips(const Scene& scene, const VirtualVertices& vertices,
                                const std::vector<Animation>& written, double budget_m) {
  CONTRACT(written.size() == scene.animations.size());
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < written.size(); ++i)
    clips.push_back(compile_and_measure(scene, written[i], scene.animations[i], vertices, budget_m));
  return clips;
}

}  // namespace sinew::tool
