// SPDX-License-Identifier: MIT
// One-time work: compiling and loading clips, compiling plans, the memory of a character and its first frame.
#include <cstdlib>

#include "runtime/clip/clip_file.h"
#include "runtime/plan/run_plan.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/measure.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"

namespace sinew::bench {
namespace {

std::size_t key_count(const Animation& animation) {
  std::size_t count = 0;
  for (const BoneAnimation& bone : animation.bones)
    count += bone.translation.times_s.size() + bone.rotation.times_s.size() + bone.scale.times_s.size();
  return count;
}

void add_scene(const std::string& name, const std::shared_ptr<const Scene>& scene) {
  const std::size_t joints = scene->skeleton.joint_count(), keys = key_count(scene->animations[0]);
  const auto weights = std::make_shared<const std::vector<float>>(rest_weights_of(*scene));
  add("compile_clip/sinew/" + name, keys, [scene, weights] {
    benchmark::DoNotOptimize(
        compile_clip(scene->animations[0], scene->skeleton, *weights, scene->first_weight, scene->properties));
  });
  const Clip* clips[] = {&scene->clips[0]};
  const auto block = std::make_shared<const std::vector<std::byte>>(save_clips(clips));
  add("load_clips/sinew/" + name, keys, [block] {
    if (!load_clips(*block)) std::abort();
  });
  add("compile_plan/sinew/" + name, joints,
      [scene] { benchmark::DoNotOptimize(compile_plan(lend(*scene), Needs{.out = {.tangents = false}})); });
  const auto plan = std::make_shared<const Plan>(compile_plan(lend(*scene), Needs{.out = {.tangents = false}}));
  add("first_frame/sinew/" + name, 1, [scene, plan] {
    FrameBuffer frame(*plan);
    const ClipLayer layer{0, 0.1};
    if (run_plan(*plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame) != ErrorCode::ok) std::abort();
  });
}

}  // namespace

void add_setup() {
  Skeleton biped = scenes::biped();
  Animation swinging = scenes::swinging(biped, 300);
  add_scene("biped67",
            std::make_shared<const Scene>(scenes::swinging_surface(std::move(biped), std::move(swinging), 3'273, 4)));
  for (const NamedScene& model : corpus_scenes()) add_scene(model.name, model.scene);
}

}  // namespace sinew::bench
