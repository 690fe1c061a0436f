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

}  // namespace

ClipPlace LiveMotion::place_of(const LiveSample& sample, std::int64_t position) const noexcept {
  const std::int64_t rounds = divided_down(position, period);
  const std::int64_t rest = position - rounds * period;
  const auto turns = static_cast<double>(rounds);
  if (sample.bounds == nullptr) return {turns, time_s(sample, rest)};
  const double phase = own_phase(sample, place_at(rest)), whole = std::floor(phase);
  return {turns * std::round(sample.bounds[segments] - sample.bounds[0]) + whole,
          (phase - whole) * sample.entry->duration_s};
}

std::uint64_t LiveMotion::segment(bool backwards) const noexcept {
  const bool falls = (own_step < 0) != backwards;
  const std::int64_t place = falls ? (state->position == 0 ? kPhasePeriod : state->position) - 1 : state->position;
  return (static_cast<std::uint64_t>(place) * segments) >> kPhaseBits;
}

std::int64_t LiveMotion::to_segment_end(bool backwards) const noexcept {
  if (segments == 0) return kNever;
  const std::uint64_t k = segment(backwards);
  if ((step < 0) == backwards) return segment_start(k + 1, segments) - state->position;
  const std::int64_t from = state->position == 0 ? kPhasePeriod : state->position;
  return from - segment_start(k, segments);
}

std::int64_t LiveMotion::position_at(GraphTicks ahead) const noexcept {
  if (ahead == 0 || period == 0) return state->position;
  const std::int64_t position = state->position + step * ahead;
  if (!loop) return std::clamp(position, std::int64_t{0}, period);
  const std::int64_t rest = position % period;
  return rest < 0 ? rest + period : rest;
}

}  // namespace sinew
