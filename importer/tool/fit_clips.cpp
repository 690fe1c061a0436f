// SPDX-License-Identifier: MIT
#include "importer/tool/fit_clips.h"

#include <mutex>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "importer/tool/progress_line.h"
#include "runtime/base/contract.h"
#include "runtime/compress/virtual_vertices.h"
#include "runtime/lod/clip_bounds.h"

namespace sinew::tool {
namespace {

/// Calls `work(i)` for every clip, several at a time, and shows how many are done. Isolated: a thread that waits for
/// parts of one clip must not begin another clip, since the samples of each take memory.
template <class Work>
void for_each_clip(const char* what, std::size_t count, const Work& work) {
  ProgressLine progress;
  std::mutex mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    tbb::this_task_arena::isolate([&] { work(i); });
    const std::lock_guard lock(mutex);
    progress.show(what, static_cast<double>(++done) / static_cast<double>(count));
  });
}

ClipWithin fit_clip(const Scene& scene, const Animation& animation, const VirtualVertices& vertices, double budget_m) {
  if (budget_m == 0.0) return compile_clip_within(scene, animation, vertices, budget_m);
  ClipSearch search(scene, animation, vertices, budget_m);
  tbb::parallel_for(std::size_t{0}, ClipSearch::kParts, [&](std::size_t part) { search.run(part); });
  return search.take();
}

}  // namespace

std::vector<ClipWithin> fit_clips(const Scene& scene, std::span<const Animation> animations, double budget_m) {
  const VirtualVertices vertices = virtual_vertices(scene);
  std::vector<ClipWithin> clips(animations.size());
  for_each_clip("fitting clips", clips.size(),
                [&](std::size_t i) { clips[i] = fit_clip(scene, animations[i], vertices, budget_m); });
  return clips;
}

std::vector<Clip> certify_clips(const Scene& scene, std::span<const Animation> truths,
                                std::span<const Animation> written, double budget_m) {
  CONTRACT(written.size() == truths.size());
  const VirtualVertices vertices = virtual_vertices(scene);
  std::vector<Clip> clips(written.size());
  for_each_clip("measuring clips", clips.size(), [&](std::size_t i) {
    clips[i] = compile_and_measure(scene, written[i], truths[i], vertices, budget_m);
  });
  return clips;
}

ClipBoxes bound_clips(const Scene& scene) {
  ClipBoxes boxes(scene.animations.size());
  for_each_clip("bounding clips", boxes.size(),
                [&](std::size_t i) { boxes[i] = clip_boxes(scene, static_cast<std::uint32_t>(i)); });
  return boxes;
}

}  // namespace sinew::tool
