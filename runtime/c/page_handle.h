// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/paging/paged_clip.h"

/// The object behind the handle of a page.
struct sinew_page {
  sinew::PageSample sample;
};

namespace sinew::c {

static_assert(offsetof(sinew_page, sample) == 0 && offsetof(PageSample, page) == 0);

inline const Clip* clip_of(const sinew_page* page) noexcept { return page != nullptr ? &page->sample.page : nullptr; }

/// The page that contains this clip as its first member.
inline const sinew_page* page_of(const Clip* clip) noexcept { return reinterpret_cast<const sinew_page*>(clip); }

/// Views an array of pages as an array of clips, without copying. Null stays null.
inline const Clip* const* clips_of(const sinew_page* const* pages) noexcept {
  return reinterpret_cast<const Clip* const*>(pages);
}
inline const sinew_page* const* pages_of(const Clip* const* clips) noexcept {
  return reinterpret_cast<const sinew_page* const*>(clips);
}

}  // namespace sinew::c
