// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Completes what glTF demands and the file lacks, where one value does no harm:
/// - an empty list of the root object goes;
/// - a skin without joints gets the first node, which nothing then follows;
/// - an orthographic camera without far plane gets one that is far away.
void mend(Draft& draft);

}  // namespace sinew::rewrite
