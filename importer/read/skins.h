// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"

namespace sinew {

/// Reads the inverse bind matrices of a skin, one for each joint. If the file has none, they are identities; surplus
/// matrices are ignored.
/// err      skin-matrices (wrong type, or fewer than joints), not-finite
/// warning  skin-matrix-row, skin-no-joints
std::vector<Affine> read_inverse_bind_matrices(const gltf::Document& document, std::uint32_t skin, IssueLog& log);

/// Warns if joints of a skin have different roots. Poses are still correct, because every joint's own ancestors are
/// evaluated.
/// in       root_of_node[N]   root of each node's tree
/// warning  skin-common-root
void check_common_root(const gltf::Document& document, std::uint32_t skin,
                       const std::vector<std::uint32_t>& root_of_node, IssueLog& log);

}  // namespace sinew
