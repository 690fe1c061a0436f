// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/animation/pose_reference.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"

namespace sinew {

/// One row of a linear map. A row with a single nonzero entry, 1 or -1, copies or negates a number exactly.
template <std::size_t kCount>
using MirrorRow = std::array<double, kCount>;

/// The linear maps that give the mirrored local transform of one joint from that of its partner.
struct MirroredJoint {
  std::uint32_t source = 0;  ///< its partner, or the joint itself if it lies on the plane or has no partner
  /// Rows for x y z w
  std::array<MirrorRow<4>, 4> rotation = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  std::array<MirrorRow<3>, 3> translation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3<double> offset{0.0};  ///< added to the translation
  std::array<MirrorRow<3>, 3> scale = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// How poses, clips and morph weights of one skeleton are mirrored. make_mirror_map makes it; it never changes
/// afterwards.
struct MirrorMap {
  glm::vec3 plane_normal{1.0f, 0.0f, 0.0f};  ///< unit, in model space
  float plane_offset = 0.0f;                 ///< distance of the plane from the origin, along the normal
  std::vector<MirroredJoint> joints;         ///< [J] the map of each joint
  std::vector<std::uint32_t> unpaired;  ///< rising; joints without a partner that should have one by name or position
  PoseReference reference = PoseReference::rest;  ///< mirroring keeps this pose as it is
  std::vector<std::uint32_t> weight_source;  ///< [W] the morph weight that each weight takes its mirrored value from;
                                             ///< empty = weights do not change
};

/// Number of joints whose partner is another joint.
SINEW_API std::size_t paired_joints(const MirrorMap& map) noexcept;

/// Overrides for what make_mirror_map would find by itself.
struct MirrorOptions {
  std::optional<glm::vec3> plane_normal;            ///< model space; nullopt = found from the joints, mostly +X
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< partners; a pair {j, j} makes j its own partner
  /// [J] local transforms of a symmetric pose. Needed if the rest pose is not symmetric, for example because it was
  /// exported from the middle of a walk. Empty = the rest pose, or what make_mirror_map of a scene chooses
  /// (model/mirror_scene.h).
  std::span<const Transform> reference = {};
  double angle_tolerance_rad = 1e-4;  ///< axes of partners that are mirror images within this angle count as exact
  double length_tolerance = 1e-5;     ///< as above for positions, relative to the size of the skeleton
};

/// Pairs the joints of a skeleton and computes how local transforms are mirrored. Partners come from the options, then
/// from names (side_names.h), then from positions in the reference pose for joints whose names give no side.
///
/// Mirroring reflects the rotation of each joint relative to the reference pose. In model space, with S the reflection
/// at the plane, p the partner of j, W rotations of the reference pose, and G rotations of the pose:
///     N_j = G_j W_j^-1;  N'_p = S N_j S;  G'_p = N'_p W_p
/// The axes of p need not be the mirrored axes of j, and its bones may have other lengths. With parents P and P' =
/// partner(P), the parents cancel, and local rotations q = G_P^-1 G_j are mirrored by constants:
/// eq   q'_p = C_P q_j C_j^-1,  C_j = W_p^-1 S W_j  (improper; above roots C = S)
///      t'_p = r_p + C_P (t_j - r_j),  r the reference translation: bones keep their length
///      s'_p = r_p * |C_j|^2 (s_j / r_j),  r the reference scale, |C|^2 squares each entry
/// C is improper, so the code uses the quaternion c = w_p^-1 n w_j of -C, n the normal as a pure quaternion. Since c_p
/// = -c_j^-1, mirroring twice also restores the signs of quaternions. If C maps axes onto axes within the tolerance,
/// it is rounded to do so exactly. Then mirroring only copies and negates numbers, and mirroring twice restores every
/// bit. Otherwise each number is a sum of up to four rounded products, and mirroring twice gives the original within
/// rounding.
///
/// A joint without a partner whose parent has one (a sword in one hand) keeps its local motion, and so do all joints
/// below it. A joint without a partner whose parent is its own partner is mirrored onto itself. `unpaired` lists the
/// first joint of each branch that keeps its motion, and joints mirrored onto themselves whose name or position
/// suggests a partner.
/// in   reference  empty or [J], rotations unit;   pairs  in range, no joint in two of them
/// cost O(J log J) with names, O(J^2) without; allocates
SINEW_API MirrorMap make_mirror_map(const Skeleton& skeleton, const MirrorOptions& options = {});

/// The entry that a row copies, as index + 1, negative if the row negates it; 0 if the row is a sum of products.
template <std::size_t kCount>
int copied_entry(const MirrorRow<kCount>& row) noexcept {
  int entry = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (row[i] == 0.0) continue;
    if (entry != 0 || (row[i] != 1.0 && row[i] != -1.0)) return 0;
    entry = row[i] > 0.0 ? static_cast<int>(i) + 1 : -static_cast<int>(i) - 1;
  }
  return entry;
}

/// Computes one number of a mirrored value.
/// eq   row * in + offset; copies and negations keep the bits
template <std::size_t kCount>
float mirrored_number(const MirrorRow<kCount>& row, const float* in, double offset = 0.0) noexcept {
  const int entry = copied_entry(row);
  if (entry != 0 && offset == 0.0) return entry > 0 ? in[entry - 1] : -in[-entry - 1];
  double sum = offset;
  for (std::size_t i = 0; i < kCount; ++i) sum += row[i] * static_cast<double>(in[i]);
  return static_cast<float>(sum);
}

}  // namespace sinew
