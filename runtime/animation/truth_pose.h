// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/math/quaternion.h"

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

/// Computes the model matrices of a pose.
/// eq   M[j] = M[parent(j)] * T(j) * R(j) * S(j), or the joint's fixed matrix      out  model[J]
SINEW_API void model_from_local(const Skeleton& skeleton, std::span<const Transformd> local, std::span<Affined> model);

}  // namespace sinew
