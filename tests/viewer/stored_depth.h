// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew::viewer {

/// The arithmetic of shaders/projection.glsl between distance and stored depth, for any depth mapping, in C++.
/// eq   depth = a + b / distance
template <class T>
struct DepthTermsT {
  T a, b;
};

/// Terms of a perspective matrix of viewer/passes/projection.h.
template <class T>
DepthTermsT<T> depth_terms(const Mat4<T>& clip_from_view) noexcept {
  return {clip_from_view[2][2] * clip_from_view[2][3], clip_from_view[3][2]};
}

/// eq   depth = (a d + b) / d: one division, so that near and far come out exactly
template <class T>
T depth_from_distance(const DepthTermsT<T>& terms, T distance_m) noexcept {
  return (terms.a * distance_m + terms.b) / distance_m;
}

/// Distance in front of the eye plane. The background of an infinite projection (depth = a) is at infinity: mask it.
/// eq   d = b / (depth - a)
template <class T>
T distance_from_depth(const DepthTermsT<T>& terms, T depth) noexcept {
  return terms.b / (depth - terms.a);
}

}  // namespace sinew::viewer
