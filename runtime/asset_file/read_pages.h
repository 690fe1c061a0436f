// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/paging/page_table.h"

namespace sinew {

/// How the clips of a file are cut into pages, in their order; nothing where none is. An engine reads the bytes of a
/// page from the file or its mapping, and hands them to PagedClip::load_page (runtime/paging/paged_clip.h).
/// err   AssetFileError;  cost O(pages), reads no key; allocates
tl::expected<std::vector<PageTable>, AssetFileError> read_page_tables(const AssetFile& file);

/// The bytes of a page as PagedClip::load_page takes them: those given, or of a page that was packed
/// (AssetFileOptions::zstd_level) a view of `unpacked`, which is overwritten. Any bytes may be passed.
/// in    stored  of the file, where read_page_tables says
/// err   AssetFileError: asset-size, asset-memory;  cost O(bytes), allocates where `unpacked` has no room
tl::expected<std::span<const std::byte>, AssetFileError> unpack_page(std::span<const std::byte> stored,
                                                                     std::vector<std::byte>& unpacked);

/// The clips with all their keys, in place of those that have only their first keys (first_keys).
/// in    heads  the clips of the file
/// err   AssetFileError;  cost O(bytes of the pages), allocates
tl::expected<std::vector<Clip>, AssetFileError> join_pages(const AssetFile& file, std::vector<Clip> heads);

}  // namespace sinew
