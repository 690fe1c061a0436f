// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/math/slerp_arc.h"

namespace sinew {

inline Transformd in_double(const Transform& t) noexcept {
  return {Vec3<double>(t.translation), quat_cast<double>(t.rotation), Vec3<double>(t.scale)};
}

/// A pose in double precision, evaluated from the authoring form. It is the truth that compiled clips are compared
/// with.
struct TruthPose {
  std::vector<Transformd> local;  ///< [J] transforms relative to the parent joint
  std::vector<Affined> model;     ///< [J] model matrices
};

/// Local transforms and model matrices at one time. Joints without tracks have their rest transform.
/// cost O(tracks log keys + J), allocates if `out` is smaller than the skeleton
SINEW_API void evaluate_truth(const Animation& animation, const Skeleton& skeleton, double time_s, TruthPose& out);

/// Evaluates an animation at many times, most of them near the time before. The same bits as evaluate_truth(). It keeps
/// the place of each track, and the arc between the two keys of each rotation.
class SINEW_API TruthCursor {
 public:
  /// The arguments must outlive it, and the animation must stay as it is.
  TruthCursor(const Animation& animation, const Skeleton& skeleton);

  /// in   time_s  any;   local[J]
  void local_at(double time_s, std::span<Transformd> local);
  void evaluate(double time_s, TruthPose& out);

 private:
  struct Bone {
    std::size_t translation = 0, rotation = 0, scale = 0;              // the key at or before the last time
    std::optional<std::pair<std::size_t, SlerpArc<double>>> arc = {};  // the key that it begins at
  };
  static Quat<double> rotation_at(const QuatTrack& track, double time_s, Bone& bone) noexcept;

  const Animation& animation_;
  const Skeleton& skeleton_;
  std::vector<Bone> bones_;  // [animation.bones]
};

/// Computes the model matrices of a pose.
/// eq   M[j] = M[parent(j)] * T(j) * R(j) * S(j), or the joint's fixed matrix      out  model[J]
SINEW_API void model_from_local(const Skeleton& skeleton, std::span<const Transformd> local, std::span<Affined> model);

}  // namespace sinew
