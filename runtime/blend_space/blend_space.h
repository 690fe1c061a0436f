// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// Rule by which a place in the space becomes weights of the points.
enum class BlendSpaceKind : std::uint8_t {
  line,         ///< linear between neighbours along x; y is ignored
  cartesian,    ///< gradient bands (Johansen 2009, chapter 6)
  directional,  ///< gradient bands in polar form: points are velocities, compared by speed and direction
  radial,       ///< radial basis functions of the distance: no triangles and no bands, smooth between points
};

/// Largest number of points in a space.
inline constexpr std::size_t kMostBlendPoints = 64;

/// Points that stand for motions (for example their velocities), and numbers precomputed from the points.
/// owns  nothing: views of the caller's memory
struct BlendSpace {
  BlendSpaceKind kind = BlendSpaceKind::line;
  std::span<const glm::vec2> points;
  std::span<const double> numbers;  ///< filled by prepare_blend_space
  float angle_factor = 1.0f;        ///< directional: a radian counts as this many speed differences of the mean speed
};

/// Length of BlendSpace::numbers for a space with this number of points.
SINEW_API std::size_t blend_space_numbers(BlendSpaceKind kind, std::size_t points) noexcept;

/// Computes the numbers of a space. Points may lie anywhere: on a line, at the origin, several at the same place.
/// in   points  [1, kMostBlendPoints]
/// err  size_mismatch (no points, too many, wrong length of `numbers`), not_finite, too_large (above 1e9),
///      not_a_fraction (angle_factor <= 0)
/// cost O(points^2), radial O(points^3); cartesian and radial allocate
SINEW_API ErrorCode prepare_blend_space(BlendSpaceKind kind, std::span<const glm::vec2> points, float angle_factor,
                                        std::span<double> numbers);

/// Weights of the points at a place. Each point has weight 1 at its own place; points at the same place share it
/// equally.
/// eq   line        linear between the next points on both sides, constant outside
///      cartesian   h_i = min over j of clamp(1 - (p - p_i).(p_j - p_i) / |p_j - p_i|^2, 0, 1);  w_i = h_i / sum h
///      directional the same with differences (2 (|a| - |b|) / (|p_i| + |p_j|), factor * angle between a and b). The
///      origin has no direction: in a pair with a point there, the angle is that between the other point and the place.
///      Near the origin, within a quarter of the smallest speed, angles shrink to 0, so weights are continuous there.
///      radial      w = A^-1 (d, 1), d_i = |p - p_i|, A = (D 1; 1 0), D_ij = |p_i - p_j|;  negative weights become 0,
///      then all are divided by their sum
/// in   space  prepared;   x, y  finite
/// out  weights  [points] sum to 1
/// cost O(points^2), line O(points); no allocation
SINEW_API void blend_space_weights(const BlendSpace& space, float x, float y, std::span<float> weights) noexcept;

}  // namespace sinew
