// SPDX-License-Identifier: MIT
#include "runtime/compress/remove_keys.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "runtime/animation/track_sample.h"

namespace sinew {
namespace {

/// A position on a track: a key, or a fraction of the way from it to the next.
struct Place {
  std::size_t key;
  double fraction;
};

/// Positions between keys at which curves are compared. Straight segments are farthest apart at keys.
constexpr double kOnBends[] = {0.25, 0.5, 0.75};

double time_of(const std::vector<float>& times, std::size_t key) noexcept { return static_cast<double>(times[key]); }
double time_of(const std::vector<float>& times, const Place& at) noexcept {
  if (at.fraction == 0.0) return time_of(times, at.key);
  return time_of(times, at.key) + at.fraction * (time_of(times, at.key + 1) - time_of(times, at.key));
}

/// Calls `see(place)` for the positions between the keys `first` and `last` until one returns false.
template <class See>
bool all_between(Interpolation interpolation, std::size_t first, std::size_t last, const See& see) {
  for (std::size_t key = first; key < last; ++key) {
    if (key > first && !see(Place{key, 0.0})) return false;
    if (interpolation != Interpolation::cubic_spline) continue;
    for (const double fraction : kOnBends)
      if (!see(Place{key, fraction})) return false;
  }
  return true;
}

double distance_of(const Vec3<double>& a, const Vec3<double>& b) noexcept { return safe_length(a - b); }

/// Upper bound for the movement of a point one unit from the axis: twice the chord between unit quaternions.
double distance_of(const Quat<double>& a, const Quat<double>& b) noexcept {
  const Quat<double> d = a - aligned_with(a, b);
  return 2.0 * std::sqrt(quat_dot(d, d));
}

auto in_double(const glm::vec3& v) noexcept { return Vec3<double>(v); }
auto in_double(const glm::quat& q) noexcept { return quat_cast<double>(q); }

template <class V>
auto value_at(const Track<V>& track, const Place& at) noexcept {
  if (at.fraction == 0.0) return in_double(track.values[value_row(track.interpolation, at.key)]);
  const double interval_s = time_of(track.times_s, at.key + 1) - time_of(track.times_s, at.key);
  return between_keys<double>(track, at.key, at.key + 1, at.fraction, interval_s);
}

double value_at(const WeightTrack& track, const Place& at, std::size_t weight) noexcept {
  if (at.fraction == 0.0)
    return static_cast<double>(track.values[value_row(track.interpolation, at.key) * track.target_count + weight]);
  const double interval_s = time_of(track.times_s, at.key + 1) - time_of(track.times_s, at.key);
  return between_keys<double>(track, at.key, at.key + 1, at.fraction, interval_s, weight);
}

/// Distance between the track and `other(place[, weight])` at a position.
template <class V, class Other>
double deviation(const Track<V>& track, std::span<const float>, const Place& at, const Other& other) {
  return distance_of(value_at(track, at), other(at));
}

template <class Other>
double deviation(const WeightTrack& track, std::span<const float> metres, const Place& at, const Other& other) {
  double sum = 0.0;
  for (std::size_t i = 0; i < track.target_count; ++i)
    sum += std::abs(value_at(track, at, i) - other(at, i)) * static_cast<double>(metres[i]);
  return sum;
}

/// True if the track may drop its keys between `first` and `last`. Goes on where the last call for this step ended.
template <class TrackType>
bool can_skip(const TrackType& track, const LooseTrack& loose, std::size_t first, std::size_t last) {
  StepDeviations::Step unknown, *known = loose.known != nullptr ? loose.known->find(first, last) : nullptr;
  StepDeviations::Step& step = known != nullptr ? *known : unknown;
  if (!(step.largest <= loose.tolerance)) return false;
  const double begin = time_of(track.times_s, first), interval_s = time_of(track.times_s, last) - begin;
  std::size_t place_number = 0;
  return all_between(track.interpolation, first, last, [&](const Place& place) {
    if (place_number++ < step.places) return true;
    const auto skipping = [&](const Place& at, auto... weight) {
      return between_keys<double>(track, first, last, (time_of(track.times_s, at) - begin) / interval_s, interval_s,
                                  weight...);
    };
    const double here = deviation(track, loose.metres_per_weight, place, skipping);
    if (!(here <= step.largest)) step.largest = here >= 0.0 ? here : std::numeric_limits<double>::infinity();
    ++step.places;
    return step.largest <= loose.tolerance;
  });
}

bool is_jump(const std::vector<float>& times, std::size_t key) noexcept {
  return key + 1 < times.size() && !(times[key + 1] > times[key]);
}

/// The middle of all keys. For rotations it is the direction of their mean, which is accurate if all are close
/// together.
glm::vec3 middle_of(const Vec3Track& track) {
  glm::vec3 lower = track.values[value_row(track.interpolation, 0)], upper = lower;
  for (std::size_t key = 1; key < track.key_count(); ++key) {
    const glm::vec3& v = track.values[value_row(track.interpolation, key)];
    lower = glm::min(lower, v);
    upper = glm::max(upper, v);
  }
  return glm::vec3((Vec3<double>(lower) + Vec3<double>(upper)) * 0.5);
}

glm::quat middle_of(const QuatTrack& track) {
  const Quat<double> first = quat_cast<double>(track.values[value_row(track.interpolation, 0)]);
  Quat<double> sum = first;
  for (std::size_t key = 1; key < track.key_count(); ++key)
    sum += aligned_with(first, quat_cast<double>(track.values[value_row(track.interpolation, key)]));
  return quat_cast<float>(normalised(sum));
}

std::vector<float> middle_of(const WeightTrack& track) {
  std::vector<float> middle(track.target_count);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    double lower = value_at(track, {0, 0.0}, i), upper = lower;
    for (std::size_t key = 1; key < track.key_count(); ++key) {
      lower = std::min(lower, value_at(track, {key, 0.0}, i));
      upper = std::max(upper, value_at(track, {key, 0.0}, i));
    }
    middle[i] = static_cast<float>(0.5 * (lower + upper));
  }
  return middle;
}

/// True if the track stays within its tolerance from `other(place[, weight])`.
template <class TrackType, class Other>
bool is_near(const TrackType& track, const LooseTrack& loose, const Other& other) {
  const auto near = [&](const Place& at) {
    return deviation(track, loose.metres_per_weight, at, other) <= loose.tolerance;
  };
  const std::size_t last = track.key_count() - 1;
  return near({0, 0.0}) && near({last, 0.0}) && all_between(track.interpolation, 0, last, near);
}

template <class V>
bool flatten_to_constant(Track<V>& track, const LooseTrack& loose) {
  const V middle = middle_of(track);
  if (!is_near(track, loose, [&](const Place&) { return in_double(middle); })) return false;
  track = {Interpolation::step, {track.times_s.front(), track.times_s.back()}, {middle, middle}};
  return true;
}

bool flatten_to_constant(WeightTrack& track, const LooseTrack& loose) {
  std::vector<float> middle = middle_of(track);
  if (!is_near(track, loose, [&](const Place&, std::size_t i) { return static_cast<double>(middle[i]); })) return false;
  const std::vector<float> once = middle;
  middle.insert(middle.end(), once.begin(), once.end());
  track = {Interpolation::step, {track.times_s.front(), track.times_s.back()}, std::move(middle), track.target_count};
  return true;
}

/// Copies the values of some keys; each key has `per_key` values.
template <class Value>
std::vector<Value> rows_of(const std::vector<Value>& values, std::size_t per_key, std::span<const std::uint32_t> keys) {
  std::vector<Value> kept;
  kept.reserve(keys.size() * per_key);
  for (const std::uint32_t key : keys)
    kept.insert(kept.end(), values.begin() + static_cast<std::ptrdiff_t>(key * per_key),
                values.begin() + static_cast<std::ptrdiff_t>((key + 1) * per_key));
  return kept;
}

constexpr std::size_t kKeysLookedAt = 2048;  // so many keys of a track suffice to estimate how many it needs
constexpr int kGroupDepth = 2;               // a list is cut in two, and its halves once more
constexpr std::size_t kCutPlaces = 8;        // cuts are tried at each eighth of a list

std::size_t count_keys_needed(std::span<const LooseTrack> tracks) {
  return keys_needed(tracks, std::min(tracks.front().times_s().size(), kKeysLookedAt)).size();
}

/// Estimate: packed keys take about a third of full ones.
std::size_t bytes_per_key(const LooseTrack& track) {
  return std::visit([](const auto* t) { return (t->values.size() / t->key_count() * sizeof(t->values[0]) + 2) / 3; },
                    track.track);
}

std::size_t bytes_of_group(std::span<const LooseTrack> tracks) {
  std::size_t row = 2 * sizeof(float);  // key time and its entry in the search table
  for (const LooseTrack& track : tracks) row += bytes_per_key(track);
  return kTimeGroupBytes + count_keys_needed(tracks) * row;
}

/// Cuts a list of tracks, ordered by the keys that each needs, if two groups take fewer bytes. Then cuts the halves.
void cut_groups(std::span<const LooseTrack> tracks, int depth, std::vector<std::vector<LooseTrack>>& groups) {
  std::size_t best_bytes = bytes_of_group(tracks), best = 0;
  for (std::size_t i = 1; depth > 0 && i < kCutPlaces; ++i) {
    const std::size_t place = tracks.size() * i / kCutPlaces;
    if (place == 0 || place == tracks.size() * (i - 1) / kCutPlaces) continue;
    const std::size_t bytes = bytes_of_group(tracks.first(place)) + bytes_of_group(tracks.subspan(place));
    if (bytes >= best_bytes) continue;
    best_bytes = bytes;
    best = place;
  }
  if (best == 0) {
    groups.emplace_back(tracks.begin(), tracks.end());
    return;
  }
  cut_groups(tracks.first(best), depth - 1, groups);
  cut_groups(tracks.subspan(best), depth - 1, groups);
}

}  // namespace

StepDeviations::Step* StepDeviations::find(std::size_t first, std::size_t last) {
  const std::size_t left_out = last - first - 1;
  if (first >= from_.size()) from_.resize(first + 1);
  std::vector<Step>& steps = from_[first];
  if (left_out > steps.size()) {
    const std::size_t more = left_out - steps.size();
    if (count_ + more > most_) return nullptr;
    count_ += more;
    steps.resize(left_out);
  }
  return &steps[left_out - 1];
}

const std::vector<float>& LooseTrack::times_s() const {
  return std::visit([](const auto* t) -> const std::vector<float>& { return t->times_s; }, track);
}

std::vector<std::uint32_t> keys_needed(std::span<const LooseTrack> tracks, std::size_t key_count) {
  const std::vector<float>& times = tracks.front().times_s();
  std::size_t strictest = 0;  // test first the track that stopped the last step: it likely stops the next one too
  const auto all_can_skip = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const std::size_t t = (strictest + i) % tracks.size();
      if (std::visit([&](const auto* track) { return can_skip(*track, tracks[t], first, last); }, tracks[t].track))
        continue;
      strictest = t;
      return false;
    }
    return true;
  };
  std::vector<std::uint32_t> keys{0};
  for (std::size_t key = 0; key + 1 < key_count;) {
    std::size_t next = key + 1;
    const bool before_jump = is_jump(times, key);
    while (!before_jump && next + 1 < key_count && next - key < kLongestStep && !is_jump(times, next) &&
           all_can_skip(key, next + 1))
      ++next;
    keys.push_back(static_cast<std::uint32_t>(next));
    key = next;
  }
  return keys;
}

void keep_keys(const LooseTrack& loose, std::span<const std::uint32_t> keys) {
  std::visit(
      [&](auto* track) {
        std::size_t per_key = track->interpolation == Interpolation::cubic_spline ? 3 : 1;
        if constexpr (requires { track->target_count; }) per_key *= track->target_count;
        track->times_s = rows_of(track->times_s, 1, keys);
        track->values = rows_of(track->values, per_key, keys);
      },
      loose.track);
}

bool flatten_to_constant(const LooseTrack& loose) {
  return std::visit([&](auto* track) { return flatten_to_constant(*track, loose); }, loose.track);
}

std::vector<std::vector<LooseTrack>> split_into_time_groups(std::vector<LooseTrack> tracks) {
  std::vector<std::pair<std::size_t, std::size_t>> order;  // {keys that the track needs alone, index of the track}
  for (std::size_t i = 0; i < tracks.size(); ++i) order.emplace_back(count_keys_needed({&tracks[i], 1}), i);
  std::sort(order.begin(), order.end());
  std::vector<LooseTrack> by_need;
  std::transform(order.begin(), order.end(), std::back_inserter(by_need),
                 [&](const auto& o) { return tracks[o.second]; });
  std::vector<std::vector<LooseTrack>> groups;
  cut_groups(by_need, kGroupDepth, groups);
  return groups;
}

}  // namespace sinew
