// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/paging/page_table.h"

namespace sinew {

/// How the clips of a file are cut into pages, in their order; nothing where none is. An engine reads the bytes of a
/// page from the file or its mapping, and hands them to PagedClip::load_page (runtime/paging/paged_clip.h).
/// err   AssetFileError;  cost O(pages), reads no key; allocates
tl::expected<std::vector<PageTable>, AssetFileError> read_page_tables(const AssetFile& file);

/// The clips with all their keys, in place of those that have only their first keys (first_keys).
/// in    heads  the clips of the file
/// err   AssetFileError;  cost O(bytes of the pages), allocates
tl::expected<std::vector<Clip>, AssetFileError> join_pages(const AssetFile& file, std::vector<Clip> heads);

}  // namespace sinew
