// SPDX-License-Identifier: MIT
// The promise of a budget for any valid animation. It is checked at keys, just before and after them and between them,
// by an evaluation that shares no code with the compiler.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "runtime/compress/compile_clip_within.h"
#include "tests/reference/clip_error.h"

namespace sinew {
namespace {

constexpr Interpolation kPlayed[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline};

/// A random walk of keys, like captured motion; `wild` keys jump anywhere.
std::vector<float> keys_of(test::FixedRandom& random, std::size_t count, bool even) {
  if (!even) return test::random_times(random, count, random.below(3));
  std::vector<float> times_s;
  for (std::size_t k = 0; k < count; ++k) times_s.push_back(static_cast<float>(k) / 30.0f);
  return times_s;
}

QuatTrack turning(test::FixedRandom& random, Interpolation interpolation, const std::vector<float>& times_s,
                  double step_rad) {
  QuatTrack track{interpolation, times_s, {}};
  Quat<double> q = random.rotation<double>();
  for (std::size_t k = 0; k < times_s.size(); ++k) {
    q = normalised(q * random.rotation_by<double>(random.in(0, step_rad)));
    const Quat<float> tangent =
        quat_cast<float>(quat_xyzw(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)) * 0.1);
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(tangent);
    track.values.push_back(
        quat_cast<float>(random.below(4) == 0 && interpolation != Interpolation::cubic_spline ? -q : q));
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(tangent);
  }
  return track;
}

Vec3Track moving(test::FixedRandom& random, Interpolation interpolation, const std::vector<float>& times_s, double step,
                 glm::vec3 from) {
  Vec3Track track{interpolation, times_s, {}};
  for (std::size_t k = 0; k < times_s.size(); ++k) {
    from += random.vec3(-step, step);
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(random.vec3(-step, step));
    track.values.push_back(from);
    if (interpolation == Interpolation::cubic_spline) track.values.push_back(random.vec3(-step, step));
  }
  return track;
}

Scene any_scene(test::FixedRandom& random) {
  Scene scene;
  const std::uint32_t joints = 1 + random.below(9);
  std::vector<std::uint32_t> parents{kNone};
  for (std::uint32_t j = 1; j < joints; ++j)
    parents.push_back(parents.back() == kNone ? 0 : std::min(j - 1, parents.back() + random.below(2)));
  scene.skeleton = test::skeleton_of(std::move(parents));
  for (Transform& rest : scene.skeleton.rest) rest = {random.vec3(-0.4, 0.4), random.rotation(), random.vec3(0.5, 1.5)};
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < joints; ++j) {
    BoneAnimation& bone = bones.emplace_back();
    bone.joint = j;
    const auto times_s = keys_of(random, 1 + random.below(40), random.below(2) == 0);
    const double lively = std::pow(10.0, random.in(-4, 0));
    if (random.below(4) != 0) bone.rotation = turning(random, kPlayed[random.below(3)], times_s, lively);
    if (random.below(2) != 0)
      bone.translation =
          moving(random, kPlayed[random.below(3)], times_s, 0.3 * lively, scene.skeleton.rest[j].translation);
    if (random.below(4) == 0)
      bone.scale = moving(random, kPlayed[random.below(3)], times_s, 0.1 * lively, glm::vec3(1));
  }
  scene.animations.push_back(test::animation_of(std::move(bones)));
  finish_scene(scene);
  return scene;
}

std::vector<double> fine_grid(const Animation& animation) {
  std::vector<double> times_s;
  for (const BoneAnimation& bone : animation.bones)
    for (const auto* keys : {&bone.rotation.times_s, &bone.translation.times_s, &bone.scale.times_s})
      for (const float t : *keys)
        for (const double near : {-1e-4, 0.0, 1e-4}) times_s.push_back(static_cast<double>(t) + near);
  for (int i = 0; i <= 150; ++i) times_s.push_back(animation.duration_s * (i + 0.31) / 150.0);
  return times_s;
}

RC_GTEST_PROP(budget_properties, no_virtual_vertex_is_ever_farther_off_than_the_budget, (std::uint64_t seed)) {
  test::FixedRandom random(seed);
  const Scene scene = any_scene(random);
  const Animation& truth = scene.animations[0];
  const VirtualVertices vertices = virtual_vertices(scene);
  const double budget_m = std::pow(10.0, random.in(-4, -1));
  const ClipWithin within = compile_clip_within(scene, truth, vertices, budget_m);
  const ClipCertificate& certificate = *within.clip.certificate();
  RC_ASSERT(certificate.asked_m == budget_m);
  RC_ASSERT(certificate.is_met() || certificate.kept_keys == certificate.source_keys);
  RC_TAG(certificate.is_met() ? "met" : "kept whole");
  if (!certificate.is_met()) return;
  double largest_m = 0.0, at_s = 0.0;
  for (const double time_s : fine_grid(truth))
    for (const auto error : reference::joint_errors(scene.skeleton, truth, vertices.boxes, within.clip, time_s))
      if (static_cast<double>(error) > largest_m) {
        largest_m = static_cast<double>(error);
        at_s = time_s;
      }
  RC_LOG() << largest_m / budget_m << " of the budget at " << at_s << " s, " << certificate.measured_m / budget_m
           << " measured, at " << certificate.worst_time_s << " s" << std::endl;
  RC_ASSERT(largest_m <= budget_m);
}

}  // namespace
}  // namespace sinew
