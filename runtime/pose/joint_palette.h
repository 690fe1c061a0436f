// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Skinning matrices of one skin.
/// eq   palette[i] = model[joints[i]] * inverse_bind[i]   (glTF 2.0, "Skins")
/// in   model[J]   matrices of all joints of the skeleton
///      before[N]  a palette to compare the result with; may be `palette`, compared before it is overwritten; empty =
///      none
/// out  palette[N] N = skin->joints.size()
///      unchanged  true if the palette equals `before` bit for bit; false without `before`; null = not wanted
/// err  size_mismatch, index_out_of_range     cost O(N), no allocation; comparing stops at the first difference
struct JointPaletteJob {
  const Skin* skin = nullptr;
  std::span<const Affine> model;
  std::span<JointMatrix> palette;
  std::span<const JointMatrix> before;
  bool* unchanged = nullptr;
};

SINEW_API ErrorCode check(const JointPaletteJob& job) noexcept;
SINEW_API void run_unchecked(const JointPaletteJob& job) noexcept;

/// A skinning matrix J split for dual-quaternion skinning: a stretch in bind space, then a rigid motion.
/// eq   J = [R S | t], where R is the rotation of the polar decomposition and S is symmetric. `stretch` stores S as xx
///      yy zz xy xz yz. If J mirrors (det < 0), S is negative, so that R * S is still J. det S has the sign of det J,
///      also where S is singular within rounding (decompose.h).
struct alignas(64) RigidStretch {
  DualQuat rigid;
  float stretch[6] = {1, 1, 1, 0, 0, 0};
  float unused[2] = {0, 0};  ///< fills the cache line
};

/// Indices of two entries of a palette.
struct JointPair {
  std::uint16_t first = 0, second = 0;
};

/// Splits every palette matrix, one per SIMD lane, in double precision. Lanes do not influence each other's bits.
/// in   follow[any]  pairs, handled in order: the quaternion of `second` is negated if it lies on the other hemisphere
///      than that of `first`. Empty = signs as the decomposition gives them.
/// out  split[N];   any_stretch  true if a stretch differs from the identity by more than 1e-5, so that skinning needs
///      its stretch phase. Smaller stretches are rounding of rigid matrices: inverse bind matrices of files are off by
///      up to 5e-6. They are stored all the same. Skinning without the stretch phase misplaces a vertex by at most that
///      fraction of its distance from the origin of bind space.
/// err  size_mismatch, index_out_of_range. A singular matrix gives some rotation with R * S = J.
/// cost O(N), no allocation. Rigid matrices are cheapest; stretched ones take about three times as long. Nearly
///      singular matrices are split one by one, which takes fifty times as long (decompose.h).
struct SplitPaletteJob {
  std::span<const JointMatrix> palette;
  std::span<RigidStretch> split;
  bool* any_stretch = nullptr;
  std::span<const JointPair> follow;
};

SINEW_API ErrorCode check(const SplitPaletteJob& job) noexcept;
SINEW_API void run_unchecked(const SplitPaletteJob& job) noexcept;

}  // namespace sinew
