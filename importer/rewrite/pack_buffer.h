// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Moves the bytes of all views into one buffer, the only one that the document then has. Views that share bytes go on
/// sharing them; bytes that no view names are left out. Each block keeps its offsets modulo 4, so that elements stay
/// aligned. Packing what was packed changes nothing.
/// out   the bytes of the buffer, empty where the document has no views; the draft's views name places in it
/// cost  O(views log views + bytes)
std::vector<std::byte> pack_buffer(Draft& draft);

}  // namespace sinew::rewrite
