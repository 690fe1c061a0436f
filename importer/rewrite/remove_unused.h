// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Removes the spare accessors and views that nothing refers to any more, and renumbers the others. What nothing used
/// in the source stays. An extension with numbers that may be indices is a loss when entries have to move.
/// cost  O(document)
void remove_unused(Draft& draft);

}  // namespace sinew::rewrite
