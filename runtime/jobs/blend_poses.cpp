// SPDX-License-Identifier: MIT
#include "runtime/jobs/blend_poses.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

/// Weights below this count as none: their products would be denormal numbers, a hundred times slower (N26).
constexpr float kSmallestWeight = 1e-20f;

float weight_of(const BlendLayer& layer, std::size_t j) noexcept {
  const float w = layer.joint_weights.empty() ? layer.weight : layer.weight * layer.joint_weights[j];
  return w < kSmallestWeight ? 0.0f : w;
}

/// What the layers do to one joint.
struct JointWeights {
  float sum = 0.0f;
  float largest = 0.0f;
  std::size_t pivot = 0;         ///< layer of the largest weight, the first on a tie
  std::size_t contributors = 0;
};

JointWeights weights_of_joint(std::span<const BlendLayer> layers, std::size_t j) noexcept {
  JointWeights found;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const float w = weight_of(layers[l], j);
    if (w == 0.0f) continue;
    found.sum += w;
    ++found.contributors;
    if (w > found.largest) found.largest = w, found.pivot = l;
  }
  return found;
}

/// Weighted sum of transforms, rotations turned to the side of `pivot`.
struct Accumulator {
  glm::vec3 translation{0.0f}, scale{0.0f};
  glm::quat rotation = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f);
  glm::quat pivot;

  void add(const Transform& t, float w) noexcept {
    translation += t.translation * w;
    scale += t.scale * w;
    rotation = rotation + aligned_with(pivot, t.rotation) * w;
  }
};

Transform blend_joint(const BlendPosesJob& job, std::size_t j) noexcept {
  const JointWeights weights = weights_of_joint(job.layers, j);
  const Transform rest = job.rest.get(j);
  const float rest_weight = std::max(1.0f - weights.sum, 0.0f);
  // Nothing to blend: the one transform that counts comes out bit for bit.
  if (weights.contributors == 0) return rest;
  const Transform heaviest = job.layers[weights.pivot].pose.get(j);
  if (weights.contributors == 1 && rest_weight < kSmallestWeight) return heaviest;

  Accumulator sum;
  sum.pivot = rest_weight > weights.largest ? rest.rotation : heaviest.rotation;
  for (const BlendLayer& layer : job.layers)
    if (const float w = weight_of(layer, j); w > 0.0f) sum.add(layer.pose.get(j), w);
  if (rest_weight > 0.0f) sum.add(rest, rest_weight);
  const float total = weights.sum + rest_weight;
  return {sum.translation / total, normalised_or(sum.rotation, sum.pivot), sum.scale / total};
}

bool is_weight(float w) noexcept { return std::isfinite(w) && w >= 0.0f; }

}  // namespace

ErrorCode check(const BlendPosesJob& job) noexcept {
  const std::size_t joints = job.pose.joint_count;
  const auto fits = [&](const PoseSpan& p) {
    return p.joint_count == joints && p.stride >= joints && (joints == 0 || p.planes != nullptr);
  };
  if (!fits(job.pose) || !fits(job.rest)) return ErrorCode::size_mismatch;
  for (const BlendLayer& layer : job.layers) {
    if (!fits(layer.pose)) return ErrorCode::size_mismatch;
    if (!layer.joint_weights.empty() && layer.joint_weights.size() != joints) return ErrorCode::size_mismatch;
    if (!is_weight(layer.weight)) return ErrorCode::not_finite;
    if (!std::all_of(layer.joint_weights.begin(), layer.joint_weights.end(), is_weight)) return ErrorCode::not_finite;
  }
  return ErrorCode::ok;
}

void run(const BlendPosesJob& job) noexcept {
  for (std::size_t j = 0; j < job.pose.joint_count; ++j) job.pose.set(j, blend_joint(job, j));
}

}  // namespace sinew
