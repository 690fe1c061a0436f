// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Packs the bytes of all views into a single buffer. Views that share bytes continue to share them; unreferenced bytes
/// are dropped. Offsets keep their value modulo 4, so that elements stay aligned. Idempotent.
/// out   the bytes of the buffer; empty if the document has no views. Views of the draft refer to it
/// cost  O(views log views + bytes)
std::vector<std::byte> pack_buffer(Draft& draft);

}  // namespace sinew::rewrite
