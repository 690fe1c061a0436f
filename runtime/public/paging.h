// SPDX-License-Identifier: MIT
#pragma once
/// Long clips in pages, so that a bounded part of them is in memory while they play. cut_clip and cut_page cut a clip.
/// PagedClip says which page to load next, and which clip and time to sample now. Nothing here reads files;
/// asset_file.h finds the pages in one.
///
///     sinew::PagedClip speech(first_keys, table.page_s, table.page_count());
///     if (const auto page = speech.next_page()) request(*page);  // on any thread; then load_page(*page, bytes)
///     const sinew::PageSample now = speech.at(clock.time_s());   // for ClipLayer::page and ClipLayer::time_s
#include "runtime/paging/cut_clip.h"
#include "runtime/paging/page_table.h"
#include "runtime/paging/paged_clip.h"
