// SPDX-License-Identifier: MIT
#include "runtime/clip/packed_keys.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "runtime/clip/clip_layout.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

/// A component that comes closer to 0 than this cannot be the derived one: it would be too inaccurate.
constexpr double kSmallestDerived = 0.3;

bool has_plain_keys(Interpolation interpolation) noexcept {
  return interpolation == Interpolation::step || interpolation == Interpolation::linear;
}

/// The next float above a positive number whose lower 16 bits are 0, so that two bytes store a step.
float coarse_above(double x) noexcept {
  constexpr std::uint32_t kLower = 0xffffu;
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(x));
  return std::bit_cast<float>((bits | kLower) + 1u);
}

struct Range {
  float low, high;
  double length() const noexcept { return static_cast<double>(high) - static_cast<double>(low); }
};

/// Quantises component `c` of all keys to out.width[c] bits over its range. With 0 bits all keys become the middle.
/// in   values[key][components]
void quantise(std::span<const float> values, const Range& range, std::size_t c, PackedTrack& out) {
  const std::size_t n = out.components, keys = values.size() / n;
  const double most = static_cast<double>((std::uint32_t{1} << out.width[c]) - 1);
  if (out.width[c] == 0) {
    out.step[c] = 0.0f;
    out.low[c] = range.low < range.high
                     ? static_cast<float>(0.5 * (static_cast<double>(range.low) + static_cast<double>(range.high)))
                     : range.low;
    return;
  }
  out.low[c] = range.low;
  out.step[c] = coarse_above(range.length() / most);
  for (std::size_t k = 0; k < keys; ++k) {
    const double number = std::round((static_cast<double>(values[k * n + c]) - static_cast<double>(out.low[c])) /
                                     static_cast<double>(out.step[c]));
    out.numbers[k * n + c] = static_cast<std::uint32_t>(std::clamp(number, 0.0, most));
  }
}

/// Searches for few bits with `error(packed, key)` <= tolerance for every key. First all components get the same step,
/// then bits are removed from one component after another while the tolerance holds.
/// in   values[key][components]
template <class Error>
std::optional<PackedTrack> fewest_bits(PackedTrack out, std::span<const float> values, double tolerance,
                                       const Error& error) {
  const std::size_t n = out.components, keys = values.size() / n;
  std::array<Range, 4> ranges{};
  for (std::size_t c = 0; c < n; ++c) {
    ranges[c] = {values[c], values[c]};
    for (std::size_t k = 1; k < keys; ++k)
      ranges[c] = {std::min(ranges[c].low, values[k * n + c]), std::max(ranges[c].high, values[k * n + c])};
  }
  out.numbers.assign(values.size(), 0);
  std::size_t strictest = 0;  // test first the key that failed last: it likely fails again
  const auto holds = [&] {
    for (std::size_t i = 0, k = strictest; i < keys; ++i, k = k + 1 == keys ? 0 : k + 1)
      if (!(error(out, k) <= tolerance)) {
        strictest = k;
        return false;
      }
    return true;
  };
  for (double step = 2.0 * tolerance; tolerance > 0.0; step *= 0.8) {
    for (std::size_t c = 0; c < n; ++c) {
      if (c == out.derived) continue;
      const double steps = ranges[c].length() / step;
      if (!(steps < (1u << PackedTrack::kMostBits) - 1)) return std::nullopt;
      out.width[c] = steps <= 1.0
                         ? std::uint8_t{0}
                         : static_cast<std::uint8_t>(std::bit_width(static_cast<std::uint32_t>(std::ceil(steps))));
      quantise(values, ranges[c], c, out);
    }
    if (out.bits_per_key() > PackedTrack::kMostKeyBits) return std::nullopt;
    if (holds()) break;
  }
  for (std::size_t c = 0; c < n; ++c)
    while (out.width[c] > 0) {
      const PackedTrack before = out;
      --out.width[c];
      quantise(values, ranges[c], c, out);
      if (holds()) continue;
      out = before;
      break;
    }
  for (std::size_t c = 0; c < n; ++c)
    if (out.width[c] > 0 && out.step[c] < PackedTrack::kLeastStep) return std::nullopt;
  return tolerance > 0.0 ? std::optional(std::move(out)) : std::nullopt;
}

/// The keys with their signs chosen: the derived component is positive, or if there is none, neighbours are aligned.
std::vector<float> signed_keys(const QuatTrack& track, std::uint8_t& derived) {
  std::array<double, 4> smallest;
  smallest.fill(2.0);
  for (const glm::quat& key : track.values) {
    const Quat<double> q = normalised(quat_cast<double>(key));
    for (int c = 0; c < 4; ++c)
      smallest[static_cast<std::size_t>(c)] = std::min(smallest[static_cast<std::size_t>(c)], std::abs(q[c]));
  }
  const auto largest = std::max_element(smallest.begin(), smallest.end());
  derived =
      *largest < kSmallestDerived ? PackedTrack::kNoneDerived : static_cast<std::uint8_t>(largest - smallest.begin());
  std::vector<float> values;
  Quat<double> before = quat_identity<double>();
  for (const glm::quat& key : track.values) {
    Quat<double> q = normalised(quat_cast<double>(key));
    if (derived == PackedTrack::kNoneDerived ? quat_dot(before, q) < 0.0 : q[derived] < 0.0) q = -q;
    before = q;
    const glm::quat key_now = without_tiny(quat_cast<float>(q));  // sampling does not check for tiny components
    values.insert(values.end(), {key_now.x, key_now.y, key_now.z, key_now.w});
  }
  return values;
}

}  // namespace

std::array<float, 4> unpack_key(const PackedTrack& track, std::size_t key) noexcept {
  std::array<float, 4> v{};
  for (std::uint32_t c = 0; c < track.components; ++c)
    if (c != track.derived)
      v[c] = static_cast<float>(track.numbers[key * track.components + c]) * track.step[c] + track.low[c];
  if (track.derived < track.components) {
    // Sums in the order of sample_clip, where w takes the slot of the derived component.
    std::array<float, 4> stored = v;
    std::swap(stored[track.derived], stored[3]);
    const float rest = 1.0f - ((stored[0] * stored[0] + stored[1] * stored[1]) + stored[2] * stored[2]);
    v[track.derived] = std::sqrt(std::max(rest, 0.0f));
  }
  return v;
}

glm::quat unpack_rotation(const PackedTrack& track, std::size_t key) noexcept {
  const std::array<float, 4> v = unpack_key(track, key);
  return quat_cast<float>(normalised(quat_cast<double>(quat_xyzw(v[0], v[1], v[2], v[3]))));
}

std::optional<PackedTrack> pack_keys(const Vec3Track& track, double tolerance) {
  if (!has_plain_keys(track.interpolation)) return std::nullopt;
  std::vector<float> values;
  for (const glm::vec3& v : track.values) values.insert(values.end(), {v.x, v.y, v.z});
  PackedTrack out;
  out.components = 3;
  const auto error = [&](const PackedTrack& packed, std::size_t key) {
    const std::array<float, 4> v = unpack_key(packed, key);
    return safe_length(Vec3<double>(v[0], v[1], v[2]) - Vec3<double>(track.values[key]));
  };
  return fewest_bits(std::move(out), values, tolerance, error);
}

std::optional<PackedTrack> pack_keys(const QuatTrack& track, double tolerance) {
  if (!has_plain_keys(track.interpolation)) return std::nullopt;
  PackedTrack out;
  out.components = 4;
  const std::vector<float> values = signed_keys(track, out.derived);
  const auto error = [&](const PackedTrack& packed, std::size_t key) {
    const std::array<float, 4> v = unpack_key(packed, key);
    const Quat<double> q = normalised(quat_cast<double>(quat_xyzw(v[0], v[1], v[2], v[3])));
    const Quat<double> d = q - aligned_with(q, normalised(quat_cast<double>(track.values[key])));
    return 2.0 * std::sqrt(quat_dot(d, d));
  };
  return fewest_bits(std::move(out), values, tolerance, error);
}

std::optional<PackedTrack> pack_keys(const WeightTrack& track, std::uint32_t weight, double tolerance) {
  if (!has_plain_keys(track.interpolation)) return std::nullopt;
  std::vector<float> values;
  for (std::size_t k = 0; k < track.key_count(); ++k) values.push_back(track.values[k * track.target_count + weight]);
  PackedTrack out;
  out.components = 1;
  const auto error = [&](const PackedTrack& packed, std::size_t key) {
    return std::abs(static_cast<double>(unpack_key(packed, key)[0]) - static_cast<double>(values[key]));
  };
  return fewest_bits(std::move(out), values, tolerance, error);
}

}  // namespace sinew
