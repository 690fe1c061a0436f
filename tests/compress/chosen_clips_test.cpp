// SPDX-License-Identifier: MIT
// Which keys and which rounding the search takes, for scenes that ask different things of it. Many choices keep a
// budget; the search promises the smallest that it meets, so that a worse one shows only here. After a deliberate
// change:
//     SINEW_RECORD=1 build/release/bin/sinew-test-compress --gtest_filter='chosen_clips.*'
// writes tests/golden/chosen_clips.txt; bytes should not have grown.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <ios>
#include <sstream>

#include "runtime/base/bit_hash.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/pose/sample_clip.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr const char* kStored = SINEW_SOURCE_DIR "/tests/golden/chosen_clips.txt";

/// Smooth curves and noise of additions and products only: the same on every machine.
class Curves {
 public:
  Curves(std::uint64_t seed, double noise) : random_(seed), noise_(noise) {}

  float at(double t) {
    const double x = t - 2.0 * static_cast<double>(static_cast<int>(t / 2.0)) - 1.0;  // [-1, 1), period 2
    return static_cast<float>(x * (1.0 - x * x) + noise_ * random_.in(-1, 1));
  }
  glm::vec3 point(double t) {
    const float x = at(t), y = at(0.7 * t + 0.3), z = at(1.3 * t + 0.9);
    return {x, y, z};
  }
  glm::quat turn(double t) {
    const glm::vec3 v = point(t);
    return quat_cast<float>(normalised(quat_xyzw<double>(v.x, v.y, 0.5 * v.z, 1.0)));
  }

 private:
  test::FixedRandom random_;
  double noise_;
};

std::vector<float> evenly(std::size_t count) {
  std::vector<float> times_s;
  for (std::size_t k = 0; k < count; ++k) times_s.push_back(static_cast<float>(k) * 0.03125f);
  return times_s;
}

template <class V, class At>
Track<V> track_of(Interpolation interpolation, std::size_t keys, const At& at) {
  Track<V> track{interpolation, evenly(keys), {}};
  for (const float time_s : track.times_s) {
    const V value = at(static_cast<double>(time_s));
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(value * 0.25f);
    track.values.push_back(value);
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(value * 0.25f);
  }
  return track;
}

/// A tree of joints that turn, some of which move, stretch, step or hardly do anything.
Scene tree(std::uint64_t seed, double noise, Interpolation interpolation) {
  Scene scene;
  scene.skeleton = test::skeleton_of({kNone, 0, 0, 1, 2, 3, 4});
  for (std::uint32_t j = 1; j < 7; ++j) scene.skeleton.rest[j].translation = {0.05f, 0.3f, j % 2 == 0 ? -0.1f : 0.1f};
  Curves curves(seed, noise);
  std::vector<BoneAnimation> bones(7);
  for (std::uint32_t j = 0; j < 7; ++j) {
    bones[j].joint = j;
    const double slow = j == 4 ? 0.001 : 0.4 + 0.1 * j;
    bones[j].rotation = track_of<glm::quat>(interpolation, 70, [&](double t) { return curves.turn(slow * t + j); });
    if (j % 3 == 0)
      bones[j].translation = track_of<glm::vec3>(Interpolation::linear, 70, [&](double t) { return curves.point(t); });
    if (j % 3 == 1)
      bones[j].scale = track_of<glm::vec3>(j == 1 ? Interpolation::step : Interpolation::linear, 40,
                                           [&](double t) { return glm::vec3(1.0f) + 0.1f * curves.point(t); });
  }
  scene.animations.push_back(test::animation_of(std::move(bones)));
  finish_scene(scene);
  return scene;
}

/// The tree with three faces whose morph weights move: by many keys, by two, by bent curves and by a single key.
/// `scale` of the joint of the last ones stretches what wrong weights do.
Scene faces(std::uint64_t seed, double noise, float scale = 1.0f) {
  Scene scene = tree(seed, noise, Interpolation::linear);
  scene.skeleton.rest[6].scale = glm::vec3(scale);
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.primitives.resize(1);
  mesh.primitives[0].positions.assign(4, glm::vec3(0));
  mesh.default_weights.assign(3, 0.0f);
  mesh.primitives[0].morphs.targets.resize(3);
  mesh.primitives[0].morphs.targets[0].positions = {{1}, {{0, 0.2f, 0}}};
  mesh.primitives[0].morphs.targets[1].positions = {{2}, {{0.01f, 0, 0}}};
  mesh.primitives[0].morphs.targets[2].positions = {{3}, {{0, 0, 0.05f}}};
  for (const std::uint32_t joint : {5u, 6u, 6u})
    scene.instances.push_back({.joint = joint, .mesh = 0, .rest_weights = {0, 0, 0}});
  Curves curves(seed + 1, noise);
  const auto add = [&](std::uint32_t instance, Interpolation interpolation, std::size_t keys, std::uint32_t targets,
                       std::uint32_t first_target) {
    WeightAnimation& animated = scene.animations[0].weights.emplace_back();
    animated.instance = instance;
    animated.first_target = first_target;
    animated.weights = {interpolation, evenly(keys), {}, targets};
    for (std::size_t i = 0; i < test::value_count(interpolation, keys) * targets; ++i)
      animated.weights.values.push_back(curves.at(0.01 * static_cast<double>(i)));
  };
  add(0, Interpolation::linear, 50, 3, 0);
  add(1, Interpolation::linear, 2, 1, 0);
  add(1, Interpolation::cubic_spline, 20, 2, 1);
  add(2, Interpolation::linear, 1, 3, 0);
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

/// Keys in their authoring form.
std::uint64_t hash_of(const Animation& keys) {
  BitHash hash;
  const auto add = [&](const auto& track) { hash.add(std::span(track.times_s)).add(std::span(track.values)); };
  for (const BoneAnimation& bone : keys.bones) {
    add(bone.translation);
    add(bone.rotation);
    add(bone.scale);
  }
  for (const WeightAnimation& animated : keys.weights) add(animated.weights);
  return hash.value();
}

/// What the clip samples: shows how each track was rounded, however clips are stored.
std::uint64_t hash_of(const Scene& scene, const Clip& clip) {
  test::PoseBuffer pose(scene.skeleton.joint_count());
  std::vector<float> weights(scene.weight_count());
  std::vector<Transform> locals(scene.skeleton.joint_count());
  BitHash hash;
  for (int i = 0; i <= 40; ++i) {
    EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = 0.0546875 * i, .pose = pose.span(), .weights = weights}),
              ErrorCode::ok);
    for (std::size_t j = 0; j < locals.size(); ++j) locals[j] = pose.span().get(j);
    hash.add(std::span(locals)).add(std::span(weights));
  }
  return hash.value();
}

std::string chosen(const std::string& name, const Scene& scene, double budget_m) {
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), budget_m);
  const ClipCertificate& c = *within.clip.certificate();
  EXPECT_TRUE(c.is_met() || c.kept_keys == c.source_keys) << name;
  std::ostringstream out;
  out << name << ", within " << budget_m << ": " << c.kept_keys << " of " << c.source_keys << " keys, " << c.bytes
      << " of " << c.source_bytes << " bytes, " << c.measured_m / budget_m << " of the budget, " << std::hex
      << hash_of(within.keys) << " " << hash_of(scene, within.clip) << "\n";
  return out.str();
}

TEST(chosen_clips, the_search_takes_what_is_stored) {
  std::string text;
  for (const double budget_m : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    text += chosen("smooth tree", tree(1, 1e-6, Interpolation::linear), budget_m);
    text += chosen("noisy tree", tree(2, 1e-3, Interpolation::linear), budget_m);
    text += chosen("cubic tree", tree(3, 1e-4, Interpolation::cubic_spline), budget_m);
    text += chosen("faces", faces(4, 1e-4), budget_m);
    text += chosen("stretched faces", faces(5, 1e-3, 200.0f), budget_m);
  }
  if (std::getenv("SINEW_RECORD") != nullptr) std::ofstream(kStored) << text;
  std::ifstream in(kStored);
  std::ostringstream stored;
  stored << in.rdbuf();
  EXPECT_EQ(text, stored.str());
}

}  // namespace
}  // namespace sinew
