// SPDX-License-Identifier: MIT
#include "importer/tool/fit_clips.h"

#include <cmath>
#include <mutex>
#include <numbers>

#include "importer/tool/progress_line.h"
#include "runtime/base/contract.h"
#include "runtime/compress/virtual_vertices.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/threads/default_executor.h"

namespace sinew::tool {
namespace {

/// Calls `work(i)` for every clip, several at a time, and shows how many are done. A thread that waits for parts of one
/// clip begins no other clip, since run_in_parallel() keeps to its own loop: the samples of each take memory.
template <class Work>
void for_each_clip(const char* what, std::size_t count, const Work& work) {
  ProgressLine progress;
  std::mutex mutex;
  std::size_t done = 0;
  run_in_parallel(count, [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    progress.show(what, static_cast<double>(++done) / static_cast<double>(count));
  });
}

/// The largest angle by which keys that are left out may turn a camera or a light: about one pixel of a picture.
constexpr double kLargestTurn_rad = 0.05 * std::numbers::pi / 180.0;

/// The virtual vertices of a scene. Cameras and lights that have a direction get more of them, far from their joint.
/// Turning the joint by kLargestTurn_rad moves one of these by the whole budget.
VirtualVertices vertices_with_aims(const Scene& scene, double budget_m) {
  VirtualVertices vertices = virtual_vertices(scene);
  if (!std::isfinite(budget_m)) return vertices;
  const auto half = static_cast<float>(budget_m / (std::numbers::sqrt2 * kLargestTurn_rad));
  const auto add = [&](std::uint32_t joint) {
    if (joint == kNone) return;
    vertices.boxes[joint].add(glm::vec3(-half));
    vertices.boxes[joint].add(glm::vec3(half));
  };
  for (const Camera& camera : scene.cameras) add(camera.joint);
  for (const Light& light : scene.lights)
    if (light.kind != Light::Kind::point) add(light.joint);
  return vertices;
}

ClipWithin fit_clip(const Scene& scene, const Animation& animation, const VirtualVertices& vertices, double budget_m) {
  if (budget_m == 0.0) return compile_clip_within(scene, animation, vertices, budget_m);
  ClipSearch search(scene, animation, vertices, budget_m);
  run_in_parallel(ClipSearch::kParts, [&](std::size_t part) { search.run(part); });
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

std::vector<Animation> fit_file_keys(const Scene& scene, std::span<const Animation> truths,
                                     std::span<const Animation> stored, double budget_m) {
  CONTRACT(stored.size() == truths.size());
  const VirtualVertices vertices = vertices_with_aims(scene, budget_m);
  std::vector<Animation> keys(truths.size());
  for_each_clip("fitting clips", keys.size(),
                [&](std::size_t i) { keys[i] = fit_keys(scene, truths[i], stored[i], vertices, budget_m); });
  return keys;
}

std::vector<ClipCertificate> certify_keys(const Scene& scene, std::span<const Animation> truths,
                                          std::span<const Animation> written, double asked_m) {
  CONTRACT(written.size() == truths.size());
  const VirtualVertices vertices = vertices_with_aims(scene, asked_m);
  std::vector<ClipCertificate> certificates(written.size());
  for_each_clip("measuring clips", written.size(), [&](std::size_t i) {
    certificates[i] = measure_keys(scene, written[i], truths[i], vertices, asked_m);
  });
  return certificates;
}

ClipBoxes bound_clips(const Scene& scene) {
  ClipBoxes boxes(scene.animations.size());
  for_each_clip("bounding clips", boxes.size(),
                [&](std::size_t i) { boxes[i] = clip_boxes(scene, static_cast<std::uint32_t>(i)); });
  return boxes;
}

}  // namespace sinew::tool
