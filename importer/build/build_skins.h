// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Builds the skins: skeleton joints in the skin's own order, inverse bind matrices, and the skeleton root, which is
/// only a hint.
/// err      as read_inverse_bind_matrices
/// warning  skin-common-root
std::vector<Skin> build_skins(const gltf::Document& document, const JointOrder& order, IssueLog& log);

}  // namespace sinew
