// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/pose/blend_poses.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/pose/numeric_jobs.h"
#include "tests/support/numeric_read.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

constexpr std::uint32_t kJoints = 21;  // equal ones, so that lanes are filled and a tail is left

/// The transform that all joints of a pose share.
Transform of_all(const PoseSpan& pose) {
  for (std::size_t j = 1; j < kJoints; ++j) EXPECT_EQ(pose.get(j), pose.get(0)) << "lane " << j;
  return pose.get(0);
}

/// The pose of a clip whose joints all hold these tracks.
Transform sample(const QuatTrack& rotation, const Vec3Track& translation, double time_s) {
  std::vector<BoneAnimation> bones(kJoints);
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    bones[j].joint = j;
    bones[j].rotation = rotation;
    bones[j].translation = translation;
  }
  const Clip clip = clip_of(animation_of(std::move(bones)), chain_skeleton(kJoints));
  PoseBuffer pose(kJoints);
  run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}});
  return of_all(pose.span());
}

Outcome slerp_of(const Json& in) {
  const QuatTrack track{Interpolation::linear, {0, 1}, {quat<float>(in["q"]), quat<float>(in["r"])}};
  return {{"q", numbers(sample(track, {}, scalar<double>(in["t"])).rotation)}};
}

/// A blend of two poses is nlerp: the second layer's weight is t, the first one's 1 - t.
Outcome nlerp_of(const Json& in) {
  PoseBuffer q(kJoints), r(kJoints), rest(kJoints), out(kJoints);
  for (std::size_t j = 0; j < kJoints; ++j) {
    q.span().set(j, {glm::vec3(0), quat<float>(in["q"]), glm::vec3(1)});
    r.span().set(j, {glm::vec3(0), quat<float>(in["r"]), glm::vec3(1)});
  }
  const float t = scalar<float>(in["t"]);
  const BlendLayer layers[] = {{q.span(), 1.0f - t, {}}, {r.span(), t, {}}};
  run_unchecked(BlendPosesJob{layers, rest.span(), out.span()});
  return {{"q", numbers(of_all(out.span()).rotation)}};
}

/// The rotation only: the control points are folded into the clip.
Outcome squad_of(const Json& in) {
  QuatTrack track{Interpolation::squad, {0, 1, 2, 3}, {}};
  for (const Json& key : in["keys"]) track.values.push_back(quat<float>(key));
  return {{"q", numbers(sample(track, {}, 1.0 + scalar<double>(in["t"])).rotation)}};
}

Outcome hermite_of(const Json& in) {
  const std::vector<float> times{scalar<float>(in["t0"]), scalar<float>(in["t1"])};
  const double t = scalar<double>(in["t"]);
  const auto keys = [&](auto read) {
    using V = decltype(read(in["v0"]));
    return Track<V>{
        Interpolation::cubic_spline,
        times,
        {V{} * 0.0f, read(in["v0"]), read(in["out_tangent0"]), read(in["in_tangent1"]), read(in["v1"]), V{} * 0.0f}};
  };
  if (in["op"] == "vec3") return {{"v", numbers(sample({}, keys(vec3<float>), t).translation)}};
  return {{"q", numbers(sample(keys(quat<float>), {}, t).rotation)}};
}

/// The last joint of a chain whose local transforms are the case's.
Outcome compose_of(const Json& in) {
  const Json locals = in["op"] == "trs" ? Json::array({in}) : in["locals"];
  const auto count = static_cast<std::uint32_t>(locals.size());
  const Skeleton skeleton = chain_skeleton(count);
  PoseBuffer pose(count);
  for (std::size_t j = 0; j < count; ++j)
    pose.span().set(j, {vec3<float>(locals[j]["t"]), quat<float>(locals[j]["q"]), vec3<float>(locals[j]["s"])});
  std::vector<Affine> model(count);
  run_unchecked(LocalToModelJob{&skeleton, pose.span(), {}, model});
  return {{"m", numbers(mat4_from_affine(model.back()))}};
}

}  // namespace

std::vector<NumericJob> pose_jobs() {
  return {{"slerp", slerp_of},
          {"nlerp", nlerp_of},
          {"squad", squad_of},
          {"hermite", hermite_of},
          {"trs_compose", compose_of}};
}

}  // namespace sinew::test
