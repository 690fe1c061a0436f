// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/result.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Skinning matrices of one skin.
/// eq   palette[i] = model[joints[i]] * inverse_bind[i]   (glTF 2.0, "Skins")
/// in   model[J]   all joints of the skeleton
/// out  palette[N] N = skin->joints.size()
/// err  size_mismatch, index_out_of_range     cost O(N), no allocation
struct JointPaletteJob {
  const Skin* skin = nullptr;
  std::span<const Affine> model;
  std::span<JointMatrix> palette;
};

ErrorCode check(const JointPaletteJob& job) noexcept;
void run(const JointPaletteJob& job) noexcept;

/// A skinning matrix split for dual-quaternion skinning: first stretch in bind space, then move rigidly (N19).
/// eq   J = [R S | t]: R the rotation of the polar decomposition, S = stretch symmetric (xx yy zz xy xz yz);
///      for a mirrored J (det < 0) S is negative: R * S still is J (numeric case "polar")
struct alignas(64) RigidStretch {
  DualQuat rigid;
  float stretch[6] = {1, 1, 1, 0, 0, 0};
  float unused[2] = {0, 0};  ///< read with the rest of the cache line
};

/// Two entries of a palette.
struct JointPair {
  std::uint16_t first = 0, second = 0;
};

/// Splits every palette matrix.
/// in   follow[any]  in this order, the quaternion of `second` takes the sign that is on the side of `first`; empty:
/// signs as
///                   they come
/// out  split[N];   any_stretch  true when some stretch differs from the identity by more than 1e-6: the second phase
/// is needed (P12) err  size_mismatch, index_out_of_range     cost O(N), no allocation; a singular matrix gives some
/// rotation with R * S = J
struct SplitPaletteJob {
  std::span<const JointMatrix> palette;
  std::span<RigidStretch> split;
  bool* any_stretch = nullptr;
  std::span<const JointPair> follow;
};

ErrorCode check(const SplitPaletteJob& job) noexcept;
void run(const SplitPaletteJob& job) noexcept;

}  // namespace sinew
