// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/animation/truth_pose.h"

namespace sinew {

/// How far points that hang on a joint can stray from where they are at the middle of a piece of time.
struct Drift {
  double fixed_m = 0.0;    ///< of the joint's origin
  double per_metre = 0.0;  ///< more for each metre from the origin, in the joint's space
};

/// Bounds the movement of all joints within a piece of time. No track has a key inside the piece, so every track is one
/// curve there.
/// eq   M = M[parent] L:  |M(t) p - M(m) p| <= E[parent](|L(t) p|) + |M(m)[parent]| (dT + (dR s + dS) |p|),
///      E(r) = fixed + per_metre r;  s is the largest scale; dT, dR, dS are how far the joint's own translation,
///      rotation (as a matrix) and scale stray. A cubic strays at most 1.64 times as far as it does at four even places
///      (their Lebesgue constant). A rotation along a curve that is no arc is taken for twice what those places show,
///      and for any rotation where they show much.
class PoseDrift {
 public:
  PoseDrift(const Skeleton& skeleton, const Animation& animation);

  /// Looks at the piece [begin_s, end_s].    cost O(5 poses)
  void look_at(double begin_s, double end_s);

  /// [J] model matrices at the middle of the piece.
  std::span<const Affined> middle() const noexcept { return middle_.model; }
  /// [J]
  std::span<const Drift> drifts() const noexcept { return drifts_; }

 private:
  struct Stray {
    double translation = 0.0, rotation = 0.0, scale = 0.0;
  };
  Stray stray_of(std::size_t joint) const noexcept;

  const Skeleton& skeleton_;
  const Animation& animation_;
  std::vector<bool> cubic_vectors_, bent_rotations_;  // [J]
  TruthPose middle_, places_[4];
  std::vector<Drift> drifts_;
};

}  // namespace sinew
