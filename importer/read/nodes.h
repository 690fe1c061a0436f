// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"
#include "runtime/math/transform.h"

namespace sinew {

/// The local transform of a node: translation, rotation and scale, or a matrix that is kept bit for bit.
struct NodeTransform {
  Transform transform;  ///< if there is a matrix: its decomposition, for code that cannot use matrices
  bool is_matrix = false;
  Affine matrix;
};

/// Reads a matrix from 16 column-major numbers; false if its fourth row is not 0 0 0 1.
template <class T>
bool to_affine(const T* m, Affine& out) noexcept {
  for (std::size_t row = 0; row < 3; ++row)
    out.row[row] = {static_cast<float>(m[row]), static_cast<float>(m[4 + row]), static_cast<float>(m[8 + row]),
                    static_cast<float>(m[12 + row])};
  return m[3] == T(0) && m[7] == T(0) && m[11] == T(0) && m[15] == T(1);
}

/// Reads one node. Normalises rotations; a zero rotation becomes the identity.
/// warning  node-matrix-trs (the matrix is used), node-matrix-row, rotation-length, rotation-zero
NodeTransform read_node_transform(const gltf::Node& node, std::uint32_t index, IssueLog& log);

}  // namespace sinew
