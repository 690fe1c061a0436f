// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"
#include "runtime/math/transform.h"

namespace sinew {

/// The transform of a node in its parent's space: translation, rotation and scale, or a matrix that is kept bit for bit
/// (G50).
struct NodeTransform {
  Transform transform;  ///< where there is a matrix: its decomposition, for code that cannot use the matrix
  bool is_matrix = false;
  Affine matrix;
};

/// Reads one node. Rotations that are not unit quaternions are normalised; a zero rotation becomes the identity (G52).
/// warning  node-matrix-trs (the matrix is used), node-matrix-row, rotation-length, rotation-zero
NodeTransform read_node_transform(const gltf::Node& node, std::uint32_t index, IssueLog& log);

}  // namespace sinew
