// SPDX-License-Identifier: MIT
#include "runtime/paging/page_table.h"

#include "runtime/base/contract.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/paging/cut_clip.h"

namespace sinew {

Clip cut_page(const Clip& clip, double page_s, std::size_t page) {
  const std::size_t count = page_count_of(clip.duration_s(), page_s);
  CONTRACT(page < count);
  const PageTimes times = times_of_page(page, page_s, count);
  ClipLayout layout = cut_clip(clip, times.first_s, times.last_s).layout();
  layout.name = name_of_page(clip.name(), page);
  layout.annotations = {};  // the first keys of the clip keep them
  layout.certificate.reset();
  return clip_of(std::move(layout));
}

}  // namespace sinew
