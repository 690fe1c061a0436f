// SPDX-License-Identifier: MIT
#include "runtime/playback/blended_events.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/contract.h"

namespace sinew {

BlendedEvents::BlendedEvents(std::span<const PlayingClip> playing, std::span<Cursor> cursors) noexcept
    : playing_(playing), cursors_(cursors) {
  CONTRACT(cursors.size() >= playing.size());
  for (std::size_t c = 0; c < playing.size(); ++c) {
    const PlayingClip& clip = playing[c];
    cursors_[c] = {};
    if (clip.step.error != ErrorCode::ok || (clip.weight_before == 0.0f && clip.weight_after == 0.0f)) continue;
    cursors_[c].crossed.emplace(clip.step, clip.event_times_s);
    rounds_left_out_ += cursors_[c].crossed->rounds_left_out();
    advance(c);
  }
}

/// Finds the next event of one clip.
void BlendedEvents::advance(std::size_t clip) noexcept {
  Cursor& cursor = cursors_[clip];
  const std::optional<std::size_t> event = cursor.crossed->next();
  cursor.has_next = event.has_value();
  if (!event) return;
  const PlayingClip& playing = playing_[clip];
  const double length_s = std::fabs(playing.step_s);
  const double moment = length_s > 0.0 ? std::min(1.0, cursor.crossed->played_s() / length_s) : 1.0;
  const double before = static_cast<double>(playing.weight_before), after = static_cast<double>(playing.weight_after);
  cursor.next = {.clip = clip,
                 .event = *event,
                 .moment = moment,
                 .weight = static_cast<float>((1.0 - moment) * before + moment * after)};
}

std::optional<BlendedEvent> BlendedEvents::next() noexcept {
  Cursor* first = nullptr;
  for (Cursor& cursor : cursors_.first(playing_.size()))
    if (cursor.has_next && (first == nullptr || cursor.next.moment < first->next.moment)) first = &cursor;
  if (first == nullptr) return std::nullopt;
  const BlendedEvent event = first->next;
  advance(event.clip);
  return event;
}

}  // namespace sinew
