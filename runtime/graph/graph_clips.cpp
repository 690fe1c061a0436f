// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_clips.h"

#include <algorithm>
#include <cmath>

#include "runtime/graph/graph_time.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {

Result<GraphClipSet> GraphClipSet::make(std::span<const GraphClip> clips, const Vec3<double>& mirror_normal) {
  GraphClipSet set;
  set.mirror_normal_ = mirror_normal;
  for (const GraphClip& clip : clips) {
    if (!std::isfinite(clip.duration_s)) return tl::make_unexpected(ErrorCode::not_finite);
    if (clip.duration_s < 0.0 || clip.duration_s > kMostGraphClip_s) return tl::make_unexpected(ErrorCode::too_large);
    Entry entry;
    const GraphTicks ticks = ticks_of(decimal_of(clip.duration_s));
    entry.period = ticks << kClipBits;
    entry.duration_s = seconds_of(ticks);
    entry.first_event = static_cast<std::uint32_t>(set.events_.size());
    entry.event_count = static_cast<std::uint32_t>(clip.event_times_s.size());
    double last_s = 0.0;
    for (const double time_s : clip.event_times_s) {
      if (!(time_s >= last_s && time_s <= clip.duration_s)) return tl::make_unexpected(ErrorCode::times_not_increasing);
      last_s = time_s;
      set.events_.push_back(std::min(ticks_of(decimal_of(time_s)) << kClipBits, entry.period));
    }
    entry.root = clip.root;
    entry.clip = clip.clip;
    set.any_root_ |= clip.root != nullptr;
    set.entries_.push_back(entry);
  }
  return set;
}

}  // namespace sinew
