// SPDX-License-Identifier: MIT
#include "importer/python/module/evaluate.h"

#include <cmath>
#include <string>

#include "importer/python/module/errors.h"
#include "importer/python/module/parallel_frames.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose/sample_clip.h"

namespace sinew::python {
namespace {

/// Writes N planes as an array [joint, N].
template <std::size_t N>
void interleave(const PoseSpan& pose, PoseSpan::Plane first, float* __restrict to) {
  const float* planes[N];
  for (std::size_t c = 0; c < N; ++c) planes[c] = pose.plane(static_cast<PoseSpan::Plane>(first + c));
  for (std::size_t j = 0; j < pose.joint_count; ++j, to += N)
    for (std::size_t c = 0; c < N; ++c) to[c] = planes[c][j];
}

/// The inverse of interleave().
template <std::size_t N>
void spread(const float* __restrict from, PoseSpan::Plane first, const PoseSpan& pose) {
  float* planes[N];
  for (std::size_t c = 0; c < N; ++c) planes[c] = pose.plane(static_cast<PoseSpan::Plane>(first + c));
  for (std::size_t j = 0; j < pose.joint_count; ++j, from += N)
    for (std::size_t c = 0; c < N; ++c) planes[c][j] = from[c];
}

/// Writes a pose as a row of the arrays.
void store(const PoseSpan& pose, std::size_t frame, PoseArrays& out) {
  const std::size_t row = frame * pose.joint_count;
  interleave<3>(pose, PoseSpan::tx, out.translations.data() + row * 3);
  interleave<4>(pose, PoseSpan::rx, out.rotations.data() + row * 4);
  interleave<3>(pose, PoseSpan::sx, out.scales.data() + row * 3);
}

void fill_with_rest(const Skeleton& skeleton, const PoseSpan& pose) {
  for (std::size_t j = 0; j < skeleton.rest.size(); ++j) pose.set(j, skeleton.rest[j]);
}

}  // namespace

void load_pose(const PoseViews& poses, std::size_t frame, const PoseSpan& pose) {
  const std::size_t row = frame * poses.joints;
  spread<3>(poses.translations + row * 3, PoseSpan::tx, pose);
  spread<4>(poses.rotations + row * 4, PoseSpan::rx, pose);
  spread<3>(poses.scales + row * 3, PoseSpan::sx, pose);
}

PoseArrays::PoseArrays(std::size_t frames, std::size_t joints, std::size_t weight_count)
    : translations({frames, joints, 3}),
      rotations({frames, joints, 4}),
      scales({frames, joints, 3}),
      weights({frames, weight_count}) {}

PoseArrays sample_clip(const ClipHandle& clip, std::span<const double> times_s, std::size_t threads) {
  for (std::size_t f = 0; f < times_s.size(); ++f)
    require(std::isfinite(times_s[f]), "times[" + std::to_string(f) + "] is not a finite number");
  const std::size_t weights = clip.clip.weight_count();
  PoseArrays out(times_s.size(), clip.clip.joint_count(), weights);
  parallel_frames(times_s.size(), threads, [&](std::size_t first, std::size_t last) {
    PoseMemory memory(clip.clip.joint_count());
    for (std::size_t f = first; f < last; ++f) {
      const SampleClipJob job{.clip = &clip.clip,
                              .time_s = times_s[f],
                              .pose = memory.span(),
                              .weights = {out.weights.data() + f * weights, weights},
                              .holds_clip = f > first};
      require_ok(run(job), "sample");
      store(memory.span(), f, out);
    }
  });
  return out;
}

ArrayMemory<float> world_matrices(const Scene& scene, const PoseViews& poses, std::size_t threads) {
  ArrayMemory<float> out({poses.frames, poses.joints, 4, 4});
  parallel_frames(poses.frames, threads, [&](std::size_t first, std::size_t last) {
    PoseMemory memory(poses.joints);
    std::vector<Affine> model(poses.joints);
    for (std::size_t f = first; f < last; ++f) {
      load_pose(poses, f, memory.span());
      require_ok(run(LocalToModelJob{&scene.skeleton, memory.span(), {}, model}), "world_matrices");
      float* to = out.data() + f * poses.joints * 16;
      for (const Affine& matrix : model) {
        const glm::mat4 columns = mat4_from_affine(matrix);
        for (int row = 0; row < 4; ++row)
          for (int column = 0; column < 4; ++column) *to++ = columns[column][row];
      }
    }
  });
  return out;
}

PoseArrays blend(const Scene& scene, std::span<const PoseViews> poses, std::span<const float> weights) {
  const PoseViews& like = poses.front();
  PoseArrays out(like.frames, like.joints, like.weights);
  std::vector<PoseMemory> memory(poses.size(), PoseMemory(like.joints));
  PoseMemory rest(like.joints), mean(like.joints);
  fill_with_rest(scene.skeleton, rest.span());
  std::vector<BlendLayer> layers(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) layers[i] = {memory[i].span(), weights[i], {}};
  const std::vector<float> rest_weights = rest_weights_of(scene);
  std::vector<float> others((poses.size() - 1) * like.weights);
  for (std::size_t f = 0; f < like.frames; ++f) {
    for (std::size_t i = 0; i < poses.size(); ++i) load_pose(poses[i], f, memory[i].span());
    require_ok(run(BlendPosesJob{layers, rest.span(), mean.span()}), "blend");
    store(mean.span(), f, out);
    float* const blended = out.weights.data() + f * like.weights;
    for (std::size_t i = 0; i < poses.size(); ++i)
      std::copy_n(poses[i].morph_weights + f * like.weights, like.weights,
                  i == 0 ? blended : others.data() + (i - 1) * like.weights);
    blend_weights(layers, rest_weights, {blended, like.weights}, others);
  }
  return out;
}

}  // namespace sinew::python
