// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Removes spare accessors and views that are no longer referenced, and renumbers the others. Entries that were already
/// unused in the source stay. If entries move, unknown extensions with numbers are a loss.
/// cost  O(document)
void remove_unused(Draft& draft);

}  // namespace sinew::rewrite
