// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/pose/sample_clip.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/reordered_scene.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// A character with clips whose joints, meshes and morph targets all have distinct names.
inline Scene named_scene(std::uint64_t seed) {
  Scene scene = random_scene(seed, {.joints = 23, .instances = 2});
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    scene.meshes[m].name = "mesh " + std::to_string(m);
    scene.meshes[m].target_names = {"smile", "frown", "blink"};
  }
  for (std::size_t a = 0; a < scene.animations.size(); ++a) scene.animations[a].name = "clip " + std::to_string(a);
  finish_scene(scene);
  return scene;
}

struct Sample {
  std::vector<Transform> pose;
  std::vector<float> weights, numbers;
};

inline Sample sample(const Clip& clip, double time_s) {
  PoseBuffer pose(clip.joint_count());
  Sample out{{}, std::vector<float>(clip.weight_count()), std::vector<float>(clip.property_count())};
  run_unchecked(SampleClipJob{
      .clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = out.weights, .properties = out.numbers});
  for (std::size_t j = 0; j < clip.joint_count(); ++j) out.pose.push_back(pose.span().get(j));
  return out;
}

}  // namespace sinew::test
