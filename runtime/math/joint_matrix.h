// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"

namespace sinew {

/// A skinning matrix: four columns of four floats, aligned to one cache line. With 512-bit vectors, blending takes one
/// fused multiply-add a joint. The last row (0 0 0 1) is stored; a blend keeps it if its weights sum to 1.
struct alignas(64) JointMatrix {
  glm::vec4 column[4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

  friend bool operator==(const JointMatrix&, const JointMatrix&) = default;
};

inline JointMatrix joint_matrix_from(const Affine& m) noexcept {
  JointMatrix out;
  for (int c = 0; c < 4; ++c) out.column[c] = {m.row[0][c], m.row[1][c], m.row[2][c], c == 3 ? 1.0f : 0.0f};
  return out;
}

inline Affine affine_from(const JointMatrix& m) noexcept {
  Affine out;
  for (int r = 0; r < 3; ++r) out.row[r] = {m.column[0][r], m.column[1][r], m.column[2][r], m.column[3][r]};
  return out;
}

}  // namespace sinew
