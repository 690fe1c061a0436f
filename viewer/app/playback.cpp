// SPDX-License-Identifier: MIT
#include "viewer/app/playback.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew::viewer {
namespace {

constexpr std::array kSpeeds{0.05, 0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0, 8.0};
static_assert(kSpeeds.front() == Playback::kSlowest && kSpeeds.back() == Playback::kFastest);

double duration_of(const Scene& scene, std::uint32_t clip, double least_duration_s) {
  return clip < scene.animations.size() ? std::max(scene.animations[clip].duration_s, least_duration_s)
                                        : least_duration_s;
}

}  // namespace

Playback::Playback(const Scene& scene, double duration_s)
    : scene_(&scene),
      least_duration_s_(duration_s),
      clip_(scene.animations.empty() ? kNone : 0),
      duration_s_(duration_of(scene, clip_, duration_s)),
      clock_(duration_s_) {}

void Playback::choose(std::uint32_t clip) {
  clip_before_ = clip_;
  clock_before_ = clock_;
  range_start_before_s_ = range_start_s_;
  faded_s_ = range_start_s_ = 0.0;
  clip_ = clip < scene_->animations.size() ? clip : kNone;
  duration_s_ = duration_of(*scene_, clip_, least_duration_s_);
  clock_ = PlaybackClock(duration_s_, clock_.mode(), clock_.speed());
}

void Playback::next(int direction) {
  const auto count = static_cast<std::int64_t>(scene_->animations.size());
  if (count == 0) return;
  const std::int64_t from = clip_ == kNone ? (direction > 0 ? -1 : 0) : std::int64_t{clip_};
  choose(static_cast<std::uint32_t>((from + direction + count) % count));
}

void Playback::continue_from(const Playback& before, std::optional<std::uint32_t> clip) {
  playing_ = before.playing_;
  in_turn_ = before.in_turn_;
  clock_ = PlaybackClock(clock_.duration_s(), before.mode(), before.speed());
  if (!clip) return;
  choose(*clip);
  if (before.has_range()) set_range(before.range_start_s(), before.range_end_s());
  PlaybackClock there = before.clock_;
  const bool on_way_back = there.advance(0.0).to_s > there.duration_s();  // on the backward half of ping-pong
  seek(before.time_s());
  if (!on_way_back) return;
  const double from_start_s = clock_.time_s();
  clock_ = PlaybackClock(clock_.duration_s(), before.mode(), 1.0);
  clock_.advance(2.0 * clock_.duration_s() - from_start_s);
  clock_.set_speed(before.speed());
}

void Playback::toggle() noexcept {
  if (clock_.finished()) {
    clock_.seek(clock_.speed() < 0.0 ? clock_.duration_s() : 0.0);  // of the range
    playing_ = true;
    return;
  }
  playing_ = !playing_;
}

void Playback::advance(double dt_s) noexcept {
  last_step_s_ = playing_ ? dt_s : 0.0;
  if (!playing_) return;
  clock_.advance(dt_s);
  if (in_turn_ && (clock_.rounds() != 0 || clock_.duration_s() == 0.0)) return begin_next_in_turn();
  if (!fading()) return;
  clock_before_.advance(dt_s);
  faded_s_ += dt_s;
}

void Playback::begin_next_in_turn() {
  const int direction = clock_.speed() < 0.0 ? -1 : +1;
  const double into_next_s = direction > 0 ? clock_.time_s() : clock_.duration_s() - clock_.time_s();
  const std::uint32_t before = clip_;
  const double range_start_s = range_start_s_;
  PlaybackClock end(clock_.duration_s(), PlayMode::clamp, clock_.speed());
  end.seek(direction > 0 ? clock_.duration_s() : 0.0);
  next(direction);
  for (std::size_t i = 0; duration_s_ == 0.0 && i < scene_->animations.size(); ++i) next(direction);
  seek(direction > 0 ? into_next_s : duration_s_ - into_next_s);
  clip_before_ = before;  // it fades out from its end
  range_start_before_s_ = range_start_s;
  clock_before_ = end;
  faded_s_ = into_next_s / std::max(std::abs(clock_.speed()), 1e-9);
}

void Playback::play_in_turn() {
  set_mode(PlayMode::loop);
  in_turn_ = true;
}

void Playback::set_range(double from_s, double to_s) noexcept {
  const double time = time_s();
  double from = std::clamp(std::min(from_s, to_s), 0.0, duration_s_);
  double to = std::clamp(std::max(from_s, to_s), 0.0, duration_s_);
  if (!(to - from >= kFrame_s)) {
    from = 0.0;
    to = duration_s_;
  }
  range_start_s_ = from;
  clock_ = PlaybackClock(to - from, clock_.mode(), clock_.speed());
  if (time >= from && time <= to) seek(time);
}

MotionMoment Playback::moment() const noexcept {
  MotionMoment moment{.clip = clip_, .time_s = time_s()};
  if (mode() == PlayMode::loop && !has_range()) moment.turns = static_cast<double>(clock_.rounds());
  if (!fading()) return moment;
  const auto t = static_cast<float>(faded_s_ / fade_s_);
  moment.fade = t * t * (3.0f - 2.0f * t);
  moment.faded_clip = clip_before_;
  moment.faded_time_s = range_start_before_s_ + clock_before_.time_s();
  return moment;
}

void Playback::step(int direction) noexcept {
  playing_ = false;
  if (duration_s() <= 0.0) return;
  // A time within 1e-6 frames of a frame counts as exactly on it.
  const double frames = time_s() / kFrame_s, nearest = std::round(frames);
  const bool on_frame = std::abs(frames - nearest) < 1e-6;
  const double here = on_frame ? nearest : direction > 0 ? std::floor(frames) : std::ceil(frames);
  const double first = std::ceil(range_start_s() / kFrame_s - 1e-6), last = std::floor(range_end_s() / kFrame_s + 1e-6);
  double frame = here + direction;
  if (frame > last) frame = first;
  if (frame < first) frame = last;
  seek(frame * kFrame_s);
}

void Playback::faster() noexcept {
  for (const double speed : kSpeeds)
    if (speed > clock_.speed() + 1e-9) return set_speed(speed);
}

void Playback::slower() noexcept {
  for (std::size_t i = kSpeeds.size(); i-- > 0;)
    if (kSpeeds[i] < clock_.speed() - 1e-9) return set_speed(kSpeeds[i]);
}

void Playback::set_mode(PlayMode mode) {
  const double time = clock_.time_s();
  in_turn_ = false;
  clock_ = PlaybackClock(clock_.duration_s(), mode, clock_.speed());
  clock_.seek(time);
}

void Playback::next_mode() {
  if (mode() == PlayMode::once && scene_->animations.size() > 1) return play_in_turn();
  set_mode(in_turn_                        ? PlayMode::loop
           : mode() == PlayMode::loop      ? PlayMode::ping_pong
           : mode() == PlayMode::ping_pong ? PlayMode::once
                                           : PlayMode::loop);
}

std::span<const ClipLayer> Playback::layers_ahead(std::uint32_t frames) noexcept {
  if (clip_ == kNone) return {};
  PlaybackClock later = clock_;
  if (in_turn_) {  // the clip ends, and does not begin again
    later = PlaybackClock(clock_.duration_s(), PlayMode::clamp, clock_.speed());
    later.seek(clock_.time_s());
  }
  if (playing_)
    for (std::uint32_t i = 0; i < frames; ++i) later.advance(last_step_s_);
  ahead_ = {clip_, range_start_s_ + later.time_s(), 1.0f};
  return {&ahead_, 1};
}

std::span<const ClipLayer> Playback::layers() noexcept {
  if (clip_ == kNone) return {};
  layer_ = {clip_, time_s(), 1.0f};
  return {&layer_, 1};
}

}  // namespace sinew::viewer
