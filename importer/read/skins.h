// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/affine.h"

namespace sinew {

/// The inverse bind matrices of a skin, one per joint; none in the file are identities, more than joints are ignored
/// (G31). err  skin-matrices (type, or fewer than joints), not-finite;  warning skin-matrix-row, skin-no-joints
std::vector<Affine> read_inverse_bind_matrices(const gltf::Document& document, std::uint32_t skin, IssueLog& log);

/// Warns where the joints of a skin hang under different roots: their whole ancestor chains are evaluated anyway (G32).
/// in   root_of_node[N]   the top of each node's tree
void check_common_root(const gltf::Document& document, std::uint32_t skin,
                       const std::vector<std::uint32_t>& root_of_node, IssueLog& log);

}  // namespace sinew
