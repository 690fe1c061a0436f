// SPDX-License-Identifier: MIT
// Cross-fading: the local poses of two clips are blended joint by joint, then made into matrices once. A last blend
// takes the hip from one clip and the foot from the other, with a weight per joint.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>

#include <sinew/animation.h>
#include <sinew/clip.h>
#include <sinew/pose_jobs.h>

namespace {

using namespace sinew;

constexpr std::size_t kJoints = 2;
using PoseFloats = std::array<float, PoseSpan::floats_for(kJoints)>;

Skeleton make_leg() {
  Skeleton leg;
  leg.parents = {kNone, 0};
  leg.rest = {{}, {.translation = {0.0f, -1.0f, 0.0f}}};
  leg.fixed_matrix_of = {kNone, kNone};
  leg.names = {"hip", "foot"};
  leg.node_of_joint = leg.joint_of_node = {0, 1};
  leg.level_begin = {0, 1, 2};
  return leg;
}

/// The hip swings to `angle_rad` and back within two seconds; the foot lifts by `lift_m` meanwhile.
Result<Animation> make_swing(const char* name, float angle_rad, float lift_m) {
  std::array<Keyframe, 3> hip_keys, foot_keys;
  for (std::size_t k = 0; k < 3; ++k) {
    hip_keys[k].time_s = foot_keys[k].time_s = static_cast<double>(k);
    foot_keys[k].translation = {0.0f, k == 1 ? -1.0f + lift_m : -1.0f, 0.0f};
  }
  hip_keys[1].rotation = quat_xyzw(0.0f, 0.0f, std::sin(angle_rad / 2), std::cos(angle_rad / 2));
  Animation swing;
  swing.name = name;
  for (auto bone : {BoneAnimation::from_keyframes(0, hip_keys), BoneAnimation::from_keyframes(1, foot_keys)}) {
    if (!bone) return tl::unexpected(bone.error());
    swing.duration_s = std::fmax(swing.duration_s, bone->end_time());
    swing.bones.push_back(std::move(*bone));
  }
  return swing;
}

std::optional<float> parse_weight(const char* text) {
  float weight = 0.0f;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, weight);
  return error == std::errc{} && stop == end && weight >= 0.0f && weight <= 1.0f ? std::optional(weight) : std::nullopt;
}

/// Ends the program with the code's sentence, unless it is ok.
void require(ErrorCode code) {
  if (code == ErrorCode::ok) return;
  std::fprintf(stderr, "%s\n", describe(code).data());
  std::exit(1);
}

/// Blends the layers and returns the place of the foot.
Vec3<float> foot_after(const Skeleton& leg, std::span<const BlendLayer> layers, PoseSpan rest) {
  alignas(64) PoseFloats memory{};
  std::array<Affine, kJoints> world{};
  const PoseSpan mixed = pose_over(memory, kJoints);
  const BlendPosesJob blend{.layers = layers, .rest = rest, .pose = mixed};
  const LocalToModelJob to_model{.skeleton = &leg, .local = mixed, .root = {}, .model = world};
  require(run(blend));
  require(run(to_model));
  return translation_of(world[1]);
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<float> weight = argc < 2 ? 0.5f : parse_weight(argv[1]);
  if (argc > 2 || !weight) {
    std::fprintf(stderr, "usage: blend_two_clips [WEIGHT of the run, 0 to 1]\n");
    return 2;
  }

  const Skeleton leg = make_leg();
  const auto walk = make_swing("walk", 0.4f, 0.1f), dash = make_swing("run", 1.2f, 0.4f);
  if (!walk || !dash) {
    std::fprintf(stderr, "the keys are refused\n");
    return 1;
  }
  const Clip clips[] = {compile_clip(*walk, leg, {}, {}), compile_clip(*dash, leg, {}, {})};

  alignas(64) PoseFloats memory[3]{};
  const PoseSpan poses[] = {pose_over(memory[0], kJoints), pose_over(memory[1], kJoints)};
  const PoseSpan rest = pose_over(memory[2], kJoints);
  for (std::size_t j = 0; j < kJoints; ++j) rest.set(j, leg.rest[j]);
  for (std::size_t c = 0; c < 2; ++c)
    require(run(SampleClipJob{.clip = &clips[c], .time_s = 1.0, .pose = poses[c], .weights = {}}));

  const BlendLayer only_walk[] = {{.pose = poses[0], .weight = 1.0f, .joint_weights = {}}};
  const BlendLayer only_run[] = {{.pose = poses[1], .weight = 1.0f, .joint_weights = {}}};
  const BlendLayer both[] = {{.pose = poses[0], .weight = 1.0f - *weight, .joint_weights = {}},
                             {.pose = poses[1], .weight = *weight, .joint_weights = {}}};
  constexpr float kHipOnly[kJoints] = {1.0f, 0.0f}, kFootOnly[kJoints] = {0.0f, 1.0f};
  const BlendLayer masked[] = {{.pose = poses[0], .weight = 1.0f, .joint_weights = kFootOnly},
                               {.pose = poses[1], .weight = 1.0f, .joint_weights = kHipOnly}};

  const struct {
    const char* what;
    std::span<const BlendLayer> layers;
  } rows[] = {
      {"walk alone", only_walk}, {"run alone", only_run}, {"cross-fade", both}, {"run's hip, walk's foot", masked}};
  double reach_m[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<float> foot = foot_after(leg, rows[i].layers, rest);
    reach_m[i] = std::hypot(foot.x, foot.y);
    std::printf("  %-24s foot at %9.6f %9.6f m, %.6f m from the hip\n", rows[i].what, foot.x, foot.y, reach_m[i]);
  }
  // Translations blend linearly, and so does the length of the leg.
  const double expected_m = (1.0 - *weight) * reach_m[0] + *weight * reach_m[1];
  return std::fabs(reach_m[2] - expected_m) < 1e-5 ? 0 : 1;
}
