// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Skinning matrices of one skin.
/// eq   palette[i] = model[joints[i]] * inverse_bind[i]   (glTF 2.0, "Skins")
/// in   model[J]   all joints of the skeleton;   before[N]  a palette to compare with, perhaps `palette` as it is before
///      the run; empty = none
/// out  palette[N] N = skin->joints.size();   unchanged  null, or whether every bit is as in `before`; false without it
/// err  size_mismatch, index_out_of_range     cost O(N), no allocation; nothing is compared after the first difference
struct JointPaletteJob {
  const Skin* skin = nullptr;
  std::span<const Affine> model;
  std::span<JointMatrix> palette;
  std::span<const JointMatrix> before;
  bool* unchanged = nullptr;
};

ErrorCode check(const JointPaletteJob& job) noexcept;
void run_unchecked(const JointPaletteJob& job) noexcept;

/// A skinning matrix J split for dual-quaternion skinning: a stretch in bind space, then a rigid motion (N19).
/// eq   J = [R S | t]: R the rotation of the polar decomposition, S = stretch, symmetric (xx yy zz xy xz yz);
///      for a mirroring J (det < 0) S is negative, so that R * S still is J. det S has the sign of det J also where S
///      is singular within rounding (decompose.h).
struct alignas(64) RigidStretch {
  DualQuat rigid;
  float stretch[6] = {1, 1, 1, 0, 0, 0};
  float unused[2] = {0, 0};  ///< read with the rest of the cache line
};

/// Indices of two entries of a palette.
struct JointPair {
  std::uint16_t first = 0, second = 0;
};

/// Splits every palette matrix, one a lane, in double precision. A matrix gives the same bits whatever is beside it.
/// in   follow[any]  pairs in order: the quaternion of `second` takes the sign that is on the hemisphere of `first`;
///      empty = signs as the decomposition gives them
/// out  split[N];   any_stretch  whether a stretch differs from the identity by more than 1e-5, so that skinning
///      needs its first phase (P12). Less is what rounding left of a rigid matrix: inverse bind matrices of files, made
///      in float down a chain of joints, are off by up to 5e-6. It is stored all the same; without the first phase a
///      vertex is off by that part of its distance from the origin of bind space, at most
/// err  size_mismatch, index_out_of_range. A singular matrix gives some rotation with R * S = J.
/// cost O(N), no allocation. Lanes of rigid matrices take least, stretched ones about three times as much. Nearly
///      singular matrices are split one by one, which takes fifty times as much (decompose.h)
struct SplitPaletteJob {
  std::span<const JointMatrix> palette;
  std::span<RigidStretch> split;
  bool* any_stretch = nullptr;
  std::span<const JointPair> follow;
};

ErrorCode check(const SplitPaletteJob& job) noexcept;
void run_unchecked(const SplitPaletteJob& job) noexcept;

}  // namespace sinew
