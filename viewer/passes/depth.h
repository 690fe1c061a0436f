// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/projection.h"

namespace sinew {

/// The two numbers of a perspective matrix that make depth from distance: depth = a + b / distance.
template <class T>
struct DepthTermsT {
  T a, b;
};

/// Terms of a matrix by with_depth or with_infinite_depth.
template <class T>
DepthTermsT<T> depth_terms(const Mat4<T>& clip_from_view) noexcept {
  return {clip_from_view[2][2] * clip_from_view[2][3], clip_from_view[3][2]};
}

/// eq   depth = (a d + b) / d: one division, so that near and far come out exactly
template <class T>
T depth_from_distance(const DepthTermsT<T>& terms, T distance_m) noexcept {
  return (terms.a * distance_m + terms.b) / distance_m;
}

/// Distance in front of the eye plane (-z of view space when looking along -z) of a stored depth.
/// eq   d = b / (depth - a).  The background of an infinite projection (depth = a) is at infinity: callers mask it
///      (N30).
template <class T>
T distance_from_depth(const DepthTermsT<T>& terms, T depth) noexcept {
  return terms.b / (depth - terms.a);
}

/// Logarithmic depth: equal relative resolution everywhere, 0 at near and 1 at far.
/// eq   log(d / near) / log(far / near)
template <class T>
T logarithmic_depth(T distance_m, T near_m, T far_m) noexcept {
  return std::log(distance_m / near_m) / std::log(far_m / near_m);
}

/// eq   d = near (far / near)^depth
template <class T>
T distance_from_logarithmic_depth(T depth, T near_m, T far_m) noexcept {
  return near_m * std::pow(far_m / near_m, depth);
}

}  // namespace sinew
