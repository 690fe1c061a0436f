// SPDX-License-Identifier: MIT
// Clip bounds of real files contain every vertex of every sampled frame.
#include <gtest/gtest.h>

#include "importer/import_gltf.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/run_plan.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {

bool holds(const Aabb& outer, const Aabb& inner) {
  return inner.empty() || (glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
                           glm::all(glm::greaterThanEqual(outer.upper, inner.upper)));
}

/// Checks several times of the clip; returns the number of boxes.
std::size_t expect_holds(const Scene& scene, const Plan& plan, std::uint32_t clip, const std::string& file) {
  constexpr int kTimes = 23;
  const std::vector<Aabb> reach = clip_bounds(scene, plan.needs(), clip);
  FrameBuffer frame(plan);
  std::size_t known = 0;
  for (int n = 0; n < kTimes; ++n) {
    const ClipLayer layer{clip, scene.animations[clip].duration_s * n / (kTimes - 1)};
    EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    for (std::size_t i = 0; i < reach.size(); ++i) {
      if (reach[i].empty()) continue;
      ++known;
      EXPECT_TRUE(holds(reach[i], frame.result().instances[i].bounds))
          << file << ": instance " << i << ", clip " << clip << ", " << layer.time_s << " s";
    }
  }
  return known;
}

TEST(clip_bounds_corpus, G54_holds_every_vertex_of_every_file) {
  ImportOptions options;
  options.decode_images = false;
  std::size_t boxes = 0;
  for (const auto& file : files_for_tests("models", {".gltf", ".glb"})) {
    const auto imported = import_gltf(file, options);
    if (!imported) continue;  // other tests report it
    Needs needs;
    needs.out.bounds = true;
    needs.out.normals = needs.out.tangents = false;
    needs.in.max_layers = 1;
    const Plan plan = compile_plan(lend(imported->scene), needs);
    for (std::uint32_t clip = 0; clip < imported->scene.animations.size(); ++clip)
      boxes += expect_holds(imported->scene, plan, clip, file.filename());
  }
  EXPECT_GT(boxes, 0u);
}

}  // namespace
}  // namespace sinew::test
