// SPDX-License-Identifier: MIT
#include "runtime/lod/pose_drift.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

constexpr double kCubic = 1.64;  // the Lebesgue constant of four even places is 1.631
constexpr double kBent = 2.0, kMuch = 0.5;
constexpr double kAnyRotation = 2.0;  // no rotation moves a unit vector farther

double largest(const Vec3<double>& v) noexcept { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// eq   |R(q) - R(r)| = 2 sin(angle / 2), computed from the difference of the quaternions to avoid cancellation
double rotation_between_m(const Quat<double>& q, const Quat<double>& r) noexcept {
  const double side = quat_dot(q, r) < 0.0 ? -1.0 : 1.0;
  const double x = q.x - side * r.x, y = q.y - side * r.y, z = q.z - side * r.z, w = q.w - side * r.w;
  const double chord = std::sqrt(x * x + y * y + z * z + w * w);             // 2 sin(angle / 4)
  return 2.0 * chord * std::sqrt(std::max(0.0, 1.0 - chord * chord / 4.0));  // 2 * 2 sin(angle / 4) cos(angle / 4)
}

}  // namespace

PoseDrift::PoseDrift(const Skeleton& skeleton, const Animation& animation)
    : skeleton_(skeleton),
      cursor_(animation, skeleton),
      cubic_vectors_(skeleton.joint_count()),
      bent_rotations_(skeleton.joint_count()),
      drifts_(skeleton.joint_count()) {
  for (std::vector<Transformd>& place : places_) place.resize(skeleton.joint_count());
  const auto is_bent = [](Interpolation kind) {
    return kind == Interpolation::cubic_spline || kind == Interpolation::squad;
  };
  for (const BoneAnimation& bone : animation.bones) {
    if (is_bent(bone.translation.interpolation) || is_bent(bone.scale.interpolation)) cubic_vectors_[bone.joint] = true;
    if (is_bent(bone.rotation.interpolation)) bent_rotations_[bone.joint] = true;
  }
}

PoseDrift::Stray PoseDrift::stray_of(std::size_t joint) const noexcept {
  Stray stray;
  const Transformd& middle = middle_.local[joint];
  for (const std::vector<Transformd>& place : places_) {
    const Transformd& there = place[joint];
    stray.translation = std::max(stray.translation, safe_length(there.translation - middle.translation));
    stray.rotation = std::max(stray.rotation, rotation_between_m(there.rotation, middle.rotation));
    stray.scale = std::max(stray.scale, largest(there.scale - middle.scale));
  }
  if (cubic_vectors_[joint]) {
    stray.translation *= kCubic;
    stray.scale *= kCubic * std::sqrt(3.0);
  }
  if (bent_rotations_[joint]) stray.rotation = stray.rotation > kMuch ? kAnyRotation : kBent * stray.rotation;
  return stray;
}

void PoseDrift::bound_interval(double begin_s, double end_s) {
  const double length_s = end_s - begin_s;
  cursor_.evaluate(begin_s + 0.5 * length_s, middle_);
  for (int i = 0; i < 4; ++i) cursor_.local_at(i == 3 ? end_s : begin_s + length_s * i / 3.0, places_[i]);
  for (std::size_t j = 0; j < drifts_.size(); ++j) {
    const std::uint32_t parent = skeleton_.parents[j], fixed = skeleton_.fixed_matrix_of[j];
    const Drift above = parent == kNone ? Drift{} : drifts_[parent];
    const double stretch = parent == kNone ? 1.0 : largest_stretch(middle_.model[parent]);
    if (fixed != kNone) {
      const Affined matrix = affine_cast<double>(skeleton_.fixed_matrices[fixed]);
      drifts_[j] = {above.fixed_m + above.per_metre * safe_length(translation_of(matrix)),
                    above.per_metre * largest_stretch(matrix)};
      continue;
    }
    const Stray stray = stray_of(j);
    const Transformd& middle = middle_.local[j];
    const double farthest = safe_length(middle.translation) + stray.translation,
                 scale = largest(middle.scale) + stray.scale;
    drifts_[j] = {above.fixed_m + above.per_metre * farthest + stretch * stray.translation,
                  above.per_metre * scale + stretch * (stray.rotation * scale + stray.scale)};
  }
}

}  // namespace sinew
