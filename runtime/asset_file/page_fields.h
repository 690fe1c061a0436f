// SPDX-License-Identifier: MIT
// The fields of page tables; see asset_fields.h. Offsets count from the first byte of the block AssetKind::page_keys.
#pragma once
#include "runtime/asset_file/asset_fields.h"
#include "runtime/paging/page_table.h"

namespace sinew {

auto fields(Is<PageTable> auto& t) {
  auto& [page_s, offsets] = t;
  return std::tie(page_s, offsets);
}

}  // namespace sinew
