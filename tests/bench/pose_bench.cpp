// SPDX-License-Identifier: MIT
#include <cmath>

#include "runtime/jobs/blend_poses.h"
#include "runtime/jobs/local_to_model.h"
#include "runtime/jobs/sample_clip.h"
#include "tests/bench/glm_pose.h"
#include "tests/bench/measure.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// A skeleton with its clip in both forms, and room for poses of both implementations.
struct Character {
  Skeleton skeleton;
  Animation animation;
  Clip clip;
  test::PoseBuffer pose;
  std::vector<glm_pose::Joint> glm_joints;
  std::vector<Affine> model;
  std::vector<glm::mat4> glm_model;

  Character(Skeleton s, std::size_t key_count)
      : skeleton(std::move(s)), animation(scenes::swinging(skeleton, key_count)), clip(test::clip_of(animation, skeleton)),
        pose(skeleton.joint_count()), glm_joints(skeleton.joint_count()), model(skeleton.joint_count()), glm_model(skeleton.joint_count()) {}

  void sample(double time_s) { run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}}); }
  void sample_glm(double time_s) { glm_pose::sample(animation, skeleton.rest, static_cast<float>(time_s), glm_joints); }
};

struct Case {
  const char* name;
  std::shared_ptr<Character> character;
};

std::vector<Case> cases() {
  return {{"biped67", std::make_shared<Character>(scenes::biped(), 300)},
          {"tree1024", std::make_shared<Character>(scenes::wide_tree(1024), 120)},
          {"chain1024", std::make_shared<Character>(scenes::long_chain(1024), 120)}};
}

/// Times of steady play at 60 Hz, or of jumps all over the clip.
struct Times {
  bool forward;
  double duration_s, now_s = 0.0;

  double next() noexcept {
    now_s += forward ? 1.0 / 60.0 : 0.61803398874989485 * duration_s;
    if (now_s >= duration_s) now_s = std::fmod(now_s, duration_s);
    return now_s;
  }
};

/// `layer_count` layers of equal weight.
struct Layers {
  std::vector<test::PoseBuffer> poses;
  std::vector<BlendLayer> layers;
  std::vector<std::vector<glm_pose::Joint>> glm_layers;
  std::vector<float> weights;
  test::PoseBuffer rest, out;

  Layers(Character& c, std::size_t layer_count) : rest(c.skeleton.joint_count()), out(c.skeleton.joint_count()) {
    weights.assign(layer_count, 1.0f / static_cast<float>(layer_count));
    for (std::size_t l = 0; l < layer_count; ++l) {
      const double time_s = 0.3 + 0.37 * static_cast<double>(l);
      c.sample(time_s), c.sample_glm(time_s);
      poses.push_back(c.pose);
      glm_layers.push_back(c.glm_joints);
    }
    for (std::size_t l = 0; l < layer_count; ++l) layers.push_back({poses[l].span(), weights[l], {}});
  }
};

}  // namespace

void add_sample() {
  for (const Case& c : cases())
    for (const bool forward : {true, false}) {
      const std::string tail = std::string(c.name) + (forward ? "/forward" : "/seek");
      Times times{forward, c.character->animation.duration_s};
      const std::size_t joints = c.character->skeleton.joint_count();
      add("sample/sinew/" + tail, joints, [character = c.character, times]() mutable { character->sample(times.next()); });
      add("sample/glm/" + tail, joints, [character = c.character, times]() mutable { character->sample_glm(times.next()); });
    }
}

void add_blend() {
  for (const Case& c : cases())
    for (const std::size_t count : {std::size_t{2}, std::size_t{4}}) {
      const auto layers = std::make_shared<Layers>(*c.character, count);
      const std::size_t joints = c.character->skeleton.joint_count();
      const std::string tail = std::string(c.name) + "/" + std::to_string(count);
      add("blend/sinew/" + tail, joints, [layers] { run(BlendPosesJob{layers->layers, layers->rest.span(), layers->out.span()}); });
      add("blend/glm/" + tail, joints,
          [layers, character = c.character] { glm_pose::blend(layers->glm_layers, layers->weights, character->glm_joints); });
    }
}

void add_local_to_model() {
  for (const Case& c : cases()) {
    c.character->sample(0.4), c.character->sample_glm(0.4);
    const std::size_t joints = c.character->skeleton.joint_count();
    add(std::string("local_to_model/sinew/") + c.name, joints, [character = c.character] {
      run(LocalToModelJob{&character->skeleton, character->pose.span(), {}, character->model});
    });
    add(std::string("local_to_model/glm/") + c.name, joints, [character = c.character] {
      glm_pose::local_to_model(character->skeleton.parents, character->glm_joints, character->glm_model);
    });
  }
}

}  // namespace sinew::bench
