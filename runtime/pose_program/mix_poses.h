// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/math/negligible.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Weight of the upper pose in a mix, per joint or per number. Internal to pose_program/.
struct MixShare {
  float weight = 1.0f;
  std::span<const float> mask;  ///< [joints or numbers] or empty

  float of(std::size_t i) const noexcept {
    const float share = mask.empty() ? weight : weight * mask[i];
    return share < 1.0f ? share : 1.0f;
  }
};

/// Morph weights or properties of one operand of a mean.
struct NumberLayer {
  std::span<const float> numbers;
  float weight = 1.0f;
  std::span<const float> mask;  ///< [numbers] or empty

  float of(std::size_t i) const noexcept { return mask.empty() ? weight : weight * mask[i]; }
};

/// Weighted mean of numbers that have masks.
/// eq   as blend_weights, with w[l] mask[l][i] in place of w[l]
/// in   layer(l)  the NumberLayer of operand l < layers;   out  may be the numbers of any layer
template <class Layer>
void blend_masked_numbers(std::size_t layers, const Layer& layer, std::span<const float> rest,
                          std::span<float> out) noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0.0, total = 0.0;
    for (std::size_t l = 0; l < layers; ++l) {
      const NumberLayer from = layer(l);
      const double w = static_cast<double>(from.of(i));
      sum += w * static_cast<double>(from.numbers[i]);
      total += w;
    }
    const double rest_share = std::max(0.0, 1.0 - total);
    out[i] = flushed(static_cast<float>((sum + rest_share * static_cast<double>(rest[i])) / (total + rest_share)));
  }
}

/// eq   below[i] = (1 - w) below[i] + w above[i], w of the share; the bits of above[i] at w = 1
void mix_numbers(std::span<const float> above, const MixShare& share, std::span<float> below) noexcept;

/// Mixes two local transforms.
/// eq   t = (1 - w) t_below + w t_above, s likewise; q = normalise((1 - w) q_below +- w q_above), the sign by
///      hemisphere.
///      At w = 0 the result has the bits of `below`, at w = 1 those of `above`.
Transform mixed(const Transform& below, const Transform& above, float w) noexcept;

/// Lays `above` over `below`, joint by joint in local space.
/// out  below  in place
void overlay_pose(const PoseSpan& above, const MixShare& share, const PoseSpan& below) noexcept;

/// As overlay_pose, but rotations are mixed in model space. Joints with share 0 below joints with a share keep their
/// local rotation of `below`. Joints with share 1 get the model rotation of `above`.
/// eq   G = slerp(G_below, G_above, w) along the short arc, G the rotation in model space; q = conj(G_parent) G
/// in   skeleton  parents before children;   rotations[3 J]  scratch
/// out  below  in place
void overlay_pose_in_model_space(const Skeleton& skeleton, const PoseSpan& above, const MixShare& share,
                                 std::span<glm::quat> rotations, const PoseSpan& below) noexcept;

}  // namespace sinew
