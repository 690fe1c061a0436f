// SPDX-License-Identifier: MIT
#include "runtime/clip/packed_rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "runtime/base/contract.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/slerp_series.h"

namespace sinew {
namespace {

constexpr std::size_t kFour = 4;  ///< lanes of one load

/// The slot of a component that is not derived.
std::size_t slot_of(std::size_t component, std::uint8_t derived) noexcept {
  return component == 3 && derived < 3 ? derived : component;
}
std::uint8_t derived_of(const PackedRows& rows, std::size_t lane) noexcept {
  return rows.derived.empty() ? PackedTrack::kNoneDerived : rows.derived[lane];
}

std::size_t fours(std::size_t lanes) noexcept { return (lanes + kFour - 1) / kFour; }

std::uint32_t width_of(std::uint32_t mask) noexcept { return static_cast<std::uint32_t>(std::popcount(mask)); }

/// First bit of a number in a row.
std::size_t bit_of(const PackedRows& rows, std::size_t lanes, std::size_t slot, std::size_t lane) noexcept {
  const std::size_t at = slot * lanes + lane;
  return (std::size_t{rows.first_byte[slot * fours(lanes) + lane / kFour]} + rows.byte[at]) * 8 +
         static_cast<std::size_t>(std::countr_zero(rows.mask[at]));
}

/// Reads the eight bytes in which a number begins. The read stays inside the array thanks to kReadAhead.
std::uint64_t eight_bytes(const std::uint8_t* row, std::size_t bit) noexcept {
  std::uint64_t bytes;
  std::memcpy(&bytes, row + bit / 8, sizeof bytes);
  return bytes;
}

std::uint32_t read_bits(const std::uint8_t* row, std::size_t bit, std::uint32_t width) noexcept {
  return static_cast<std::uint32_t>(eight_bytes(row, bit) >> bit % 8) & ((std::uint32_t{1} << width) - 1);
}

/// Writes a number into bits that are 0.
void write_bits(std::uint8_t* row, std::size_t bit, std::uint32_t number) noexcept {
  const std::uint64_t bytes = eight_bytes(row, bit) | std::uint64_t{number} << bit % 8;
  std::memcpy(row + bit / 8, &bytes, sizeof bytes);
}

/// Calls `visit(lane, component, slot, at)` for all components that are not derived, lane by lane. `at` is the index
/// in the tables.
template <class Visit>
void each_component(const PackedRows& rows, std::size_t lanes, std::size_t components, const Visit& visit) {
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t c = 0; c < components; ++c)
      if (const std::uint8_t derived = derived_of(rows, lane); c != derived)
        visit(lane, c, slot_of(c, derived), slot_of(c, derived) * lanes + lane);
}

std::size_t component_count(const PackedRows& rows) noexcept { return rows.derived.empty() ? rows.slot_count : 4; }

void make_tables(PackedRows& rows, std::span<const PackedTrack> tracks) {
  const std::size_t lanes = tracks.size(), components = tracks.front().components;
  const bool rotations = components == 4;
  const std::size_t padding = (kLanePadding - lanes % kLanePadding) % kLanePadding;
  if (rotations) {
    rows.derived.assign(lanes + padding, 3);
    rows.kinds.assign((lanes + kLanePadding - 1) / kLanePadding, 0);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::uint8_t derived = rows.derived[lane] = tracks[lane].derived;
      const auto kind = derived < 3 ? PackedRows::swapped : derived > 3 ? PackedRows::no_derived : PackedRows::Kind{};
      rows.kinds[lane / kLanePadding] = static_cast<std::uint8_t>(rows.kinds[lane / kLanePadding] | kind);
    }
  }
  const bool all_left_out = rotations && std::none_of(rows.kinds.begin(), rows.kinds.end(),
                                                      [](std::uint8_t k) { return (k & PackedRows::no_derived) != 0; });
  rows.slot_count = static_cast<std::uint32_t>(all_left_out ? 3 : components);
  const std::size_t table = lanes * rows.slot_count + padding;
  rows.first_byte.assign(fours(lanes) * rows.slot_count + padding / kFour, 0);
  rows.byte.assign(table, 0);
  rows.mask.assign(table, 0);
  rows.step.assign(table, 0);
  rows.low.assign(table, 0.0f);
}

/// Computes `first_byte` and `shares_bytes`. A slot shares the bytes of the previous one if they contain its numbers.
void share_bytes(PackedRows& rows, std::size_t lanes, std::span<const std::size_t> bits) {
  const std::size_t count = fours(lanes);
  for (std::size_t slot = 0; slot < rows.slot_count; ++slot) {
    const auto first_byte = std::span(rows.first_byte).subspan(slot * count, count);
    const auto before = std::span(rows.first_byte).subspan(slot > 0 ? (slot - 1) * count : 0, count);
    bool shares = slot > 0;
    for (std::size_t lane = 0; lane < lanes && shares; ++lane) {
      // a number is read as four bytes from its first bit on
      const std::size_t end = bits[slot * lanes + lane] / 8 + 4;
      shares = end <= std::size_t{before[lane / kFour]} + 16;
    }
    rows.shares_bytes[slot] = shares;
    for (std::size_t four = 0; four < count; ++four)
      first_byte[four] = shares ? before[four] : static_cast<std::uint16_t>(bits[slot * lanes + four * kFour] / 8);
  }
}

/// Assigns bits of a row to the numbers, and computes `row_bytes`.
void place_numbers(PackedRows& rows, std::span<const PackedTrack> tracks) {
  const std::size_t lanes = tracks.size(), components = tracks.front().components;
  std::vector<std::uint8_t> width(rows.slot_count * lanes, 0);
  std::vector<float> step(rows.slot_count * lanes, 0.0f);
  each_component(rows, lanes, components, [&](std::size_t lane, std::size_t c, std::size_t, std::size_t at) {
    width[at] = tracks[lane].width[c];
    step[at] = tracks[lane].step[c];
    rows.low[at] = tracks[lane].low[c];
  });
  std::vector<std::size_t> bits(rows.slot_count * lanes);  // [slot][lane] first bit of each number
  std::size_t bit = 0;
  for (std::size_t four = 0; four < fours(lanes); ++four)
    for (std::size_t slot = 0; slot < rows.slot_count; ++slot)
      for (std::size_t lane = four * kFour; lane < std::min(lanes, (four + 1) * kFour); ++lane) {
        bits[slot * lanes + lane] = bit;
        bit += width[slot * lanes + lane];
      }
  rows.row_bytes = static_cast<std::uint32_t>((bit + 7) / 8);
  share_bytes(rows, lanes, bits);
  for (std::size_t at = 0; at < width.size(); ++at) {
    const std::size_t slot = at / lanes, four = at % lanes / kFour, shift = bits[at] % 8;
    rows.byte[at] = static_cast<std::uint8_t>(bits[at] / 8 - rows.first_byte[slot * fours(lanes) + four]);
    rows.mask[at] = ((std::uint32_t{1} << width[at]) - 1) << shift;
    const float of_bits = std::ldexp(step[at], -static_cast<int>(shift));
    rows.step[at] = static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(of_bits) >> 16);
  }
}

/// A stored component of one lane: `width` bits from `bit` on, whose value is low + step * bits.
struct Number {
  std::size_t bit;
  std::uint32_t width;
  float low, step;
};

std::array<Number, 4> numbers_of(const PackedRows& rows, std::size_t lanes, std::size_t lane) noexcept {
  std::array<Number, 4> numbers{};
  for (std::size_t slot = 0; slot < rows.slot_count; ++slot) {
    const std::size_t at = slot * lanes + lane;
    const std::uint32_t width = width_of(rows.mask[at]);
    const float of_bits = std::bit_cast<float>(std::uint32_t{rows.step[at]} << 16);
    const int shift = width > 0 ? std::countr_zero(rows.mask[at]) : 0;
    numbers[slot] = {width > 0 ? bit_of(rows, lanes, slot, lane) : 0, width, rows.low[at], std::ldexp(of_bits, shift)};
  }
  return numbers;
}

/// The quaternion of one lane in a row, in the order of slots.
std::array<double, 4> rotation_at(const std::array<Number, 4>& numbers, const std::uint8_t* row,
                                  std::uint8_t derived) noexcept {
  std::array<double, 4> q{};
  for (std::size_t slot = 0; slot < 4; ++slot) {
    const Number& n = numbers[slot];
    q[slot] =
        static_cast<double>(read_bits(row, n.bit, n.width)) * static_cast<double>(n.step) + static_cast<double>(n.low);
  }
  if (derived < PackedTrack::kNoneDerived)
    q[3] = std::sqrt(std::max(1.0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]), 0.0));
  return q;
}

/// Computes `power`: for each key the power that the largest arc of all lanes needs.
void find_powers(PackedRows& rows, std::size_t lanes, std::size_t key_count) {
  std::vector<double> largest(key_count, 0.0);  // x of slerp_power
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::array<Number, 4> numbers = numbers_of(rows, lanes, lane);
    if (std::all_of(numbers.begin(), numbers.end(), [](const Number& n) { return n.width == 0; })) continue;
    std::array<double, 4> q{};
    for (std::size_t key = 0; key < key_count; ++key) {
      const std::array<double, 4> before = q;
      q = rotation_at(numbers, rows.bits.data() + key * rows.row_bytes, rows.derived[lane]);
      if (key == 0) continue;
      const double dot = before[0] * q[0] + before[1] * q[1] + before[2] * q[2] + before[3] * q[3];
      largest[key - 1] = std::max(largest[key - 1], 1.0 - std::abs(dot));
    }
  }
  rows.power.resize(key_count);
  std::transform(largest.begin(), largest.end(), rows.power.begin(), slerp_power);
  if (std::all_of(rows.power.begin(), rows.power.end(), [](std::uint8_t p) { return p == kUsualSlerpPower; }))
    rows.power.assign(1, kUsualSlerpPower);
}

/// Calls `move(first byte of the row, bit in the row, bit in lane order, width)` for each number of each key.
template <class Move>
void each_number(const PackedRows& rows, std::size_t lanes, std::size_t key_count, const Move& move) {
  struct Places {
    std::size_t in_row, in_lane_order;
    std::uint32_t width;
  };
  std::vector<Places> places;
  std::size_t bit = 0;
  each_component(rows, lanes, component_count(rows),
                 [&](std::size_t lane, std::size_t, std::size_t slot, std::size_t at) {
                   const std::uint32_t width = width_of(rows.mask[at]);
                   if (width > 0) places.push_back({bit_of(rows, lanes, slot, lane), bit, width});
                   bit += width;
                 });
  for (std::size_t key = 0; key < key_count; ++key)
    for (const Places& p : places) move(key * rows.row_bytes, p.in_row, p.in_lane_order, p.width);
}

PackedRows empty_rows(std::span<const PackedTrack> tracks, std::size_t key_count) {
  CONTRACT(!tracks.empty() && tracks.size() <= kMostPackedLanes);
  PackedRows rows;
  make_tables(rows, tracks);
  place_numbers(rows, tracks);
  rows.bits.assign(key_count * rows.row_bytes + kReadAhead, 0);
  return rows;
}

}  // namespace

PackedRows packed_rows(std::span<const PackedTrack> tracks, std::size_t key_count) {
  PackedRows rows = empty_rows(tracks, key_count);
  const std::size_t lanes = tracks.size(), components = tracks.front().components;
  std::uint8_t* const bits = rows.bits.writable();
  each_component(rows, lanes, components, [&](std::size_t lane, std::size_t c, std::size_t slot, std::size_t at) {
    const std::uint32_t width = width_of(rows.mask[at]);
    if (width == 0) return;
    const std::size_t bit = bit_of(rows, lanes, slot, lane);
    for (std::size_t key = 0; key < key_count; ++key)
      write_bits(bits + key * rows.row_bytes, bit, tracks[lane].numbers[key * components + c]);
  });
  if (!rows.derived.empty()) find_powers(rows, lanes, key_count);
  return rows;
}

PackedRows packed_rows(std::span<const PackedTrack> tracks, std::span<const std::uint8_t> bits, std::size_t key_count) {
  PackedRows rows = empty_rows(tracks, key_count);
  CONTRACT(bits.size() == key_count * rows.row_bytes);
  std::vector<std::uint8_t> from(bits.begin(), bits.end());
  from.resize(from.size() + kReadAhead);
  std::uint8_t* const placed = rows.bits.writable();
  each_number(rows, tracks.size(), key_count,
              [&](std::size_t row, std::size_t in_row, std::size_t in_lane_order, std::uint32_t width) {
                write_bits(placed + row, in_row, read_bits(from.data() + row, in_lane_order, width));
              });
  if (!rows.derived.empty()) find_powers(rows, tracks.size(), key_count);
  return rows;
}

std::size_t packed_row_bytes(std::span<const PackedTrack> tracks) noexcept {
  std::size_t bits = 0;
  for (const PackedTrack& track : tracks) bits += track.bits_per_key();
  return (bits + 7) / 8;
}

PackedTrack packed_range(const PackedRows& rows, std::size_t lanes, std::size_t lane) {
  PackedTrack track;
  track.components = static_cast<std::uint32_t>(component_count(rows));
  track.derived = derived_of(rows, lane);
  const std::array<Number, 4> numbers = numbers_of(rows, lanes, lane);
  for (std::size_t c = 0; c < track.components; ++c) {
    if (c == track.derived) continue;
    const Number& number = numbers[slot_of(c, track.derived)];
    track.width[c] = static_cast<std::uint8_t>(number.width);
    track.low[c] = number.low;
    track.step[c] = number.step;
  }
  return track;
}

PackedTrack packed_lane(const PackedRows& rows, std::size_t lanes, std::size_t lane, std::size_t key_count) {
  PackedTrack track = packed_range(rows, lanes, lane);
  const std::array<Number, 4> numbers = numbers_of(rows, lanes, lane);
  track.numbers.reserve(key_count * track.components);
  for (std::size_t key = 0; key < key_count; ++key)
    for (std::size_t c = 0; c < track.components; ++c) {
      const Number& n = numbers[slot_of(c, track.derived)];
      const bool stored = c != track.derived;
      track.numbers.push_back(stored ? read_bits(rows.bits.data() + key * rows.row_bytes, n.bit, n.width) : 0);
    }
  return track;
}

std::vector<std::uint8_t> in_lane_order(const PackedRows& rows, std::size_t lanes, std::size_t key_count) {
  std::vector<std::uint8_t> bits(key_count * rows.row_bytes + kReadAhead, 0);
  each_number(rows, lanes, key_count,
              [&](std::size_t row, std::size_t in_row, std::size_t in_lane_order, std::uint32_t width) {
                write_bits(bits.data() + row, in_lane_order, read_bits(rows.bits.data() + row, in_row, width));
              });
  bits.resize(key_count * rows.row_bytes);
  return bits;
}

}  // namespace sinew
