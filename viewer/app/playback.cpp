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
      clock_(duration_of(scene, clip_, duration_s)) {}

void Playback::choose(std::uint32_t clip) {
  clip_ = clip < scene_->animations.size() ? clip : kNone;
  clock_ = PlaybackClock(duration_of(*scene_, clip_, least_duration_s_), clock_.mode(), clock_.speed());
}

void Playback::next(int direction) {
  const auto count = static_cast<std::int64_t>(scene_->animations.size());
  if (count == 0) return;
  const std::int64_t from = clip_ == kNone ? (direction > 0 ? -1 : 0) : std::int64_t{clip_};
  choose(static_cast<std::uint32_t>((from + direction + count) % count));
}

void Playback::continue_from(const Playback& before, std::optional<std::uint32_t> clip) {
  playing_ = before.playing_;
  clock_ = PlaybackClock(clock_.duration_s(), before.mode(), before.speed());
  if (!clip) return;
  choose(*clip);
  PlaybackClock there = before.clock_;
  const bool on_way_back = there.advance(0.0).to_s > there.duration_s();  // on the backward half of ping-pong
  clock_.seek(before.time_s());
  if (!on_way_back) return;
  clock_ = PlaybackClock(clock_.duration_s(), before.mode(), 1.0);
  clock_.advance(2.0 * clock_.duration_s() - std::min(before.time_s(), clock_.duration_s()));
  clock_.set_speed(before.speed());
}

void Playback::toggle() noexcept {
  if (clock_.finished()) {
    clock_.seek(clock_.speed() < 0.0 ? clock_.duration_s() : 0.0);
    playing_ = true;
    return;
  }
  playing_ = !playing_;
}

void Playback::advance(double dt_s) noexcept {
  last_step_s_ = playing_ ? dt_s : 0.0;
  if (playing_) clock_.advance(dt_s);
}

void Playback::step(int direction) noexcept {
  playing_ = false;
  if (duration_s() <= 0.0) return;
  // A time within 1e-6 frames of a frame counts as exactly on it.
  const double frames = time_s() / kFrame_s, nearest = std::round(frames);
  const bool on_frame = std::abs(frames - nearest) < 1e-6;
  const double here = on_frame ? nearest : direction > 0 ? std::floor(frames) : std::ceil(frames);
  const double last = std::floor(duration_s() / kFrame_s + 1e-6);
  double frame = here + direction;
  if (frame > last) frame = 0.0;
  if (frame < 0.0) frame = last;
  clock_.seek(frame * kFrame_s);
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
  const double time = time_s();
  clock_ = PlaybackClock(clock_.duration_s(), mode, clock_.speed());
  clock_.seek(time);
}

void Playback::next_mode() {
  set_mode(mode() == PlayMode::loop        ? PlayMode::ping_pong
           : mode() == PlayMode::ping_pong ? PlayMode::once
                                           : PlayMode::loop);
}

std::span<const ClipLayer> Playback::layers_ahead(std::uint32_t frames) noexcept {
  if (clip_ == kNone) return {};
  PlaybackClock later = clock_;
  if (playing_)
    for (std::uint32_t i = 0; i < frames; ++i) later.advance(last_step_s_);
  ahead_ = {clip_, later.time_s(), 1.0f};
  return {&ahead_, 1};
}

std::span<const ClipLayer> Playback::layers() noexcept {
  if (clip_ == kNone) return {};
  layer_ = {clip_, time_s(), 1.0f};
  return {&layer_, 1};
}

}  // namespace sinew::viewer
