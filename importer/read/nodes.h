// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"
#include "runtime/math/transform.h"

namespace sinew {

/// Where a node is in its parent's space: either a transform, or a matrix that is kept verbatim (G50).
struct NodeTransform {
  Transform transform;  ///< of a matrix: its decomposition, for what cannot use the matrix
  bool is_matrix = false;
  Affine matrix;
};

/// Reads one node. Rotations that are not unit quaternions are normalised, a zero one becomes the identity (G52).
/// warning node-matrix-trs (the matrix is used), node-matrix-row, node-rotation, node-rotation-zero
NodeTransform read_node_transform(const gltf::Node& node, std::uint32_t index, IssueLog& log);

}  // namespace sinew
