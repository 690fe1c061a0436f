// SPDX-License-Identifier: MIT
#include <cmath>

#include "runtime/plan/run_plan.h"
#include "tests/bench/glm_pose.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"

namespace sinew::bench {
namespace {

constexpr double kStepS = 1.0 / 60.0;

/// A character of one skinned surface with normals, and two clips.
Scene character(Skeleton skeleton, std::uint32_t vertex_count) {
  Scene scene;
  scene.skins.push_back(scenes::skin_of_all_joints(skeleton));
  scene.meshes.push_back({"body", {scenes::skinned_surface(skeleton, vertex_count, 4)}, {}, {}});
  scene.meshes[0].primitives[0].tangents.clear();
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = 0, .rest_weights = {}});
  scene.animations.push_back(scenes::swinging(skeleton, 60));
  scene.animations.push_back(scenes::swinging(skeleton, 45));
  scene.skeleton = std::move(skeleton);
  finish_scene(scene);
  return scene;
}

double clip_time(const Scene& scene, std::uint32_t clip, double time_s) {
  return std::fmod(time_s, scene.animations[clip].duration_s);
}

/// One frame after the other through the plan.
struct PlannedFrames {
  const Scene& scene;
  Plan plan;
  FrameBuffer frame;
  double time_s = 0.0;

  explicit PlannedFrames(const Scene& shown) : scene(shown), plan(compile_plan(shown, {})), frame(plan) {}

  void next(std::uint32_t layer_count) {
    const ClipLayer layers[] = {{0, clip_time(scene, 0, time_s), layer_count == 1 ? 1.0f : 0.7f},
                                {1, clip_time(scene, 1, time_s), 0.3f}};
    const FrameInput input{.layers = std::span(layers, layer_count), .weights = {}, .root = {}};
    if (run_plan(plan, input, frame) != ErrorCode::ok) std::abort();
    time_s += kStepS;
  }
};

/// The same frames as plain GLM code: sample, blend, matrices, palette, skin.
struct PlainFrames {
  const Scene& scene;
  std::vector<glm_pose::Joint> pose;
  std::vector<std::vector<glm_pose::Joint>> layers;
  std::vector<glm::mat4> model, palette, inverse_bind;
  std::vector<glm::vec3> positions, normals;
  double time_s = 0.0;

  explicit PlainFrames(const Scene& shown)
      : scene(shown),
        pose(shown.skeleton.joint_count()),
        layers(2, pose),
        model(pose.size()),
        palette(shown.skins[0].joints.size()) {
    for (const Affine& m : scene.skins[0].inverse_bind) inverse_bind.push_back(mat4_from_affine(m));
    positions.resize(scene.meshes[0].primitives[0].vertex_count());
    normals.resize(positions.size());
  }

  void sample(std::uint32_t clip, std::span<glm_pose::Joint> out) {
    glm_pose::sample(scene.animations[clip], scene.skeleton.rest, static_cast<float>(clip_time(scene, clip, time_s)),
                     out);
  }
  void next(std::uint32_t layer_count) {
    if (layer_count == 1)
      sample(0, pose);
    else {
      const float weights[] = {0.7f, 0.3f};
      for (std::uint32_t l = 0; l < 2; ++l) sample(l, layers[l]);
      glm_pose::blend(layers, weights, pose);
    }
    glm_pose::local_to_model(scene.skeleton.parents, pose, model);
    const Skin& skin = scene.skins[0];
    for (std::size_t i = 0; i < palette.size(); ++i) palette[i] = model[skin.joints[i]] * inverse_bind[i];
    const Primitive& body = scene.meshes[0].primitives[0];
    glm_skin::skin_linear(body.influences, palette, {body.positions, body.normals, {}}, {positions, normals, {}},
                          {true, false});
    time_s += kStepS;
  }
};

/// Both sides of a pair must show the same frame.
void require_same(std::span<const glm::vec3> ours, std::span<const glm::vec3> plain) {
  for (std::size_t v = 0; v < plain.size(); ++v)
    if (!(glm::length(ours[v] - plain[v]) < 1e-4f)) std::abort();
}

void add_case(const std::shared_ptr<const Scene>& scene, std::uint32_t layer_count, const std::string& tail) {
  const auto planned = std::make_shared<PlannedFrames>(*scene);
  const auto plain = std::make_shared<PlainFrames>(*scene);
  planned->next(layer_count), plain->next(layer_count);
  require_same(planned->frame.result().primitives[0].positions, plain->positions);
  add("frame/sinew/" + tail, 1, [scene, planned, layer_count] { planned->next(layer_count); });
  add("frame/glm/" + tail, 1, [scene, plain, layer_count] { plain->next(layer_count); });
}

}  // namespace

void add_frame() {
  const auto biped = std::make_shared<const Scene>(character(scenes::biped(), 3'273));
  add_case(biped, 1, "biped/1layer/PN/4/3k");
  add_case(biped, 2, "biped/2layers/PN/4/3k");
  add_case(std::make_shared<const Scene>(character(scenes::biped(), 100'000)), 1, "biped/1layer/PN/4/100k");
}

}  // namespace sinew::bench
