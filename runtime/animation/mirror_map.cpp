// SPDX-License-Identifier: MIT
#include "runtime/animation/mirror_map.h"

#include <cmath>

#include "runtime/animation/mirror_pairs.h"
#include "runtime/math/matrix_rotation.h"

namespace sinew {
namespace {

/// C_j of mirror_map.h: maps the mirrored axes of a joint to the axes of its partner.
struct MirroredAxes {
  Quat<double> rotation;  ///< of -C
  Mat3<double> matrix;    ///< C
};

Mat3<double> rounded(const Mat3<double>& m) noexcept {
  Mat3<double> r;
  for (int c = 0; c < 3; ++c) r[c] = glm::round(m[c]);
  return r;
}

/// True if the rounded matrix maps axes onto axes, and differs by no more than the tolerance from the exact rotation.
bool maps_axes(const Mat3<double>& rounded, const Quat<double>& rotation, double tolerance_rad) noexcept {
  const Mat3<double> square = rounded * glm::transpose(rounded);
  if (square != Mat3<double>(1.0) || glm::determinant(rounded) > 0.0) return false;
  return rotation_angle_between(quat_from_matrix(-rounded), rotation) <= tolerance_rad;
}

MirroredAxes axes_of(Quat<double> rotation, double tolerance_rad) noexcept {
  const Mat3<double> matrix = -matrix_from_unit_quat(rotation), exact = rounded(matrix);
  if (!maps_axes(exact, rotation, tolerance_rad)) return {rotation, matrix};
  return {aligned_with(rotation, quat_from_matrix(-exact)), exact};
}

Quat<double> pure_quaternion(const Vec3<double>& v) noexcept { return quat_xyzw(v.x, v.y, v.z, 0.0); }

/// [J] The map C of each joint (mirror_map.h).
std::vector<MirroredAxes> mirrored_axes(const ReferencePose& reference, const JointPairs& pairs, double tolerance_rad) {
  const Quat<double> normal = pure_quaternion(pairs.normal);
  std::vector<MirroredAxes> axes(pairs.partner.size());
  for (std::uint32_t j = 0; j < axes.size(); ++j) {
    const std::uint32_t p = pairs.partner[j];
    if (p < j) {
      axes[j] = {-quat_conjugate(axes[p].rotation), glm::transpose(axes[p].matrix)};
      continue;
    }
    Quat<double> rotation = normalised(quat_conjugate(reference.rotation[p]) * normal * reference.rotation[j]);
    if (p == j) rotation = normalised(pure_quaternion({rotation.x, rotation.y, rotation.z}));
    axes[j] = axes_of(rotation, tolerance_rad);
  }
  return axes;
}

/// Rounds entries that are 0, 1 or -1 within the rounding of doubles.
double without_rounding(double entry) noexcept {
  constexpr double kRounding = 1e-12;
  const double whole = std::round(entry);
  return std::abs(entry - whole) <= kRounding ? whole : entry;
}

template <std::size_t kCount>
void clean(std::array<MirrorRow<kCount>, kCount>& rows) noexcept {
  for (MirrorRow<kCount>& row : rows)
    for (double& entry : row) entry = without_rounding(entry);
}

/// eq   sets the rows of the linear map q -> c_parent q c_joint^-1
void set_rotation(const Quat<double>& of_parent, const Quat<double>& of_joint, MirroredJoint& to) noexcept {
  for (std::size_t k = 0; k < 4; ++k) {
    const auto unit = [&](std::size_t i) { return i == k ? 1.0 : 0.0; };
    const Quat<double> column = of_parent * quat_xyzw(unit(0), unit(1), unit(2), unit(3)) * quat_conjugate(of_joint);
    to.rotation[0][k] = column.x;
    to.rotation[1][k] = column.y;
    to.rotation[2][k] = column.z;
    to.rotation[3][k] = column.w;
  }
  clean(to.rotation);
}

/// in   tolerance  a length in the space of the joint's parent
void set_translation(const Mat3<double>& of_parent, const Vec3<double>& from, const Vec3<double>& own, double tolerance,
                     MirroredJoint& to) noexcept {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      to.translation[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = of_parent[c][r];
  clean(to.translation);
  to.offset = own - of_parent * from;
  if (safe_length(to.offset) <= tolerance) to.offset = Vec3<double>(0.0);
}

void set_scale(const Mat3<double>& of_joint, const Vec3<double>& from, const Vec3<double>& own, double tolerance,
               MirroredJoint& to) noexcept {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double share = of_joint[c][r] * of_joint[c][r];
      const double ratio = from[c] != 0.0 ? own[r] / from[c] : 1.0;
      const bool is_even = std::abs(ratio - 1.0) <= tolerance;
      to.scale[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = is_even ? share : share * ratio;
    }
  clean(to.scale);
}

/// Factor from lengths in the space of a joint to lengths in model space.
double scale_of(const Affined& model) noexcept {
  const double volume = std::abs(determinant(model));
  return volume > 0.0 ? std::cbrt(volume) : 1.0;
}

}  // namespace

std::size_t paired_joints(const MirrorMap& map) noexcept {
  std::size_t count = 0;
  for (std::size_t j = 0; j < map.joints.size(); ++j) count += map.joints[j].source != j;
  return count;
}

MirrorMap make_mirror_map(const Skeleton& skeleton, const MirrorOptions& options) {
  const ReferencePose reference = reference_pose(skeleton, options.reference);
  JointPairs pairs = pair_joints(skeleton, reference, options);
  const std::vector<MirroredAxes> axes = mirrored_axes(reference, pairs, options.angle_tolerance_rad);
  const MirroredAxes above = axes_of(pure_quaternion(pairs.normal), options.angle_tolerance_rad);
  MirrorMap map;
  map.plane_normal = glm::vec3(pairs.normal);
  map.plane_offset = static_cast<float>(pairs.offset);
  for (std::uint32_t p = 0; p < pairs.partner.size(); ++p) {
    MirroredJoint& joint = map.joints.emplace_back();
    const std::uint32_t j = joint.source = pairs.partner[p], parent = skeleton.parents[j];
    if (pairs.keeps_own[p]) continue;
    const MirroredAxes& of_parent = parent == kNone ? above : axes[parent];
    const Transformd &from = reference.local[j], &own = reference.local[p];
    const double longer = parent == kNone ? 1.0 : scale_of(reference.model[parent]);
    set_rotation(of_parent.rotation, axes[j].rotation, joint);
    set_translation(of_parent.matrix, from.translation, own.translation,
                    options.length_tolerance * reference.size / longer, joint);
    set_scale(axes[j].matrix, from.scale, own.scale, options.length_tolerance, joint);
  }
  map.reference = is_rest_pose(skeleton, options.reference) ? PoseReference::rest : PoseReference::given;
  map.unpaired = std::move(pairs.unpaired);
  return map;
}

}  // namespace sinew
