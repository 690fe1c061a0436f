// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/run_plan.h"
#include "tests/asset_file/signed_file.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {
namespace {

/// Larger scenes take long and reveal nothing new.
constexpr std::size_t kMostJoints = 1'000, kMostVertices = 10'000;

bool is_small(const Scene& scene) {
  std::size_t vertices = 0;
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& primitive : scene.meshes[instance.mesh].primitives) vertices += primitive.vertex_count();
  return scene.skeleton.joint_count() <= kMostJoints && vertices <= kMostVertices;
}

void play(const Scene& scene, const ClipBoxes& boxes) {
  const Plan plan = compile_plan(lend(scene), {.out = {.bounds = true}});
  FrameBuffer frame(plan);
  for (std::uint32_t clip = 0; clip < std::min<std::size_t>(scene.clips.size(), 2); ++clip) {
    const ClipLayer layer{.clip = clip, .time_s = 0.37 * scene.clips[clip].duration_s()};
    require(run_plan(plan, {.layers = {&layer, 1}}, frame) == ErrorCode::ok, "a scene that was read can be played");
    if (clip < boxes.size() && !boxes[clip].empty())  // without boxes this takes long
      require(clip_bounds(scene, {}, clip, boxes[clip]).size() == scene.instances.size(), "every instance has a box");
  }
}

void read_all(Bytes file) {
  const auto opened = AssetFile::open(file);
  if (!opened) return require(!opened.error().rule.empty(), "an error names its rule");
  const auto scene = read_scene(*opened);
  if (!scene) return require(!scene.error().rule.empty() && !scene.error().block.empty(), "an error names its block");
  require(check(*scene) == ErrorCode::ok, "a scene that was read passes its checks");
  const auto boxes = read_clip_boxes(*opened, *scene);
  if (!boxes) return require(boxes.error().block == "bounds", "an error names its block");
  const auto lods = read_skeleton_lods(*opened, scene->skeleton);
  if (!lods) return require(lods.error().block == "skeleton_lods", "an error names its block");
  const auto graphs = read_graphs(*opened);
  if (!graphs) return require(graphs.error().block == "graphs", "an error names its block");
  if (is_small(*scene)) play(*scene, *boxes);
  const std::vector<std::byte> again =
      write_asset_file(*scene, {.truth = true, .clip_boxes = *boxes, .skeleton_lods = *lods});
  const auto reopened = AssetFile::open(again);
  require(reopened && read_scene(*reopened) && read_clip_boxes(*reopened, *scene) &&
              read_skeleton_lods(*reopened, scene->skeleton)->size() == lods->size(),
          "what was read can be written and read again");
}

}  // namespace

void read_asset_files(Bytes input) {
  read_all(input);
  std::vector<std::byte> file(input.begin(), input.end());
  test::sign_assets(file);
  read_all(file);
}

}  // namespace sinew::fuzz
