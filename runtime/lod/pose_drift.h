// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/animation/truth_pose.h"

namespace sinew {

/// How far points attached to a joint can move from their places at the middle of a time interval.
struct Drift {
  double fixed_m = 0.0;    ///< movement of the joint's origin
  double per_metre = 0.0;  ///< added for each metre of distance from the origin, in the joint's space
};

/// Bounds the movement of all joints within a time interval. No track may have a key inside the interval, so every
/// track is a single curve there.
/// eq   M = M[parent] L:  |M(t) p - M(m) p| <= E[parent](|L(t) p|) + |M(m)[parent]| (dT + (dR s + dS) |p|)
///      E(r) = fixed + per_metre r, m is the middle of the interval, s is the largest scale. dT, dR and dS bound the
///      change of the joint's own translation, rotation (as a matrix) and scale.
///      A cubic moves at most 1.64 times as far as it does at four evenly spaced times (their Lebesgue constant).
///      For a rotation curve that is no arc, the bound is twice the movement at those times. Where they show a large
///      movement, it is the bound for any rotation.
class PoseDrift {
 public:
  PoseDrift(const Skeleton& skeleton, const Animation& animation);

  /// Evaluates the interval [begin_s, end_s].    cost O(5 poses)
  void bound_interval(double begin_s, double end_s);

  /// [J] Model matrices at the middle of the interval.
  std::span<const Affined> middle() const noexcept { return middle_.model; }
  /// [J]
  std::span<const Drift> drifts() const noexcept { return drifts_; }

 private:
  struct Stray {
    double translation = 0.0, rotation = 0.0, scale = 0.0;
  };
  Stray stray_of(std::size_t joint) const noexcept;

  const Skeleton& skeleton_;
  TruthCursor cursor_;
  // [J] a translation or scale track of the joint is cubic; its rotation curve is no arc
  std::vector<bool> cubic_vectors_, bent_rotations_;
  TruthPose middle_;
  std::vector<Transformd> places_[4];  // [J] local transforms at four even times
  std::vector<Drift> drifts_;
};

}  // namespace sinew
