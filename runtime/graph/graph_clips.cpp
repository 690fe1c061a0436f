// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_clips.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
    if (const ErrorCode code = check(SyncTrack{clip.beats}); code != ErrorCode::ok) return tl::make_unexpected(code);
    entry.first_beat = static_cast<std::uint32_t>(set.beats_.size());
    entry.beat_count = static_cast<std::uint32_t>(clip.beats.size());
    set.beats_.insert(set.beats_.end(), clip.beats.begin(), clip.beats.end());
    entry.root = clip.root;
    entry.root_in_pose = clip.root_in_pose;
    entry.clip = clip.clip;
    set.any_root_ |= clip.root != nullptr;
    set.any_root_in_pose_ |= clip.root != nullptr && clip.root_in_pose;
    set.entries_.push_back(entry);
  }
  return set;
}

Result<GraphClipSet> GraphClipSet::make(const GraphDefinition& graph, std::span<const GraphClip> clips,
                                        std::span<const std::uint32_t> mirrored_beats,
                                        const Vec3<double>& mirror_normal) {
  const GraphTables& t = graph.tables();
  if (clips.size() < t.clip_names.size()) return tl::make_unexpected(ErrorCode::size_mismatch);
  auto set = make(clips, mirror_normal);
  if (!set) return set;
  set->mirrored_beats_.assign(mirrored_beats.begin(), mirrored_beats.end());
  std::vector<std::vector<double>> phases(clips.size());
  for (std::size_t c = 0; c < clips.size(); ++c)
    for (const std::int64_t event : set->events_of(set->entries_[c]))
      phases[c].push_back(set->entries_[c].period == 0
                              ? 0.0
                              : static_cast<double>(event) / static_cast<double>(set->entries_[c].period));
  std::vector<SpaceClip> of_points;
  for (const GraphBlendPoint& point : t.points) {
    const GraphClipNode& node = t.clips[t.nodes[point.node].settings];
    SpaceClip& clip = of_points.emplace_back();
    if (set->entries_[node.clip].period == 0) continue;  // a clip that stands still has no beats
    clip = {phases[node.clip], set->track_of(set->entries_[node.clip], node.mirror, 1.0)};
    if (const ErrorCode code = check(clip.track); code != ErrorCode::ok) return tl::make_unexpected(code);
  }
  auto beats = SpaceBeats::make(t, of_points);
  if (!beats) return tl::make_unexpected(beats.error());
  set->space_beats_ = std::move(*beats);
  return set;
}

}  // namespace sinew
