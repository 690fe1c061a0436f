// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/joint_order.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Warns if a skin's skeleton root is not an ancestor of all its joints. Poses do not depend on it.
/// warning  skin-skeleton
/// cost     O(N + joints of all skins)
void check_skeletons(const gltf::Document& document, const JointOrder& order, IssueLog& log);

}  // namespace sinew
