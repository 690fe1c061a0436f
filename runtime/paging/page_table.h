// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// How one clip is cut into pages. Page k has the keys for times from k * page_s to (k + 1) * page_s. The first page
/// also has all keys before, and the last page all keys after. Each page is a block of save_clips (clip_file.h).
struct PageTable {
  double page_s = 0.0;                 ///< duration of each page; the last one may be shorter
  std::vector<std::uint64_t> offsets;  ///< [pages + 1] page k is bytes offsets[k] to offsets[k + 1] of the file;
                                       ///< empty = the clip has no pages

  std::size_t page_count() const noexcept { return offsets.empty() ? 0 : offsets.size() - 1; }
  friend bool operator==(const PageTable&, const PageTable&) = default;
};

/// The range of clip times of one page. A page ends at the time at which the next one begins. The first page begins at
/// minus infinity, and the last one ends at infinity.
struct PageTimes {
  double first_s, last_s;

  double nearest(double time_s) const noexcept { return std::clamp(time_s, first_s, last_s); }
};

inline PageTimes times_of_page(std::size_t page, double page_s, std::size_t page_count) noexcept {
  constexpr double kAlways_s = std::numeric_limits<double>::infinity();
  return {page == 0 ? -kAlways_s : static_cast<double>(page) * page_s,
          page + 1 == page_count ? kAlways_s : static_cast<double>(page + 1) * page_s};
}

/// The page for a time; on the border of two pages, the later one.
inline std::size_t page_at(double time_s, double page_s, std::size_t page_count) noexcept {
  const auto first_s = [&](std::size_t page) { return times_of_page(page, page_s, page_count).first_s; };
  const double pages = time_s / page_s, last = static_cast<double>(page_count - 1);
  auto page = static_cast<std::size_t>(pages > 0.0 ? (std::min)(pages, last) : 0.0);
  if (time_s < first_s(page)) --page;  // the quotient was rounded up
  if (page + 1 < page_count && time_s >= first_s(page + 1)) ++page;
  return page;
}

/// Number of pages of a clip, from 1 to 2^53 (for a page_s too short to be counted).
/// in   duration_s  finite, not negative;   page_s  finite, above 0
inline std::size_t page_count_of(double duration_s, double page_s) noexcept {
  return static_cast<std::size_t>(std::clamp(std::ceil(duration_s / page_s), 1.0, 0x1p53));
}

/// The name that is stored in a page, so that a page of another clip or another number is recognised: "walk [3]".
inline std::string name_of_page(const std::string& clip, std::size_t page) {
  return clip + " [" + std::to_string(page) + "]";
}

/// One page of a clip, as cut_clip (cut_clip.h) makes it, but with the name of the page and without a certificate.
/// cost O(keys of the page + tracks), allocates
SINEW_API Clip cut_page(const Clip& clip, double page_s, std::size_t page);

}  // namespace sinew
