// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// One row of a linear map. A row whose only entry is 1 or -1 copies a number, negated or not, bit for bit.
template <std::size_t kCount>
using MirrorRow = std::array<double, kCount>;

/// Where the mirrored local transform of one joint comes from.
struct MirroredJoint {
  std::uint32_t source = 0;  ///< its partner; the joint itself where it lies on the plane or has no partner
  std::array<MirrorRow<4>, 4> rotation = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};  ///< of x y z w
  std::array<MirrorRow<3>, 3> translation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3<double> offset{0.0};  ///< added to the translation
  std::array<MirrorRow<3>, 3> scale = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// How poses, clips and morph weights of one skeleton are mirrored. Made once by make_mirror_map and never changed.
struct MirrorMap {
  glm::vec3 plane_normal{1.0f, 0.0f, 0.0f};  ///< unit, in model space
  float plane_offset = 0.0f;                 ///< of the reference pose along the normal
  std::vector<MirroredJoint> joints;         ///< [J]
  std::vector<std::uint32_t> unpaired;  ///< rising; joints without a partner though their name or place asks for one
  bool is_about_rest = true;            ///< the reference pose is the rest pose, which the mirror then keeps
  std::vector<std::uint32_t> weight_source;  ///< [W] of Scene::first_weight; empty = morph weights stay
};

/// Joints that have a partner other than themselves.
std::size_t paired_joints(const MirrorMap& map) noexcept;

/// What the person knows better than names and places.
struct MirrorOptions {
  std::optional<glm::vec3> plane_normal;            ///< model space; nothing = found: mostly +X
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< joints; two equal ones: it is its own partner
  /// [J] local transforms in which the body is symmetric, where the rest pose is not (an exported frame of a walk).
  /// Empty = the rest pose.
  std::span<const Transform> reference = {};
  double angle_tolerance_rad =
      1e-4;                        ///< axes of partners that are so near to each other's mirror image are taken for it
  double length_tolerance = 1e-5;  ///< the same for places, of the size of the skeleton
};

/// Pairs the joints of a skeleton and works out how local transforms are mirrored. Partners come from the options, then
/// from names (side_names.h), then from the symmetry of the reference pose, for joints whose names tell nothing.
///
/// Mirroring reflects how far each joint is from the reference pose. In model space, with S the reflection at the
/// plane, p the partner of j, and reference rotations W and rotations G of the pose:
///     N_j = G_j W_j^-1;  N'_p = S N_j S;  G'_p = N'_p W_p
/// The axes of p need not be those of j mirrored, and its bones need not be as long. With parents P and P' =
/// partner(P), local rotations q = G_P^-1 G_j follow from constants alone, since the parents cancel:
/// eq   q'_p = C_P q_j C_j^-1,  C_j = W_p^-1 S W_j  (improper; above roots C = S)
///      t'_p = r_p + C_P (t_j - r_j),  r the reference translation: bones keep their length
///      s'_p = r_p * |C_j|^2 (s_j / r_j),  r the reference scale, |C|^2 squares each entry
/// C is used as the quaternion c = w_p^-1 n w_j of -C, n the normal as a pure quaternion; c_p = -c_j^-1, so that signs
/// come back, too. Where C maps axes onto axes within the tolerance it is taken to do so exactly. Then mirroring copies
/// and negates numbers, and twice mirrored is the same, bit for bit. Elsewhere each number is a sum of up to four
/// rounded products, so twice mirrored differs by rounding: no rotation by other angles maps floats one to one onto
/// floats.
///
/// A joint below paired ones that has no partner itself (a sword in one hand) keeps its own local motion. So do all
/// below it. A joint on or below the plane's joints without a partner is mirrored onto itself. Both are listed.
/// in   reference  empty or [J], rotations unit; pairs in range, no joint in two pairs
/// cost O(J log J) with names, O(J^2) without; allocates
MirrorMap make_mirror_map(const Skeleton& skeleton, const MirrorOptions& options = {});

/// The entry that a row copies, as index + 1, negative where it is negated; 0 where the row is a sum of products.
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

/// One number of a mirrored value.
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
