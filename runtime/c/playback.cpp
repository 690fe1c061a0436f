// SPDX-License-Identifier: MIT
#include "runtime/c/playback.h"

#include <array>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/enums.h"
#include "runtime/playback/blended_events.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/playback_clock.h"
#include "runtime/pose_program/op_shares.h"

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

constexpr std::size_t kMostPlaying = 255;  ///< no program has more clips

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

sinew_error sinew_op_shares(const sinew_pose_op* ops, std::size_t op_count, float* shares) {
  return c::call(c::given(c::Array{ops, op_count}, c::Array{shares, op_count}), [&] {
    const PoseProgramSpan program(reinterpret_cast<const PoseOp*>(ops), op_count);
    constexpr std::size_t kAny = 0x10000;  // the indices do not matter here
    const ErrorCode error = check(program, {.clips = kAny,
                                            .externals = kAny,
                                            .masks = kAny,
                                            .overrides = kAny,
                                            .procedures = kAny,
                                            .mirror = true,
                                            .slots = kMostPoseOps,
                                            .kept = kMostPoseOps});
    if (error == ErrorCode::ok) find_op_shares(program, {shares, op_count});
    return error;
  });
}

sinew_error sinew_blended_events(const sinew_playing_clip* playing, std::size_t count, sinew_blended_event* events,
                                 std::size_t capacity, std::size_t* crossed) {
  return c::call(c::given(crossed, c::Array{playing, count}, c::Array{events, capacity}), [&] {
    std::array<PlayingClip, kMostPlaying> own;
    std::array<BlendedEvents::Cursor, kMostPlaying> cursors;
    if (count > kMostPlaying) return SINEW_UNSUPPORTED;
    for (std::size_t i = 0; i < count; ++i) {
      const sinew_playing_clip& clip = playing[i];
      if (clip.event_times_s == nullptr && clip.event_count > 0) return SINEW_NULL_ARGUMENT;
      c::copy_bytes(clip.step, own[i].step);
      own[i].event_times_s = {clip.event_times_s, clip.event_count};
      own[i].step_s = clip.step_s;
      own[i].weight_before = clip.weight_before;
      own[i].weight_after = clip.weight_after;
    }
    *crossed = 0;
    const std::span<BlendedEvents::Cursor> room(cursors.data(), count);
    for (BlendedEvents all({own.data(), count}, room); const auto event = all.next(); ++*crossed)
      if (*crossed < capacity)
        events[*crossed] = {static_cast<std::uint32_t>(event->clip), static_cast<std::uint32_t>(event->event),
                            event->moment, event->weight};
    return SINEW_OK;
  });
}
