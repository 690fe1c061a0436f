// SPDX-License-Identifier: MIT
#include "runtime/c/pose.h"

#include <algorithm>
#include <cmath>

#include "runtime/c/handles.h"
#include "runtime/c/pose_span.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"

using namespace sinew;

namespace {

static_assert(sizeof(sinew_transform) == 10 * sizeof(float));

bool is_finite(const sinew_transform& transform) noexcept {
  float numbers[10];
  c::copy_bits(transform, numbers);
  return std::all_of(std::begin(numbers), std::end(numbers), [](float number) { return std::isfinite(number); });
}

}  // namespace

std::size_t sinew_pose_floats(std::size_t joint_count) { return PoseSpan::floats_for(joint_count); }

sinew_error sinew_pose_get(const sinew_pose* pose, std::uint32_t joint, sinew_transform* out) {
  PoseSpan span;
  if (out == nullptr) return SINEW_NULL_ARGUMENT;
  if (const sinew_error error = c::read_pose(pose, span); error != SINEW_OK) return error;
  if (joint >= span.joint_count) return SINEW_INDEX_OUT_OF_RANGE;
  const auto [t, q, s] = span.get(joint);
  *out = {{t.x, t.y, t.z}, {q.x, q.y, q.z, q.w}, {s.x, s.y, s.z}};
  return SINEW_OK;
}

sinew_error sinew_pose_set(const sinew_pose* pose, std::uint32_t joint, const sinew_transform* transform) {
  PoseSpan span;
  if (transform == nullptr) return SINEW_NULL_ARGUMENT;
  if (const sinew_error error = c::read_pose(pose, span); error != SINEW_OK) return error;
  if (joint >= span.joint_count) return SINEW_INDEX_OUT_OF_RANGE;
  if (!is_finite(*transform)) return SINEW_NOT_FINITE;
  const auto& [t, q, s] = *transform;
  span.set(joint, {{t.x, t.y, t.z}, quat_xyzw(q.x, q.y, q.z, q.w), {s.x, s.y, s.z}});
  return SINEW_OK;
}

sinew_error sinew_pose_rest(const sinew_scene* scene, const sinew_pose* out) {
  if (scene == nullptr) return SINEW_NULL_ARGUMENT;
  const Skeleton& skeleton = scene->scene.skeleton;
  PoseSpan pose;
  if (const sinew_error error = c::read_pose(out, skeleton.joint_count(), pose); error != SINEW_OK) return error;
  for (std::size_t j = 0; j < pose.stride; ++j) pose.set(j, j < pose.joint_count ? skeleton.rest[j] : Transform{});
  return SINEW_OK;
}

sinew_error sinew_pose_sample(const sinew_scene* scene, std::uint32_t clip, double time_s, const sinew_pose* out) {
  if (scene == nullptr) return SINEW_NULL_ARGUMENT;
  const Scene& own = scene->scene;
  SampleClipJob job;
  if (const sinew_error error = c::read_pose(out, own.skeleton.joint_count(), job.pose); error != SINEW_OK)
    return error;
  if (clip >= own.clips.size()) return SINEW_INDEX_OUT_OF_RANGE;
  if (!std::isfinite(time_s)) return SINEW_NOT_FINITE;
  job.clip = &own.clips[clip];
  job.time_s = time_s;
  return c::run_job(job);
}

sinew_error sinew_pose_to_model(const sinew_scene* scene, const sinew_pose* pose, const sinew_affine* root,
                                sinew_affine* model, std::size_t capacity) {
  if (scene == nullptr || (model == nullptr && capacity > 0)) return SINEW_NULL_ARGUMENT;
  const Skeleton& skeleton = scene->scene.skeleton;
  LocalToModelJob job{.skeleton = &skeleton, .local = {}, .root = {}, .model = {}};
  if (const sinew_error error = c::read_pose(pose, skeleton.joint_count(), job.local); error != SINEW_OK) return error;
  if (capacity < skeleton.joint_count()) return SINEW_SIZE_MISMATCH;
  if (root != nullptr) c::copy_bits(*root, job.root);
  job.model = {reinterpret_cast<Affine*>(model), skeleton.joint_count()};
  return c::run_job(job);
}
