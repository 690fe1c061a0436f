// SPDX-License-Identifier: MIT
#pragma once
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "runtime/clip/clip_file.h"

namespace sinew::test {

/// Updates size and checksum in the head, so that the loader reads an altered block.
inline void sign(std::vector<std::byte>& block) {
  const std::uint64_t sum = XXH3_64bits(block.data() + kClipFileHead, block.size() - kClipFileHead);
  const std::uint64_t size = block.size();
  std::memcpy(block.data() + 16, &size, 8);
  std::memcpy(block.data() + 24, &sum, 8);
}

/// The fields of a block with one compiled clip, so that a test can make each of them wrong. It is written from the
/// specification of the format, without the code that saves clips.
struct ClipFields {
  struct Tracks {
    std::uint8_t property, interpolation, packed;
    std::uint32_t target_count;
    std::vector<std::uint8_t> target_gaps;  ///< groups of seven bits
    std::vector<float> rows;
    std::vector<std::uint8_t> width, derived;
    std::vector<std::uint16_t> ranges;
    std::vector<std::uint8_t> bits;
  };
  struct Group {
    std::vector<float> times_s;
    std::vector<Tracks> blocks;
  };

  std::string name = "fields";
  double duration_s = 2.0;
  std::uint64_t joint_count = 4;
  std::uint32_t folded = 1;
  std::uint8_t certificate = 1;
  double lengths[4] = {1e-3, 5e-4, 1e-4, 0.5};
  std::uint32_t counts[3] = {2, 100, 3};
  std::uint64_t sizes[4] = {90, 40, 4000, 400};
  std::vector<double> event_times_s = {0.5, 2.0};
  std::string event_name = "step", curve_name = "width";
  std::uint8_t curve_blend = 1, curve_type = 0;  // a sum of floats
  float curve_time_s = 1.0f, curve_value = 3.0f;
  std::uint8_t curve_step = 0;
  std::vector<float> weights = {0.1f, 0.2f, 0.3f}, properties = {1.0f, 2.0f};
  std::vector<Group> groups;
  std::vector<float> translations, rotations, scales;  ///< rest values

  std::vector<std::byte> block() const {
    std::vector<std::byte> out;
    const auto add = [&](const auto& number) {
      const auto* bytes = reinterpret_cast<const std::byte*>(&number);
      out.insert(out.end(), bytes, bytes + sizeof(number));
    };
    // The distance of a number from the expected one, in floats, zigzag coded (0 1 2 3 4 for 0 -1 1 -2 2), as a
    // varint.
    const auto add_near = [&](float number, float expected) {
      std::int32_t bits = 0, expected_bits = 0;
      std::memcpy(&bits, &number, 4);
      std::memcpy(&expected_bits, &expected, 4);
      const auto gap = static_cast<std::int32_t>(static_cast<std::int64_t>(bits) - expected_bits);  // wraps at 32 bits
      std::uint64_t turned = static_cast<std::uint32_t>(gap < 0 ? ~(static_cast<std::int64_t>(gap) * 2)
                                                                : static_cast<std::int64_t>(gap) * 2);
      for (; turned > 127; turned /= 128) add(static_cast<std::uint8_t>(turned % 128 + 128));
      add(static_cast<std::uint8_t>(turned));
    };
    const auto add_rest = [&](const std::vector<float>& numbers, const std::vector<float>& identity) {
      add(static_cast<std::uint32_t>(numbers.size()));
      for (std::size_t i = 0; i < numbers.size(); ++i) add_near(numbers[i], identity[i % identity.size()]);
    };
    const auto add_all = [&](const auto& numbers) {
      add(static_cast<std::uint32_t>(numbers.size()));
      for (const auto& number : numbers) add(number);
    };
    for (const char c : {'S', 'I', 'N', 'E', 'W', 'C', 'L', 'P'}) add(c);
    add(std::uint32_t{4});
    add(std::uint32_t{0});
    add(std::uint64_t{0});
    add(std::uint64_t{0});
    add(std::uint32_t{1});  // number of clips
    add_all(name);
    add(duration_s);
    add(joint_count);
    add(folded);
    add(certificate);
    if (certificate != 0) {
      for (const double x : lengths) add(x);
      for (const std::uint32_t x : counts) add(x);
      for (const std::uint64_t x : sizes) add(x);
    }
    add_all(event_times_s);
    for (std::size_t e = 0; e < event_times_s.size(); ++e) add_all(event_name);
    add(std::uint32_t{1});  // number of curves
    add_all(curve_name);
    add(curve_blend);
    add(curve_type);
    add(std::uint32_t{1});  // number of keys
    add(curve_time_s);
    add(curve_step);
    add(curve_value);
    add_all(weights);
    add_all(properties);
    add(static_cast<std::uint32_t>(groups.size()));
    for (const Group& group : groups) {
      add(static_cast<std::uint32_t>(group.times_s.size()));
      for (std::size_t k = 0; k < group.times_s.size(); ++k)
        add_near(group.times_s[k], k < 2 ? 0.0f : 2.0f * group.times_s[k - 1] - group.times_s[k - 2]);
      add(static_cast<std::uint32_t>(group.blocks.size()));
      for (const Tracks& t : group.blocks) {
        add(t.property);
        add(t.interpolation);
        add(t.packed);
        add(t.target_count);
        for (const std::uint8_t gap : t.target_gaps) add(gap);
        if (t.packed == 0)
          add_all(t.rows);
        else {
          add_all(t.width);
          add_all(t.derived);
          add_all(t.ranges);
          add_all(t.bits);
        }
      }
    }
    add_rest(translations, {0.0f});
    add_rest(rotations, {0.0f, 0.0f, 0.0f, 1.0f});
    add_rest(scales, {1.0f});
    sign(out);
    return out;
  }
};

}  // namespace sinew::test
