// SPDX-License-Identifier: MIT
#include "runtime/c/pose.h"

#include <algorithm>
#include <cmath>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/handles.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"

using namespace sinew;

namespace {

static_assert(sizeof(sinew_transform) == 10 * sizeof(float));

bool is_finite(const sinew_transform& transform) noexcept {
  float numbers[10];
  c::copy_bytes(transform, numbers);
  return std::all_of(std::begin(numbers), std::end(numbers), [](float number) { return std::isfinite(number); });
}

/// Runs `body` with a pose that has as many joints as the scene.
sinew_error with_pose(const sinew_scene* scene, const sinew_pose* given, auto&& body) noexcept {
  return c::call(c::given(scene, given), [&] {
    PoseSpan pose;
    if (const sinew_error error = c::from_c(*given, pose)) return error;
    if (pose.joint_count != scene->scene.skeleton.joint_count()) return SINEW_SIZE_MISMATCH;
    return body(scene->scene, pose);
  });
}

}  // namespace

std::size_t sinew_pose_floats(std::size_t joint_count) { return PoseSpan::floats_for(joint_count); }

sinew_error sinew_pose_get(const sinew_pose* pose, std::uint32_t joint, sinew_transform* out) {
  return c::call(c::given(pose, out), [&] {
    PoseSpan span;
    if (const sinew_error error = c::from_c(*pose, span)) return error;
    if (joint >= span.joint_count) return SINEW_INDEX_OUT_OF_RANGE;
    const auto [t, q, s] = span.get(joint);
    *out = {{t.x, t.y, t.z}, {q.x, q.y, q.z, q.w}, {s.x, s.y, s.z}};
    return SINEW_OK;
  });
}

sinew_error sinew_pose_set(const sinew_pose* pose, std::uint32_t joint, const sinew_transform* transform) {
  return c::call(c::given(pose, transform), [&] {
    PoseSpan span;
    if (const sinew_error error = c::from_c(*pose, span)) return error;
    if (joint >= span.joint_count) return SINEW_INDEX_OUT_OF_RANGE;
    if (!is_finite(*transform)) return SINEW_NOT_FINITE;
    const auto& [t, q, s] = *transform;
    span.set(joint, {{t.x, t.y, t.z}, quat_xyzw(q.x, q.y, q.z, q.w), {s.x, s.y, s.z}});
    return SINEW_OK;
  });
}

sinew_error sinew_pose_rest(const sinew_scene* scene, const sinew_pose* out) {
  return with_pose(scene, out, [](const Scene& own, const PoseSpan& pose) {
    const std::vector<Transform>& rest = own.skeleton.rest;
    for (std::size_t j = 0; j < pose.stride; ++j) pose.set(j, j < pose.joint_count ? rest[j] : Transform{});
    return SINEW_OK;
  });
}

sinew_error sinew_pose_sample(const sinew_scene* scene, std::uint32_t clip, double time_s, const sinew_pose* out) {
  return with_pose(scene, out, [&](const Scene& own, const PoseSpan& pose) {
    if (clip >= own.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
    if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
    SampleClipJob job;
    job.clip = &own.clips[clip];
    job.time_s = time_s;
    job.pose = pose;
    return c::error_from(run(job));
  });
}

sinew_error sinew_pose_to_model(const sinew_scene* scene, const sinew_pose* pose, const sinew_affine* root,
                                sinew_affine* model, std::size_t capacity) {
  if (!c::given(c::Array{model, capacity})) return SINEW_NULL_ARGUMENT;
  return with_pose(scene, pose, [&](const Scene& own, const PoseSpan& local) {
    const std::size_t joint_count = own.skeleton.joint_count();
    if (capacity < joint_count) return SINEW_SIZE_MISMATCH;
    LocalToModelJob job{.skeleton = &own.skeleton, .local = local, .root = {}, .model = {}};
    if (root != nullptr) c::copy_bytes(*root, job.root);
    job.model = {reinterpret_cast<Affine*>(model), joint_count};
    return c::error_from(run(job));
  });
}
