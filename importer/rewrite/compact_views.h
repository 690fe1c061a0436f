// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <set>

#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Drops the bytes of views that no accessor uses any more. Views with a byteStride or an extension stay unchanged. So
/// do views that something else than an accessor uses, and views that share bytes with another view.
/// in    views  that lost an accessor
/// cost  O(accessors + bytes of the views)
void compact_views(const std::set<std::uint32_t>& views, Draft& draft);

}  // namespace sinew::rewrite
