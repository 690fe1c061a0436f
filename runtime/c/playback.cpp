// SPDX-License-Identifier: MIT
#include "runtime/c/playback.h"

#include "runtime/c/boundary.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/playback_clock.h"

namespace {

using namespace sinew;

static_assert(static_cast<int>(PlayMode::loop) == SINEW_PLAY_LOOP &&
              static_cast<int>(PlayMode::clamp) == SINEW_PLAY_CLAMP &&
              static_cast<int>(PlayMode::ping_pong) == SINEW_PLAY_PING_PONG &&
              static_cast<int>(PlayMode::once) == SINEW_PLAY_ONCE);

// The C structs hold the bytes of the C++ ones.
static_assert(sizeof(PlaybackClock) <= sizeof(sinew_clock) && sizeof(PlaybackStep) <= sizeof(sinew_step));

PlaybackClock clock_in(const sinew_clock& given) noexcept {
  PlaybackClock clock(0.0);
  c::copy_bits(given, clock);
  return clock;
}

/// Changes the clock in place. A number that it refuses leaves it as it was.
template <class Change>
sinew_error change(sinew_clock* given, Change&& apply) noexcept {
  if (given == nullptr) return SINEW_NULL_ARGUMENT;
  PlaybackClock clock = clock_in(*given);
  if (const ErrorCode error = apply(clock); error != ErrorCode::ok) return c::error_from(error);
  c::copy_bits(clock, *given);
  return SINEW_OK;
}

}  // namespace

sinew_error sinew_clock_init(sinew_clock* clock, double duration_s, std::uint32_t mode, double speed) {
  if (clock == nullptr) return SINEW_NULL_ARGUMENT;
  if (mode > SINEW_PLAY_ONCE) return SINEW_UNSUPPORTED;
  const Result<PlaybackClock> made = PlaybackClock::make(duration_s, static_cast<PlayMode>(mode), speed);
  if (!made) return SINEW_NOT_FINITE;
  *clock = {};
  c::copy_bits(*made, *clock);
  return SINEW_OK;
}

sinew_error sinew_clock_advance(sinew_clock* clock, double dt_s, sinew_step* step) {
  return change(clock, [&](PlaybackClock& own) {
    const PlaybackStep played = own.advance(dt_s);
    if (step != nullptr && played.error == ErrorCode::ok) {
      *step = {};
      c::copy_bits(played, *step);
    }
    return played.error;
  });
}

sinew_error sinew_clock_seek(sinew_clock* clock, double time_s) {
  return change(clock, [&](PlaybackClock& own) { return own.seek(time_s); });
}

sinew_error sinew_clock_set_speed(sinew_clock* clock, double speed) {
  return change(clock, [&](PlaybackClock& own) { return own.set_speed(speed); });
}

double sinew_clock_time_s(const sinew_clock* clock) { return clock != nullptr ? clock_in(*clock).time_s() : 0.0; }
std::int64_t sinew_clock_rounds(const sinew_clock* clock) { return clock != nullptr ? clock_in(*clock).rounds() : 0; }
int sinew_clock_finished(const sinew_clock* clock) { return clock != nullptr && clock_in(*clock).finished(); }

std::size_t sinew_crossed_events(const sinew_step* step, const double* event_times_s, std::size_t event_count,
                                 std::uint32_t* events, std::size_t capacity) {
  if (step == nullptr || event_times_s == nullptr) return 0;
  if (events == nullptr) capacity = 0;
  PlaybackStep played;
  c::copy_bits(*step, played);
  std::size_t crossed = 0;
  for (EventCursor cursor(played, {event_times_s, event_count}); const auto event = cursor.next(); ++crossed)
    if (crossed < capacity) events[crossed] = static_cast<std::uint32_t>(*event);
  return crossed;
}
