// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/base/api.h"
#include "runtime/paging/page_table.h"

namespace sinew {

/// Reads how each clip of a file is cut into pages; empty if no clip is. An engine reads the bytes of a page from the
/// file or its mapping and passes them to PagedClip::load_page (runtime/paging/paged_clip.h).
/// err   AssetFileError;  cost O(pages), reads no key; allocates
SINEW_API tl::expected<std::vector<PageTable>, AssetFileError> read_page_tables(const AssetFile& file);

/// The bytes of a page for PagedClip::load_page. A packed page (AssetFileOptions::zstd_level) gives a view of
/// `unpacked`, which is overwritten; other pages are returned as given. Any bytes may be passed.
/// in    stored  bytes of the file, where read_page_tables says
/// err   AssetFileError: asset-size, asset-memory;  cost O(bytes), allocates if `unpacked` has no room
SINEW_API tl::expected<std::span<const std::byte>, AssetFileError> unpack_page(std::span<const std::byte> stored,
                                                                               std::vector<std::byte>& unpacked);

/// Completes clips that have only their first keys (LongClips::first_keys) with the keys of their pages.
/// in    heads  the clips of the file
/// err   AssetFileError;  cost O(bytes of the pages), allocates
SINEW_API tl::expected<std::vector<Clip>, AssetFileError> join_pages(const AssetFile& file, std::vector<Clip> heads);

}  // namespace sinew
