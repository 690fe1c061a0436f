// SPDX-License-Identifier: MIT
#include "tests/bench/clip_characters.h"

#include <algorithm>

#include "importer/import_gltf.h"
#include "runtime/compress/compile_clip_within.h"
#include "samples/showcase/showcase.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/corpus.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

constexpr std::size_t kFewestJoints = 16, kMostClips = 3, kMostModels = 4;

bool is_linear(const Animation& animation) {
  return std::all_of(animation.bones.begin(), animation.bones.end(), [](const BoneAnimation& bone) {
    return bone.translation.interpolation == Interpolation::linear &&
           bone.rotation.interpolation == Interpolation::linear && bone.scale.interpolation == Interpolation::linear;
  });
}

bool moves_a_skin(const Scene& scene) {
  return scene.skeleton.joint_count() >= kFewestJoints && !scene.skins.empty() && !scene.animations.empty() &&
         scene.animations[0].bones.size() >= kFewestJoints / 2 && is_linear(scene.animations[0]);
}

void add_clips(const std::string& name, const Scene& scene, std::vector<std::shared_ptr<const Character>>& to) {
  const VirtualVertices vertices = virtual_vertices(scene);
  for (std::size_t c = 0; c < std::min(kMostClips, scene.animations.size()); ++c) {
    const Animation& animation = scene.animations[c];
    if (!is_linear(animation) || animation.bones.empty()) continue;
    const auto character = std::make_shared<Character>(
        scene.animations.size() == 1 ? name : name + "-" + std::to_string(c), scene.skeleton, animation);
    character->packed = compile_clip_within(scene, animation, vertices, kPackedBudgetM).clip;
    to.push_back(character);
  }
}

Scene swinging_scene(Skeleton skeleton, std::size_t keys) {
  Scene scene;
  scene.animations.push_back(scenes::swinging(skeleton, keys));
  scene.skeleton = std::move(skeleton);
  finish_scene(scene);
  return scene;
}

Animation joints_of(Animation animation) {
  animation.weights.clear();
  animation.properties.clear();
  return animation;
}

}  // namespace

Character::Character(std::string named, Skeleton s, Animation a)
    : name(std::move(named)),
      skeleton(std::move(s)),
      animation(joints_of(std::move(a))),
      clip(test::clip_of(animation, skeleton)) {}

const std::vector<NamedScene>& corpus_scenes() {
  static const std::vector<NamedScene> scenes = [] {
    std::vector<NamedScene> found;
    if (!test::corpus()) return found;
    for (const auto& path : test::corpus_files("models", {".glb", ".gltf"})) {
      const std::string name = path.parent_path().filename().string();
      if (name.find('-') != std::string::npos) continue;  // the same model in another encoding
      auto file = import_gltf(path, {.decode_images = false});
      if (!file || !moves_a_skin(file->scene)) continue;
      if (std::any_of(found.begin(), found.end(), [&](const NamedScene& s) { return s.name == name; })) continue;
      found.push_back({name, std::make_shared<const Scene>(std::move(file->scene))});
    }
    std::stable_sort(found.begin(), found.end(), [](const NamedScene& a, const NamedScene& b) {
      return a.scene->skeleton.joint_count() < b.scene->skeleton.joint_count();
    });
    if (found.size() > kMostModels) found.resize(kMostModels);
    return found;
  }();
  return scenes;
}

const std::vector<std::shared_ptr<const Character>>& characters() {
  static const std::vector<std::shared_ptr<const Character>> all = [] {
    std::vector<std::shared_ptr<const Character>> found;
    const auto add = [&](const char* name, Skeleton skeleton, std::size_t keys) {
      Animation animation = scenes::swinging(skeleton, keys);
      found.push_back(std::make_shared<Character>(name, std::move(skeleton), std::move(animation)));
    };
    add_clips("biped67", swinging_scene(scenes::biped(), 300), found);
    add("tree1024", scenes::wide_tree(1024), 120);
    add("chain1024", scenes::long_chain(1024), 120);
    for (const auto& shown : showcase::showcase())
      if (moves_a_skin(shown.scene)) add_clips("showcase", shown.scene, found);
    for (const NamedScene& model : corpus_scenes()) add_clips(model.name, *model.scene, found);
    return found;
  }();
  return all;
}

}  // namespace sinew::bench
