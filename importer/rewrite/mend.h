// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Adds data that glTF requires and the file lacks, where the value does not matter:
/// - an empty list of the root object is removed;
/// - a skin without joints gets the first node, which no vertex uses;
/// - an orthographic camera without a far plane gets a distant one.
void mend(Draft& draft);

}  // namespace sinew::rewrite
