// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_decoder.h"

#include <gtest/gtest.h>

#include <span>
#include <utility>
#include <vector>

#include "runtime/base/same_bits.h"
#include "tests/geometry_cache/takes.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

using Points = std::vector<glm::vec3>;

/// A baked flag of 40 frames in segments of 8, and its frames decoded in order.
class geometry_decoder : public testing::Test {
 protected:
  geometry_decoder() : file_(*encode_geometry_cache(flag_take(), {.segment_frames = 8})) {
    for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
      EXPECT_EQ(decoder_.decode(f, source_), GeometryStatus::ok);
      forward_.push_back(points());
    }
  }

  Points points() {
    Points out(cache_.meshes()[0].streams[0].point_count);
    EXPECT_EQ(decoder_.write_points(0, out), GeometryStatus::ok);
    return out;
  }
  void expect_frame(std::uint32_t frame) {
    EXPECT_EQ(decoder_.frame(), frame);
    EXPECT_TRUE(same_bits<glm::vec3>(points(), forward_[frame])) << "frame " << frame;
  }

  std::vector<std::byte> file_;
  GeometryCache cache_ = *GeometryCache::open(file_);
  GeometryDecoder decoder_{cache_};
  MappedFrames source_{cache_, file_};
  std::vector<Points> forward_;
};

TEST_F(geometry_decoder, forward_takes_one_frame_of_work_each) {
  EXPECT_EQ(decoder_.frames_decoded(), cache_.frame_count());
  EXPECT_EQ(decoder_.decode(39, source_), GeometryStatus::ok);
  EXPECT_EQ(decoder_.frames_decoded(), cache_.frame_count()) << "the frame that is held costs nothing";
}

TEST_F(geometry_decoder, any_seek_has_the_bits_of_forward_decoding) {
  for (std::uint32_t from = 0; from < cache_.frame_count(); ++from)
    for (std::uint32_t to = 0; to < cache_.frame_count(); ++to) {
      ASSERT_EQ(decoder_.decode(from, source_), GeometryStatus::ok);
      const std::uint64_t before = decoder_.frames_decoded();
      ASSERT_EQ(decoder_.decode(to, source_), GeometryStatus::ok);
      ASSERT_LE(decoder_.frames_decoded() - before, cache_.segment_frames());
      expect_frame(to);
    }
}

TEST_F(geometry_decoder, of_a_file_that_is_cut_off_has_the_frames_before_the_cut) {
  for (std::uint32_t cut_in = 0; cut_in < cache_.frame_count(); ++cut_in) {
    const GeometryFrame& last = cache_.frames()[cut_in];
    for (const std::uint64_t bytes : {last.offset - 1, last.offset + last.size - 1}) {
      MappedFrames rest{cache_, std::span(file_).first(bytes)};
      const FrameSource source = rest;
      for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
        const GeometryFrame& frame = cache_.frames()[f];
        EXPECT_EQ(source.bytes(source.context, f).size(), frame.offset + frame.size <= bytes ? frame.size : 0u);
      }
    }
  }
}

TEST_F(geometry_decoder, backwards_has_the_bits_of_forward) {
  for (std::uint32_t f = cache_.frame_count(); f-- > 0;) {
    ASSERT_EQ(decoder_.decode(f, source_), GeometryStatus::ok);
    expect_frame(f);
  }
}

TEST_F(geometry_decoder, every_instruction_set_has_the_same_bits) {
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
      ASSERT_EQ(decoder_.decode(f, source_), GeometryStatus::ok);
      ASSERT_TRUE(same_bits<glm::vec3>(points(), forward_[f])) << simd_name(target) << ", frame " << f;
    }
  }
}

TEST_F(geometry_decoder, frames_allocate_nothing) {
  Points out(forward_[0].size()), vertices(cache_.meshes()[0].vertex_count);
  const AllocationCounter counter;
  for (const std::uint32_t f : {0u, 1u, 2u, 30u, 7u, 39u}) {
    decoder_.decode(f, source_);
    decoder_.write_points(0, out);
    decoder_.write_vertices(0, vertices);
  }
  EXPECT_EQ(counter.count(), 0u);
}

TEST_F(geometry_decoder, between_frames_lie_on_the_line_between_them) {
  for (const double at : {0.25, 6.5, 7.75, 8.125, 38.5, 3.5}) {  // also across segments, and backwards
    ASSERT_EQ(decoder_.decode_time(cache_.start_s() + at * cache_.frame_s(), source_), GeometryStatus::ok);
    const auto frame = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(frame);
    EXPECT_NEAR(decoder_.part(), part, 1e-5);
    const Points shown = points();
    for (std::size_t p = 0; p < shown.size(); ++p)
      for (int axis = 0; axis < 3; ++axis) {
        const double a = forward_[frame][p][axis], b = forward_[frame + 1][p][axis];
        ASSERT_NEAR(shown[p][axis], a + part * (b - a), 2e-6 + 1e-5 * std::abs(b - a))
            << "time " << at << " point " << p;
      }
  }
}

TEST_F(geometry_decoder, a_time_before_a_key_frame_that_was_sought_alone_decodes_the_frame_before_it) {
  const double before_key_s = cache_.start_s() + 7.5 * cache_.frame_s();
  ASSERT_EQ(decoder_.decode_time(before_key_s, source_), GeometryStatus::ok);
  const Points expected = points();
  ASSERT_EQ(decoder_.decode(30, source_), GeometryStatus::ok);
  ASSERT_EQ(decoder_.decode(8, source_), GeometryStatus::ok);
  EXPECT_EQ(decoder_.next_for_time(before_key_s), 0u) << "the frames before the key";
  ASSERT_EQ(decoder_.decode_time(before_key_s, source_), GeometryStatus::ok);
  EXPECT_TRUE(same_bits<glm::vec3>(points(), expected));
  EXPECT_EQ(decoder_.next_for_time(before_key_s), 9u);
}

TEST_F(geometry_decoder, times_outside_are_clamped_and_whole_frames_are_exact) {
  ASSERT_EQ(decoder_.decode_time(-5.0, source_), GeometryStatus::ok);
  expect_frame(0);
  ASSERT_EQ(decoder_.decode_time(1e9, source_), GeometryStatus::ok);
  expect_frame(39);
  EXPECT_EQ(decoder_.decode_time(std::nan(""), source_), GeometryStatus::out_of_range);
}

TEST_F(geometry_decoder, time_that_goes_on_by_parts_of_a_frame_decodes_each_frame_once) {
  GeometryDecoder decoder(cache_);
  for (double at = 0.0; at < 39.0; at += 0.1)
    ASSERT_EQ(decoder.decode_time(at * cache_.frame_s(), source_), GeometryStatus::ok);
  EXPECT_EQ(decoder.frames_decoded(), 40u);
}

TEST_F(geometry_decoder, moved_to_another_place_it_goes_on_with_the_frame_that_it_holds) {
  ASSERT_EQ(decoder_.decode_time(cache_.start_s() + 11.25 * cache_.frame_s(), source_), GeometryStatus::ok);
  const Points shown = points();
  GeometryDecoder moved(std::move(decoder_));
  EXPECT_EQ(moved.frame(), 12u);
  EXPECT_EQ(moved.part(), 0.25f);
  Points out(shown.size());
  ASSERT_EQ(moved.write_points(0, out), GeometryStatus::ok);
  EXPECT_TRUE(same_bits<glm::vec3>(out, shown));
  const std::uint64_t before = moved.frames_decoded();
  ASSERT_EQ(moved.decode(13, source_), GeometryStatus::ok);
  EXPECT_EQ(moved.frames_decoded(), before + 1);
  ASSERT_EQ(moved.write_points(0, out), GeometryStatus::ok);
  EXPECT_TRUE(same_bits<glm::vec3>(out, forward_[13]));
}

TEST_F(geometry_decoder, bad_calls_change_nothing) {
  ASSERT_EQ(decoder_.decode(12, source_), GeometryStatus::ok);
  EXPECT_EQ(decoder_.decode(40, source_), GeometryStatus::out_of_range);
  Points shorter(forward_[0].size() - 1), vertices(cache_.meshes()[0].vertex_count + 1);
  EXPECT_EQ(decoder_.write_points(0, shorter), GeometryStatus::size_mismatch);
  EXPECT_EQ(decoder_.write_points(1, shorter), GeometryStatus::out_of_range);
  EXPECT_EQ(decoder_.write_vertices(0, vertices), GeometryStatus::size_mismatch);
  expect_frame(12);
  GeometryDecoder fresh(cache_);
  Points whole(forward_[0].size());
  EXPECT_EQ(fresh.write_points(0, whole), GeometryStatus::out_of_range) << "it holds no frame yet";
}

TEST_F(geometry_decoder, bounds_hold_every_vertex_and_are_known_before) {
  const Aabb all = cache_.meshes()[0].bounds;
  for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
    const Aabb box = cache_.bounds(f, 0);
    for (const glm::vec3& p : forward_[f])
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_GE(p[axis], box.lower[axis]) << "frame " << f;
        ASSERT_LE(p[axis], box.upper[axis]) << "frame " << f;
      }
    Aabb tight;
    for (const glm::vec3& p : forward_[f]) tight.add(p);
    for (int axis = 0; axis < 3; ++axis) {
      const float slack = (all.upper[axis] - all.lower[axis]) * 4e-5f + 1e-6f;
      EXPECT_LT(tight.lower[axis] - box.lower[axis], slack);
      EXPECT_LT(box.upper[axis] - tight.upper[axis], slack);
    }
  }
}

/// A source that has only the frames below a limit.
struct SomeFrames {
  FrameSource all;
  std::uint32_t limit = 0;

  operator FrameSource() noexcept {
    const auto bytes_of = [](void* context, std::uint32_t frame) noexcept -> std::span<const std::byte> {
      const auto* some = static_cast<const SomeFrames*>(context);
      if (frame >= some->limit) return {};
      return some->all.bytes(some->all.context, frame);
    };
    return {bytes_of, this};
  }
};

TEST_F(geometry_decoder, a_frame_that_is_not_there_leaves_the_newest_that_is) {
  SomeFrames some{source_};
  GeometryDecoder decoder(cache_);
  EXPECT_EQ(decoder.decode(3, some), GeometryStatus::not_loaded);
  EXPECT_EQ(decoder.frame(), kNone);
  some.limit = 6;
  EXPECT_EQ(decoder.decode(7, some), GeometryStatus::not_loaded);
  EXPECT_EQ(decoder.frame(), 5u);
  EXPECT_EQ(decoder.decode(20, some), GeometryStatus::not_loaded);
  EXPECT_EQ(decoder.frame(), 5u);
  some.limit = 12;
  EXPECT_EQ(decoder.decode(20, some), GeometryStatus::not_loaded);
  EXPECT_EQ(decoder.frame(), 11u);
  Points out(forward_[0].size());
  ASSERT_EQ(decoder.write_points(0, out), GeometryStatus::ok);
  EXPECT_TRUE(same_bits<glm::vec3>(out, forward_[11]));
}

}  // namespace
}  // namespace sinew::test
