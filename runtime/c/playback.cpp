// SPDX-License-Identifier: MIT
#include "runtime/c/playback.h"

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/enums.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/playback_clock.h"

namespace sinew::c {

// The C structs hold the bytes of the C++ objects.
template <>
struct Convert<sinew_clock, PlaybackClock> : ConvertInside<sinew_clock, PlaybackClock> {};
template <>
struct Convert<sinew_step, PlaybackStep> : ConvertInside<sinew_step, PlaybackStep> {};

}  // namespace sinew::c

namespace {

using namespace sinew;

PlaybackClock clock_in(const sinew_clock& given) noexcept {
  PlaybackClock clock(0.0);
  c::copy_bytes(given, clock);
  return clock;
}

/// Changes the clock in place. If it refuses the number, it stays as it was.
template <class Change>
sinew_error change(sinew_clock* clock, Change&& apply) noexcept {
  return c::call(c::given(clock), [&] {
    PlaybackClock own = clock_in(*clock);
    const ErrorCode error = apply(own);
    if (error == ErrorCode::ok) *clock = c::to_c(own);
    return error;
  });
}

}  // namespace

sinew_error sinew_clock_init(sinew_clock* clock, double duration_s, std::uint32_t mode, double speed) {
  return c::call(c::given(clock), [&] {
    PlayMode own = PlayMode::loop;
    if (const sinew_error error = c::from_c(mode, own)) return error;
    const Result<PlaybackClock> made = PlaybackClock::make(duration_s, own, speed);
    if (!made) return SINEW_NOT_FINITE;
    *clock = c::to_c(*made);
    return SINEW_OK;
  });
}

sinew_error sinew_clock_advance(sinew_clock* clock, double dt_s, sinew_step* step) {
  return change(clock, [&](PlaybackClock& own) {
    const PlaybackStep played = own.advance(dt_s);
    if (step != nullptr && played.error == ErrorCode::ok) *step = c::to_c(played);
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
  c::copy_bytes(*step, played);
  std::size_t crossed = 0;
  for (EventCursor cursor(played, {event_times_s, event_count}); const auto event = cursor.next(); ++crossed)
    if (crossed < capacity) events[crossed] = static_cast<std::uint32_t>(*event);
  return crossed;
}
