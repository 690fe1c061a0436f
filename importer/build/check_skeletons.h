// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/joint_order.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Warns where the skeleton root that a skin names is not above all of its joints. Poses do not depend on it (G30).
/// warning  skin-skeleton
/// cost     O(N + joints of all skins)
void check_skeletons(const gltf::Document& document, const JointOrder& order, IssueLog& log);

}  // namespace sinew
