// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/encode_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "importer/geometry_cache/unique_points.h"
#include "runtime/geometry_cache/block_headers.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

std::vector<std::uint8_t> random_then_zeros(std::size_t random_bytes, std::size_t zeros) {
  FixedRandom random(random_bytes + 1);
  std::vector<std::uint8_t> out(random_bytes + zeros, 0);
  for (std::size_t i = 0; i < random_bytes; ++i) out[i] = static_cast<std::uint8_t>(random.bits());
  return out;
}

TEST(store_bytes, by_zstd_exactly_where_that_saves_an_eighth) {
  Unpacker unpacker;
  std::size_t packed_from = 0;
  for (std::size_t zeros = 0; zeros <= 400; ++zeros) {
    const auto bytes = random_then_zeros(1000, zeros);
    std::vector<std::byte> out(3, std::byte(7));
    const std::uint32_t head = store_bytes(bytes, out);
    const std::uint32_t size = head & ~kStoredByZstd;
    ASSERT_EQ(out.size(), 3 + size);
    EXPECT_EQ(out[2], std::byte(7)) << "it is appended";
    std::vector<std::uint8_t> back(bytes.size());
    ASSERT_EQ(unpacker.unpack(std::span(out).subspan(3), head != size, back), bytes.size());
    EXPECT_EQ(back, bytes);
    if (head != size) {
      EXPECT_LT(size, bytes.size() - bytes.size() / 8);
      if (packed_from == 0) packed_from = zeros;
    } else {
      EXPECT_EQ(size, bytes.size());
      EXPECT_EQ(packed_from, 0u) << "once it pays, it goes on to";
    }
  }
  // zstd cannot shrink the 1000 random bytes. The z zeros take almost nothing, the zstd frame about 20 bytes. So
  // packing saves an eighth if 1020 < 7/8 (1000 + z), which holds from z = 166 on.
  EXPECT_GE(packed_from, 150u);
  EXPECT_LE(packed_from, 180u);
}

TEST(store_bytes, nothing_takes_nothing) {
  std::vector<std::byte> out;
  EXPECT_EQ(store_bytes({}, out), 0u);
  EXPECT_TRUE(out.empty());
}

/// The three unpacked sections of a frame of a stream.
std::array<std::vector<std::uint8_t>, kSections> sections_of(std::span<const std::byte> frame) {
  std::array<std::vector<std::uint8_t>, kSections> out;
  Unpacker unpacker;
  std::uint32_t heads[kSections];
  std::memcpy(heads, frame.data(), sizeof(heads));
  frame = frame.subspan(kSectionHeads);
  for (std::size_t s = 0; s < kSections; ++s) {
    const std::uint32_t size = heads[s] & ~kStoredByZstd;
    out[s].resize(1 << 20);
    out[s].resize(unpacker.unpack(frame.first(size), heads[s] != size, out[s]));
    frame = frame.subspan(size);
  }
  EXPECT_TRUE(frame.empty());
  return out;
}

std::vector<BlockMotion> blocks_of(const EncodedStream& stream, std::size_t frame, FramePlace place) {
  const auto sections = sections_of(stream.frames[frame]);
  std::vector<BlockMotion> blocks(stream.info.block_count());
  EXPECT_TRUE(read_block_headers(sections[0], sections[1], place, blocks)) << "frame " << frame;
  EXPECT_EQ(payload_bytes(blocks), sections[2].size());
  return blocks;
}

TEST(encode_stream, each_segment_begins_with_a_key_frame_and_the_largest_payload_is_named) {
  const GeometryTake take = noise_take(150, 8);
  for (const std::uint32_t segment : {1u, 2u, 3u, 20u}) {
    const EncodedStream out = encode_stream(take.meshes[0].streams[0], {}, 1e-3f, 0.9, segment);
    EXPECT_EQ(out.info.point_count, 150u);
    EXPECT_EQ(out.info.block_count(), 3u);
    EXPECT_EQ(out.info.step, 1e-3f);
    ASSERT_EQ(out.frames.size(), 8u);
    std::size_t largest = 0;
    for (std::size_t f = 0; f < 8; ++f) {
      const FramePlace place = f % segment == 0   ? FramePlace::key
                               : f % segment == 1 ? FramePlace::second
                                                  : FramePlace::later;
      blocks_of(out, f, place);
      largest = std::max(largest, sections_of(out.frames[f])[2].size());
    }
    EXPECT_EQ(out.info.most_payload, largest);
  }
}

TEST(encode_stream, points_that_go_on_evenly_are_linear_from_the_third_frame_of_a_segment) {
  // Each point has its own velocity, a whole number of steps.
  FixedRandom random(2);
  std::vector<glm::vec3> from, velocity;
  for (int p = 0; p < 64; ++p) {
    from.push_back(glm::round(random.vec3(-900, 900)));
    velocity.push_back(glm::round(random.vec3(-60, 60)));
  }
  TakeStream stream;
  for (int f = 0; f < 9; ++f) {
    auto& frame = stream.frames.emplace_back();
    for (std::size_t p = 0; p < 64; ++p) frame.push_back(from[p] + static_cast<float>(f) * velocity[p]);
  }
  const EncodedStream out = encode_stream(stream, {}, 1.0f, 0.8660254037844387, 5);
  for (const std::size_t f : {2u, 3u, 4u, 7u, 8u}) {
    const BlockMotion block = blocks_of(out, f, FramePlace::later)[0];
    EXPECT_EQ(block.base, BlockBase::linear) << f;
    EXPECT_EQ(block.width, (std::array<std::uint8_t, 3>{})) << f;
    EXPECT_TRUE(sections_of(out.frames[f])[2].empty());
  }
  EXPECT_EQ(blocks_of(out, 1, FramePlace::second)[0].base, BlockBase::last);
  EXPECT_EQ(blocks_of(out, 6, FramePlace::second)[0].base, BlockBase::last);
}

TEST(unique_points, vertices_that_differ_in_any_frame_by_any_bit_are_apart) {
  using Frames = std::vector<std::vector<glm::vec3>>;
  const glm::vec3 a(1, 2, 3), b(4, 5, 6);
  const auto points = [](const Frames& frames) { return find_unique_points(frames).point_of_vertex; };
  using Points = std::vector<std::uint32_t>;
  EXPECT_EQ(points({{a, b, a, b, a}}), (Points{0, 1, 0, 1, 0}));
  EXPECT_EQ(points({{a, a, a}, {b, a, b}}), (Points{0, 1, 0}));
  EXPECT_EQ(points({{a, a, a}, {a, a, a}, {a, a, b}}), (Points{0, 0, 1}));
  EXPECT_EQ(points({{glm::vec3(0.0f), glm::vec3(-0.0f)}}), (Points{0, 1}));
  EXPECT_EQ(points({{a, b}, {b, a}}), (Points{0, 1})) << "the order of frames counts";
  EXPECT_EQ(find_unique_points(Frames{{b, a, b, a}}).vertex_of_point, (Points{0, 1}));
  EXPECT_TRUE(find_unique_points(Frames{}).point_of_vertex.empty());
}

}  // namespace
}  // namespace sinew::test
