// SPDX-License-Identifier: MIT
#include "runtime/graph/live_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "runtime/graph/whole_division.h"

namespace sinew {
namespace {

/// First position of a segment. The product of a position and the number of segments fits into 64 bits.
std::int64_t segment_start(std::uint64_t segment, std::uint64_t segments) noexcept {
  if (segment == segments) return kPhasePeriod;
  return static_cast<std::int64_t>(((segment << kPhaseBits) + segments - 1) / segments);
}

/// Phase of a sample's clip, not wrapped, at a position in [0, kPhasePeriod).
double own_phase(const LiveSample& sample, std::uint16_t segments, std::int64_t position) noexcept {
  const double place = static_cast<double>(position) * kRoundsOfPhase;
  if (sample.bounds == nullptr) return place;
  const double scaled = place * segments;
  const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(scaled), segments - 1u);
  return sample.bounds[k] + (scaled - static_cast<double>(k)) * (sample.bounds[k + 1] - sample.bounds[k]);
}

}  // namespace

double LiveMotion::time_s(const LiveSample& sample, std::int64_t position) const noexcept {
  if (is_space) {
    const double phase = own_phase(sample, segments, position);
    return (sample.bounds == nullptr ? phase : phase - std::floor(phase)) * sample.entry->duration_s;
  }
  return static_cast<double>(position) * kTicksOfClip / static_cast<double>(kTicksPerSecond);
}

ClipPlace LiveMotion::place_of(const LiveSample& sample, std::int64_t position) const noexcept {
  const std::int64_t rounds = divided_down(position, period);
  const std::int64_t rest = position - rounds * period;
  const auto turns = static_cast<double>(rounds);
  if (sample.bounds == nullptr) return {turns, time_s(sample, rest)};
  const double phase = own_phase(sample, segments, rest), whole = std::floor(phase);
  return {turns * std::round(sample.bounds[segments] - sample.bounds[0]) + whole,
          (phase - whole) * sample.entry->duration_s};
}

std::uint64_t LiveMotion::segment(bool backwards) const noexcept {
  const bool falls = (own_step < 0) != backwards;
  const std::int64_t place = falls ? (state->position == 0 ? kPhasePeriod : state->position) - 1 : state->position;
  return (static_cast<std::uint64_t>(place) * segments) >> kPhaseBits;
}

GraphTicks LiveMotion::to_segment_end(bool backwards) const noexcept {
  if (segments == 0 || step == 0) return kNever;
  const std::uint64_t k = segment(backwards);
  if ((step < 0) == backwards) return divided_up(segment_start(k + 1, segments) - state->position, std::abs(step));
  const std::int64_t from = state->position == 0 ? kPhasePeriod : state->position;
  return divided_up(from - segment_start(k, segments), std::abs(step));
}

std::int64_t LiveMotion::position_at(GraphTicks ahead) const noexcept {
  if (ahead == 0 || period == 0) return state->position;
  const std::int64_t position = state->position + step * ahead;
  if (!loop) return std::clamp(position, std::int64_t{0}, period);
  const std::int64_t rest = position % period;
  return rest < 0 ? rest + period : rest;
}

}  // namespace sinew
