// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/pose/sample_clip.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// Events and curves of every type, within 4 s.
inline Annotations varied_annotations() {
  Annotations notes;
  notes.add_event(3.0, "left foot");
  notes.add_event(0.25, "right foot");
  notes.add_event(3.0, "");
  notes.curves = {
      {"width", CurveBlend::sum,
       std::vector<CurveKey<float>>{{0.5f, CurveStep::cubic, 1.0f, 0.0f, 2.0f},
                                    {2.0f, CurveStep::hold, 4.0f, 8.0f, 0.0f}}},
      {"place", CurveBlend::mean, std::vector<CurveKey<glm::vec2>>{{0.0f, CurveStep::linear, {1, 2}}}},
      {"colour", CurveBlend::heaviest, std::vector<CurveKey<glm::vec3>>{{0.0f, CurveStep::linear, {1, 2, 3}}}},
      {"plane", CurveBlend::mean, std::vector<CurveKey<glm::vec4>>{{1.0f, CurveStep::hold, {1, 2, 3, 4}}}},
      {"aim", CurveBlend::mean,
       std::vector<CurveKey<glm::quat>>{{1.0f, CurveStep::linear, glm::quat(0.6f, 0.8f, 0, 0)}}},
      {"open", CurveBlend::mean, std::vector<CurveKey<bool>>{{1.0f, CurveStep::hold, true}}}};
  return notes;
}

/// A clip with morph weights, rotation tracks of mixed interpolations, and linear and cubic translation tracks. Some
/// tracks are packed, others are in full float. Scale and properties have no tracks.
inline Clip varied_clip(std::uint64_t seed) {
  constexpr std::uint32_t kJoints = 21;
  FixedRandom random(seed);
  const Interpolation kinds[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline,
                                 Interpolation::squad};
  const auto times = random_times(random, 7), other = random_times(random, 5, 1);
  Animation animation;
  KeyTolerances rounding;
  for (std::uint32_t j = 0; j < kJoints; j += 1 + random.below(2)) {
    BoneAnimation bone;
    bone.joint = j;
    if (j % 5 != 0) bone.rotation = random_rotations(random, kinds[j % 4], j % 2 ? times : other);
    if (j % 3 != 0) bone.translation = random_vectors(random, kinds[j % 3], times);
    animation.bones.push_back(bone);
    rounding.bones.push_back({j % 2 ? 1e-2 : 0.0, j % 2 ? 1e-2 : 0.0, 0.0});
  }
  animation.weights.push_back({0, random_weights(random, Interpolation::linear, times, 3), 0});
  rounding.weights.push_back({1e-3, 1e-3, 1e-3});
  animation.annotations = varied_annotations();
  animation.name = "varied";
  animation.duration_s = 4.0;
  Skeleton skeleton = chain_skeleton(kJoints);
  for (Transform& rest : skeleton.rest) rest = random.transform();
  const std::vector<float> rest_weights{0.1f, 0.2f, 0.3f, 0.4f};
  const std::vector<std::uint32_t> first{0, 4};
  ClipCertificate certificate;
  certificate.asked_m = 1e-4;
  certificate.measured_m = 9e-5;
  certificate.worst_joint = 3;
  certificate.bytes = 77;
  return with_certificate(compile_clip(animation, skeleton, rest_weights, first, {}, rounding), certificate);
}

/// All values of the clip's poses at times before, in and after it.
inline std::vector<float> samples_of(const Clip& clip) {
  std::vector<float> numbers;
  PoseBuffer pose(clip.joint_count());
  std::vector<float> weights(clip.weight_count());
  for (double t = -0.5; t < 5; t += 0.037) {
    run_unchecked(SampleClipJob{.clip = &clip, .time_s = t, .pose = pose.span(), .weights = weights});
    for (std::size_t p = 0; p < PoseSpan::plane_count; ++p)
      numbers.insert(numbers.end(), pose.span().plane(PoseSpan::Plane(p)),
                     pose.span().plane(PoseSpan::Plane(p)) + clip.joint_count());
    numbers.insert(numbers.end(), weights.begin(), weights.end());
  }
  return numbers;
}

}  // namespace sinew::test
