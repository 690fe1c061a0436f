// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>

#include "runtime/plan/run_plan.h"
#include "tests/bench/clip_characters.h"
#include "tests/bench/glm_pose.h"
#include "tests/bench/glm_skin.h"
#include "tests/bench/measure.h"
#include "tests/plan/slow_frame.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/swinging.h"

namespace sinew::bench {
namespace {

constexpr double kStepS = 1.0 / 60.0;

/// A character with one skinned surface with normals, and two clips.
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

/// Successive frames, run by the plan.
struct PlannedFrames {
  const Scene& scene;
  Plan plan;
  FrameBuffer frame;
  double time_s = 0.0;

  PlannedFrames(const Scene& shown, const Needs& needs)
      : scene(shown), plan(compile_plan(lend(shown), needs)), frame(plan) {}

  FrameInput input(std::uint32_t layer_count) {
    layers_[0] = {0, clip_time(scene, 0, time_s), layer_count == 1 ? 1.0f : 0.7f};
    if (layer_count > 1) layers_[1] = {1, clip_time(scene, 1, time_s), 0.3f};
    return {.layers = std::span(layers_, layer_count), .weights = {}, .root = {}};
  }
  void next(std::uint32_t layer_count) {
    if (run_plan(plan, input(layer_count), frame) != ErrorCode::ok) std::abort();
    time_s += kStepS;
  }

 private:
  ClipLayer layers_[2];
};

/// Same frames in plain GLM code: sample, blend, matrices, palette, skin.
struct PlainFrames {
  struct Skinned {
    const Primitive* primitive;
    std::size_t skin;
    std::vector<glm::vec3> positions, normals;
  };
  const Scene& scene;
  bool normals;
  std::vector<glm_pose::Joint> pose;
  std::vector<std::vector<glm_pose::Joint>> layers;
  std::vector<glm::mat4> model;
  std::vector<std::vector<glm::mat4>> palettes, inverse_binds;
  std::vector<Skinned> skinned;
  double time_s = 0.0;

  PlainFrames(const Scene& shown, const Needs& needs)
      : scene(shown),
        normals(needs.out.normals),
        pose(shown.skeleton.joint_count()),
        layers(2, pose),
        model(pose.size()) {
    for (const Skin& skin : scene.skins) {
      palettes.emplace_back(skin.joints.size());
      inverse_binds.emplace_back();
      for (const Affine& m : skin.inverse_bind) inverse_binds.back().push_back(mat4_from_affine(m));
    }
    for (const MeshInstance& instance : scene.instances)
      for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
        if (instance.skin != kNone && !primitive.influences.empty())
          skinned.push_back({&primitive, instance.skin, std::vector<glm::vec3>(primitive.vertex_count()),
                             std::vector<glm::vec3>(primitive.vertex_count())});
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
    glm_pose::local_to_model(scene.skeleton, pose, model);
    for (std::size_t s = 0; s < palettes.size(); ++s)
      for (std::size_t i = 0; i < palettes[s].size(); ++i)
        palettes[s][i] = model[scene.skins[s].joints[i]] * inverse_binds[s][i];
    for (Skinned& s : skinned) {
      const bool with_normals = normals && !s.primitive->normals.empty();
      const std::span<const glm::vec3> in_normals =
          with_normals ? std::span<const glm::vec3>(s.primitive->normals) : std::span<const glm::vec3>();
      glm_skin::skin_linear(s.primitive->influences, palettes[s.skin], {s.primitive->positions, in_normals, {}},
                            {s.positions, s.normals, {}}, {with_normals, false});
    }
    time_s += kStepS;
  }
};

/// Largest distance of a deformed vertex from the evaluation in double precision, relative to the size of the frame.
double error_of(const FrameResult& frame, const test::SlowFrame& truth) {
  double worst = 0.0, size = 1e-9;
  for (std::size_t p = 0; p < frame.primitives.size(); ++p)
    for (std::size_t v = 0; v < frame.primitives[p].positions.size(); ++v) {
      const Vec3<double>& t = truth.primitives[p].positions[v];
      worst = std::max(worst, glm::length(Vec3<double>(frame.primitives[p].positions[v]) - t));
      size = std::max({size, std::abs(t.x), std::abs(t.y), std::abs(t.z)});
    }
  return worst / size;
}

/// Fails unless both implementations show the same frame.
void require_same(const FrameResult& ours, const PlainFrames& plain) {
  std::size_t next = 0;
  for (const DeformedPrimitive& p : ours.primitives) {
    if (p.positions.empty()) continue;
    const std::vector<glm::vec3>& others = plain.skinned.at(next++).positions;
    float size = 1.0f;
    for (const glm::vec3& v : others) size = std::max(size, glm::length(v));
    for (std::size_t v = 0; v < others.size(); ++v)
      if (!(glm::length(p.positions[v] - others[v]) < 1e-4f * size)) std::abort();
  }
}

void add_case(const std::shared_ptr<const Scene>& scene, const Needs& needs, std::uint32_t layer_count,
              const std::string& tail) {
  const auto planned = std::make_shared<PlannedFrames>(*scene, needs);
  const auto plain = std::make_shared<PlainFrames>(*scene, needs);
  const test::SlowFrame truth = test::evaluate_slowly(*scene, needs, planned->input(layer_count));
  planned->next(layer_count);
  plain->next(layer_count);
  require_same(planned->frame.result(), *plain);
  const Facts facts{error_of(planned->frame.result(), truth), 0};
  add(
      "frame/sinew/" + tail, 1, [scene, planned, layer_count] { planned->next(layer_count); }, facts);
  add("frame/glm/" + tail, 1, [scene, plain, layer_count] { plain->next(layer_count); });
}

/// A crowd whose vertices fit into no cache; each character runs one frame in turn.
struct FrameCrowd {
  static constexpr std::size_t kCount = 512;
  const Plan plan;
  const double duration_s;
  std::vector<FrameBuffer> frames;
  std::vector<PlainFrames> plain;
  double time_s = 0.0;

  FrameCrowd(const Scene& scene, const Needs& needs)
      : plan(compile_plan(lend(scene), needs)),
        duration_s(scene.animations[0].duration_s),
        plain(kCount, PlainFrames(scene, needs)) {
    for (std::size_t c = 0; c < kCount; ++c) frames.emplace_back(plan);
  }

  void next(bool past_caches) {
    time_s += kStepS;
    for (std::size_t c = 0; c < kCount; ++c) {
      if (c + 1 < kCount) frames[c + 1].prefetch();
      frames[c].write_past_caches(past_caches);
      const ClipLayer layer{0, std::fmod(time_s + 0.013 * static_cast<double>(c), duration_s)};
      if (run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frames[c]) != ErrorCode::ok) std::abort();
    }
  }
  void next_plain() {
    for (PlainFrames& character : plain) character.next(1);
  }
};

void add_crowd_of_frames(const std::shared_ptr<const Scene>& scene, const Needs& needs, const std::string& tail) {
  const auto crowd = std::make_shared<FrameCrowd>(*scene, needs);
  add("frame/sinew/" + tail, FrameCrowd::kCount, [scene, crowd] { crowd->next(true); });
  add("frame/through_caches/" + tail, FrameCrowd::kCount, [scene, crowd] { crowd->next(false); });
  add("frame/glm/" + tail, FrameCrowd::kCount, [scene, crowd] { crowd->next_plain(); });
}

/// Poses and palettes for engines that skin elsewhere: with all joints, and with a skeleton LOD of the first
/// half of the joints. A third case interpolates between two earlier poses.
void add_levels(const std::shared_ptr<const Scene>& scene, const std::string& name) {
  Needs needs;
  needs.out.positions = needs.out.normals = needs.out.tangents = needs.out.local_pose = false;
  needs.out.palettes = true;
  const auto add_level = [&](const std::string& level, const Needs& of_level) {
    const auto frames = std::make_shared<PlannedFrames>(*scene, of_level);
    add("pose/sinew/" + name + "/" + level, 1, [scene, frames] { frames->next(1); });
  };
  add_level("all", needs);
  Needs fewer = needs;
  const std::size_t joints = scene->skeleton.joint_count();
  for (std::size_t j = 0; j < joints; ++j)
    fewer.out.skeleton_lod.kept.push_back(2 * j < joints);  // drops the deeper half
  add_level("half", fewer);
  needs.in.between_updates = true;
  const auto between = std::make_shared<PlannedFrames>(*scene, needs);
  add("pose/sinew/" + name + "/between", 1, [scene, between, step = 0]() mutable {
    const ClipLayer start{0, 0.1}, end{0, 0.2};
    step = (step + 1) % 1000;
    const FrameInput input{.layers = {&start, 1},
                           .weights = {},
                           .root = {},
                           .next_layers = {&end, 1},
                           .interpolation_factor = 0.0005f + 0.001f * static_cast<float>(step)};
    if (run_plan(between->plan, input, between->frame) != ErrorCode::ok) std::abort();
  });
}

/// True if a mesh has no normals in its file. The plain version makes no flat normals, so both sides then leave out
/// normals.
bool has_flat_normals(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives)
      if (primitive.flat_normals) return true;
  return false;
}

bool morphs(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    if (mesh.target_count() > 0) return true;
  return false;
}

}  // namespace

void add_frame(std::size_t most_vertices) {
  const auto biped = std::make_shared<const Scene>(character(scenes::biped(), 3'273));
  Needs needs;
  needs.out.tangents = needs.out.local_pose = false;
  add_case(biped, needs, 1, "biped/1layer/PN/4/3k");
  add_case(biped, needs, 2, "biped/2layers/PN/4/3k");
  add_levels(biped, "biped");
  if (most_vertices >= 100'000) {
    add_case(std::make_shared<const Scene>(character(scenes::biped(), 100'000)), needs, 1, "biped/1layer/PN/4/100k");
    add_crowd_of_frames(biped, needs, "biped/512characters/PN/4/3k");
  }
  for (const NamedScene& model : corpus_scenes()) {
    if (morphs(*model.scene)) continue;
    Needs file_needs = needs;
    file_needs.out.normals = !has_flat_normals(*model.scene);
    add_levels(model.scene, model.name);
    add_case(model.scene, file_needs, 1, model.name + "/1layer/" + (file_needs.out.normals ? "PN" : "P"));
  }
}

}  // namespace sinew::bench
