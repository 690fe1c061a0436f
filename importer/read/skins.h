// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"

namespace sinew {

/// Reads the inverse bind matrices of a skin, one for each joint. Without any in the file they are identities; surplus
/// matrices are ignored (G31).
/// err      skin-matrices (wrong type, or fewer than joints), not-finite
/// warning  skin-matrix-row, skin-no-joints
std::vector<Affine> read_inverse_bind_matrices(const gltf::Document& document, std::uint32_t skin, IssueLog& log);

/// Warns where joints of a skin lie under different roots. Poses are right all the same: every joint's chain of
/// ancestors is evaluated (G32).
/// in       root_of_node[N]   the node at the top of each node's tree
/// warning  skin-common-root
void check_common_root(const gltf::Document& document, std::uint32_t skin,
                       const std::vector<std::uint32_t>& root_of_node, IssueLog& log);

}  // namespace sinew
