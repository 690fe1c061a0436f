// SPDX-License-Identifier: MIT
#include "tests/golden/golden_scenes.h"

#include <cmath>

#include "runtime/base/contract.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/stretches.h"
#include "tests/scenes/swinging.h"

namespace sinew::test {
namespace {

void snap(float& x) { x = std::nearbyint(x * 65536.0f) / 65536.0f; }

template <class V>
requires requires { V::length(); }
void snap(V& v) {
  for (int i = 0; i < V::length(); ++i) snap(v[i]);
}

void snap(Affine& m) {
  for (glm::vec4& row : m.row) snap(row);
}

template <class T>
void snap(std::vector<T>& values) {
  for (T& value : values) snap(value);
}

void snap(Primitive& p) {
  p.bounds = {};  // finish_scene computes it from the new positions
  snap(p.positions);
  snap(p.normals);
  snap(p.tangents);
  snap(p.colors);
  snap(p.influences.weights);
  for (MorphTarget& t : p.morphs.targets) {
    snap(t.positions.deltas);
    snap(t.normals.deltas);
    snap(t.tangents.deltas);
    snap(t.colors.deltas);
  }
}

void snap(Animation& animation) {
  for (BoneAnimation& bone : animation.bones) {
    snap(bone.translation.values);
    snap(bone.rotation.values);
    snap(bone.scale.values);
  }
  for (WeightAnimation& animated : animation.weights) snap(animated.weights.values);
}

/// Puts centers halfway between each vertex and the origin. Center-of-rotation skinning then differs from the other
/// methods.
void place_centers(Primitive& p) {
  p.centers_of_rotation.clear();
  if (p.influences.empty()) return;
  for (const glm::vec3& position : p.positions) p.centers_of_rotation.push_back(position * 0.5f);
}

Scene snapped(Scene scene) {
  for (Transform& t : scene.skeleton.rest) {
    snap(t.translation);
    snap(t.rotation);
    snap(t.scale);
  }
  snap(scene.skeleton.fixed_matrices);
  for (Skin& skin : scene.skins) snap(skin.inverse_bind);
  for (Mesh& mesh : scene.meshes) {
    snap(mesh.default_weights);
    for (Primitive& p : mesh.primitives) {
      snap(p);
      place_centers(p);
    }
  }
  for (MeshInstance& instance : scene.instances) snap(instance.rest_weights);
  for (Animation& animation : scene.animations) snap(animation);
  scene.clips.clear();
  finish_scene(scene);
  CONTRACT(check(scene) == ErrorCode::ok);
  return scene;
}

Scene swinging_scene(const Skeleton& skeleton, std::uint32_t vertices, std::uint32_t influences) {
  return scenes::swinging_surface(skeleton, scenes::swinging(skeleton, 60), vertices, influences);
}

/// A scene in which every third joint shrinks to a plane, then to a point, and grows again. So degenerate blends occur
/// among ordinary ones.
Scene collapsing_scene() {
  Scene scene = random_scene(9, {.joints = 20, .targets = 0, .triangles = 30});
  for (Animation& animation : scene.animations)
    for (BoneAnimation& bone : animation.bones)
      if (bone.joint % 3 == 0)
        bone.scale = {Interpolation::linear,
                      {0.0f, 0.4f, 0.75f, 1.9f},
                      {glm::vec3(1), glm::vec3(1, 0, 1), glm::vec3(0), glm::vec3(1)}};
  return scene;
}

/// Vertices that share joints, which plans sort into tiles.
Scene sharing_scene() {
  Scene scene = random_scene(11, {.joints = 16, .targets = 0, .triangles = 120, .flat_normals = true});
  share_joints_in_stretches(scene, 21);
  return scene;
}

}  // namespace

std::vector<GoldenScene> golden_scenes() {
  std::vector<GoldenScene> all;
  const auto add = [&](const char* name, Scene scene) { all.push_back({name, snapped(std::move(scene))}); };
  add("biped-4", swinging_scene(scenes::biped(), 501, 4));
  add("tree-1", swinging_scene(scenes::wide_tree(200), 203, 1));
  add("chain-6", swinging_scene(scenes::long_chain(64), 131, 6));
  add("random-0", random_scene(0));
  add("random-1", random_scene(1, {.joints = 33, .targets = 7, .mirrored_joints = true}));
  add("random-2", random_scene(2, {.flat_normals = true}));
  add("collapsing", collapsing_scene());
  add("sharing", sharing_scene());
  add("limb-4", swinging_scene(scenes::long_chain(9), 612, 4));
  return all;
}

}  // namespace sinew::test
