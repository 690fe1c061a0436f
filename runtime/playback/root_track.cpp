// SPDX-License-Identifier: MIT
#include "runtime/playback/root_track.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/contract.h"
#include "runtime/math/interpolate.h"
#include "runtime/playback/carried_motion.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;

/// An interval between authoring keys is halved at most this many times while a straight line does not fit.
constexpr int kMostHalvings = 12;
constexpr int kChecksInInterval = 8;

struct Place {
  double time_s;
  Vec3d translation;
  Quatd turn;
};

Place place_from(const RootTrack::Key& key) noexcept {
  return {key.time_s, Vec3d(key.translation), quat_cast<double>(key.turn)};
}

Place between(const Place& a, const Place& b, double time_s) noexcept {
  const double length = b.time_s - a.time_s, factor = length > 0.0 ? (time_s - a.time_s) / length : 1.0;
  return {time_s, a.translation + (b.translation - a.translation) * factor, slerp_short_arc(a.turn, b.turn, factor)};
}

double distance(const Place& a, const Place& b) noexcept {
  return std::max(safe_length(a.translation - b.translation), rotation_angle_between(a.turn, b.turn));
}

/// Finds the keys of a track. Candidates are all keys that may be needed; chosen() drops those that are not.
class KeySearch {
 public:
  KeySearch(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts, double tolerance)
      : root_(root), rest_(rest), parts_(parts), tolerance_(tolerance) {}

  std::vector<Place> keys() {
    const std::vector<double> times = authored_times();
    if (times.empty()) return {place_at(0.0, 0.0)};
    candidates_.push_back(place_at(times.front(), times.front()));
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      // A step key is a jump: the end of its interval and the start of the next one are two candidates at the same
      // time.
      const Place end = place_at(times[i + 1], std::nextafter(times[i + 1], times[i]));
      add_interval(candidates_.back(), end, 0);
      const Place next = place_at(times[i + 1], times[i + 1]);
      if (distance(end, next) > tolerance_) candidates_.push_back(next);
    }
    return chosen();
  }

  Place place_at(double key_time_s, double time_s) const {
    const DualQuatd place = root_place(root_, rest_, parts_, time_s);
    return {key_time_s, translation_of(place), place.real};
  }

 private:
  std::vector<double> authored_times() const {
    std::vector<double> times;
    for (const auto* track : {&root_.translation.times_s, &root_.rotation.times_s})
      times.insert(times.end(), track->begin(), track->end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  bool straight_line_fits(const Place& from, const Place& to, double within) const {
    for (int i = 1; i < kChecksInInterval; ++i) {
      const double time_s = from.time_s + (to.time_s - from.time_s) * i / kChecksInInterval;
      if (distance(between(from, to, time_s), place_at(time_s, time_s)) > within) return false;
    }
    return true;
  }

  /// Adds candidates with half of the tolerance; the other half is left for chosen().
  void add_interval(const Place& from, const Place& to, int halvings) {
    if (halvings < kMostHalvings && !straight_line_fits(from, to, 0.5 * tolerance_)) {
      const double middle_s = 0.5 * (from.time_s + to.time_s);
      const Place middle = place_at(middle_s, middle_s);
      add_interval(from, middle, halvings + 1);
      add_interval(middle, to, halvings + 1);
    } else {
      candidates_.push_back(to);
    }
  }

  bool may_skip(std::size_t from, std::size_t to) const {
    for (std::size_t i = from + 1; i < to; ++i)
      if (candidates_[i].time_s == candidates_[i + 1].time_s ||
          distance(between(candidates_[from], candidates_[to], candidates_[i].time_s), candidates_[i]) >
              0.5 * tolerance_)
        return false;
    return straight_line_fits(candidates_[from], candidates_[to], tolerance_);
  }

  /// Doubles the length of a skip until it no longer fits, then searches between by bisection.
  std::vector<Place> chosen() const {
    std::vector<Place> keys{candidates_.front()};
    for (std::size_t at = 0; at + 1 < candidates_.size();) {
      std::size_t fits = at + 1, fails = candidates_.size();
      for (std::size_t length = 2; fits + 1 < fails; length *= 2) {
        const std::size_t to = std::min(at + length, candidates_.size() - 1);
        if (may_skip(at, to))
          fits = to;
        else
          fails = to;
        if (to + 1 == candidates_.size()) break;
      }
      while (fits + 1 < fails) {
        const std::size_t to = fits + (fails - fits) / 2;
        (may_skip(at, to) ? fits : fails) = to;
      }
      keys.push_back(candidates_[fits]);
      at = fits;
    }
    if (keys.size() == 2 && distance(keys[0], keys[1]) == 0.0) keys.pop_back();
    return keys;
  }

  const BoneAnimation& root_;
  const Transform& rest_;
  const RootMotionParts& parts_;
  double tolerance_;
  std::vector<Place> candidates_;
};

}  // namespace

RootTrack RootTrack::make(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                          double tolerance) {
  CONTRACT(tolerance > 0.0);
  KeySearch search(root, rest, parts, tolerance);
  RootTrack track;
  for (const Place& place : search.keys())
    track.keys_.push_back(
        {static_cast<float>(place.time_s), Vec3<float>(place.translation), quat_cast<float>(place.turn)});
  for (std::size_t i = 0; i + 1 < track.keys_.size(); ++i) {
    const double from_s = track.keys_[i].time_s, to_s = track.keys_[i + 1].time_s;
    for (int c = 0; c < kChecksInInterval; ++c) {
      const double time_s = from_s + (to_s - from_s) * c / kChecksInInterval;
      const DualQuatd found = track.place(time_s);
      track.measured_error_ = std::max(track.measured_error_, distance({time_s, translation_of(found), found.real},
                                                                       search.place_at(time_s, time_s)));
    }
  }
  return track;
}

DualQuatd RootTrack::place(double time_s) const noexcept {
  if (keys_.empty()) return {};
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), time_s, [](double time, const Key& key) {
    return time < static_cast<double>(key.time_s);
  });
  Place found = place_from(next == keys_.begin() ? keys_.front() : *(next - 1));
  if (next != keys_.begin() && next != keys_.end()) found = between(found, place_from(*next), time_s);
  return dual_quat_from(normalised(found.turn), found.translation);
}

DualQuatd RootTrack::motion(const PlaybackStep& step) const noexcept {
  return carried_motion([this](double time_s) { return place(time_s); }, step);
}

}  // namespace sinew
