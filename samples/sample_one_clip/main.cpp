// SPDX-License-Identifier: MIT
// The whole idea in one page: an arm of three joints, one animation, and the place of every joint at some time.
//
//   authoring form (BoneAnimation)  --compile_clip-->  Clip  --sample_clip-->  local pose  --local_to_model--> matrices
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>

#include <sinew/animation.h>
#include <sinew/clip.h>
#include <sinew/pose_jobs.h>
#include <glm/vec3.hpp>

namespace {

using namespace sinew;

constexpr std::size_t kJoints = 3;
constexpr const char* kNames[kJoints] = {"shoulder", "elbow", "hand"};

/// Parents come before their children. A joint's rest transform is relative to its parent.
Skeleton make_arm() {
  Skeleton arm;
  arm.parents = {kNone, 0, 1};
  arm.rest = {{}, {.translation = {0.0f, 1.0f, 0.0f}}, {.translation = {0.0f, 1.0f, 0.0f}}};
  arm.fixed_matrix_of = {kNone, kNone, kNone};  // no joint is given as a matrix
  arm.names = {kNames[0], kNames[1], kNames[2]};
  arm.node_of_joint = arm.joint_of_node = {0, 1, 2};
  arm.level_begin = {0, 1, 2, 3};
  return arm;
}

Quat<float> turn_about_z(float angle_rad) {
  return quat_xyzw(0.0f, 0.0f, std::sin(angle_rad / 2), std::cos(angle_rad / 2));
}

/// The elbow bends by a quarter turn within one second and straightens again within the next.
Result<Animation> make_wave() {
  constexpr float kQuarterTurn = 1.57079633f;
  std::array<Keyframe, 3> keys;
  for (std::size_t k = 0; k < keys.size(); ++k)
    keys[k] = {.time_s = static_cast<double>(k), .translation = {0.0f, 1.0f, 0.0f}};
  keys[1].rotation = turn_about_z(kQuarterTurn);
  auto elbow = BoneAnimation::from_keyframes(1, keys);
  if (!elbow) return tl::unexpected(elbow.error());
  Animation wave;
  wave.name = "wave";
  wave.duration_s = elbow->end_time();
  wave.bones.push_back(std::move(*elbow));
  return wave;
}

std::optional<double> parse_seconds(const char* text) {
  double time_s = 0.0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, time_s);
  return error == std::errc{} && stop == end && std::isfinite(time_s) ? std::optional(time_s) : std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<double> time_s = argc < 2 ? 0.5 : parse_seconds(argv[1]);
  if (argc > 2 || !time_s) {
    std::fprintf(stderr, "usage: sample_one_clip [SECONDS]\n");
    return 2;
  }

  const Skeleton arm = make_arm();
  const Result<Animation> wave = make_wave();
  if (!wave) {
    std::fprintf(stderr, "%s\n", describe(wave.error()).data());
    return 1;
  }
  const Clip clip = compile_clip(*wave, arm, {}, {});

  // Buffers belong to the caller. A job is a struct of views: run() does the work, or returns why the views do not fit.
  alignas(64) std::array<float, PoseSpan::floats_for(kJoints)> pose_memory{};
  std::array<Affine, kJoints> world{};
  const PoseSpan pose = pose_over(pose_memory, kJoints);

  const SampleClipJob sample{.clip = &clip, .time_s = *time_s, .pose = pose, .weights = {}};
  const LocalToModelJob to_model{.skeleton = &arm, .local = pose, .root = {}, .model = world};
  for (const ErrorCode code : {run(sample), run(to_model)})
    if (code != ErrorCode::ok) {
      std::fprintf(stderr, "%s\n", describe(code).data());
      return 1;
    }

  std::printf("\"%s\" at %g s of %g s\n", clip.name().c_str(), *time_s, clip.duration_s());
  for (std::size_t j = 0; j < kJoints; ++j) {
    const Vec3<float> at = translation_of(world[j]);
    std::printf("  %-8s %9.6f %9.6f %9.6f m\n", kNames[j], at.x, at.y, at.z);
  }

  // The authoring form, evaluated in double, is the truth. The fast path is compared with it.
  const Transformd elbow = wave->bones[0].interpolate<double>(*time_s);
  const Affined hand = affine_from_transform(elbow) * affine_from_transform(Transformd{.translation = {0.0, 1.0, 0.0}});
  const double off_m = glm::length(translation_of(hand) - Vec3<double>(translation_of(world[2])));
  std::printf("  the hand is %.1e m from the truth\n", off_m);
  return off_m < 1e-5 ? 0 : 1;
}
