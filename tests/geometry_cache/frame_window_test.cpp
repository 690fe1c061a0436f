// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/frame_window.h"

#include <gtest/gtest.h>

#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/geometry_cache/block_motion.h"
#include "tests/geometry_cache/disk.h"
#include "tests/geometry_cache/takes.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

class frame_window : public testing::Test {
 protected:
  frame_window() : disk_{*encode_geometry_cache(flag_take(20), {.segment_frames = 8})} {
    disk_.waiting.reserve(64);
    MappedFrames mapped{cache_, disk_.file};
    GeometryDecoder decoder(cache_);
    for (std::uint32_t f = 0; f < cache_.frame_count(); ++f) {
      EXPECT_EQ(decoder.decode(f, mapped), GeometryStatus::ok);
      truth_.push_back(points(decoder));
    }
  }
  std::vector<glm::vec3> points(const GeometryDecoder& decoder) const {
    std::vector<glm::vec3> out(cache_.meshes()[0].streams[0].point_count);
    EXPECT_EQ(decoder.write_points(0, out), GeometryStatus::ok);
    return out;
  }
  void expect_shown(const GeometryDecoder& decoder, std::uint32_t frame) const {
    ASSERT_EQ(decoder.frame(), frame);
    ASSERT_TRUE(same_bits<glm::vec3>(points(decoder), truth_[frame])) << "frame " << frame;
  }

  Disk disk_;
  GeometryCache cache_ = *GeometryCache::open(disk_.file);
  std::vector<std::vector<glm::vec3>> truth_;
};

TEST_F(frame_window, plays_and_loops_with_the_bits_of_the_mapped_file_and_reads_each_frame_once) {
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 4);
  for (std::uint32_t shown = 0; shown < 60; ++shown) {
    const std::uint32_t frame = shown % 20;
    window.prefetch(decoder.next_for(frame));
    ASSERT_EQ(decoder.decode(frame, window), GeometryStatus::ok);
    expect_shown(decoder, frame);
  }
  EXPECT_EQ(disk_.reads, 60u + 3u) << "each frame, and three that were ahead at the end";
}

TEST_F(frame_window, seeks_read_what_they_need_at_once) {
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 3);
  FixedRandom random(4);
  for (int k = 0; k < 100; ++k) {
    const std::uint32_t frame = random.below(20);
    window.prefetch(decoder.next_for(frame));
    ASSERT_EQ(decoder.decode(frame, window), GeometryStatus::ok);
    expect_shown(decoder, frame);
  }
}

TEST_F(frame_window, a_late_reader_shows_the_newest_frame_and_catches_up) {
  disk_.at_once = false;
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 6);
  const auto show = [&](std::uint32_t frame) {
    window.prefetch(decoder.next_for(frame));
    return decoder.decode(frame, window);
  };
  EXPECT_EQ(show(0), GeometryStatus::not_loaded);
  EXPECT_EQ(decoder.frame(), kNone);
  EXPECT_EQ(window.pending_reads(), 6u);
  disk_.deliver(3);
  EXPECT_EQ(show(0), GeometryStatus::ok);
  EXPECT_EQ(show(5), GeometryStatus::not_loaded);
  expect_shown(decoder, 2);
  disk_.deliver(100);
  EXPECT_EQ(show(5), GeometryStatus::ok);
  expect_shown(decoder, 5);
  disk_.deliver(100);
  EXPECT_EQ(window.pending_reads(), 0u);
}

TEST_F(frame_window, a_loop_does_not_wait_at_its_seam) {
  disk_.at_once = false;
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 4);
  window.prefetch(0);
  disk_.deliver(100);
  for (std::uint32_t shown = 0; shown < 50; ++shown) {  // a read takes two frames
    const std::uint32_t frame = shown % 20;
    window.prefetch(decoder.next_for(frame));
    ASSERT_EQ(decoder.decode(frame, window), GeometryStatus::ok) << "frame " << shown;
    if (shown % 2 == 1) disk_.deliver(100);
  }
  disk_.deliver(100);
}

TEST_F(frame_window, a_failed_read_is_asked_for_again) {
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 2);
  disk_.failures = 5;
  GeometryStatus status = GeometryStatus::not_loaded;
  for (int k = 0; k < 4 && status != GeometryStatus::ok; ++k) {
    window.prefetch(decoder.next_for(0));
    status = decoder.decode(0, window);
  }
  EXPECT_EQ(status, GeometryStatus::ok);
  expect_shown(decoder, 0);
}

TEST_F(frame_window, that_waits_for_all_of_its_reads_asks_for_nothing_more) {
  disk_.at_once = false;
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 3);
  window.prefetch(0);
  ASSERT_EQ(window.pending_reads(), 3u);
  const std::uint64_t asked = window.bytes_requested();
  window.prefetch(8);  // a seek before any read has finished
  EXPECT_EQ(decoder.decode(8, window), GeometryStatus::not_loaded);
  EXPECT_EQ(window.bytes_requested(), asked);
  EXPECT_EQ(disk_.reads, 3u);
  disk_.deliver(100);
  window.prefetch(8);
  disk_.deliver(100);
  EXPECT_EQ(decoder.decode(8, window), GeometryStatus::ok);
  expect_shown(decoder, 8);
}

TEST_F(frame_window, two_caches_share_one_reader) {
  disk_.at_once = false;
  GeometryDecoder one(cache_), other(cache_);
  FrameWindow first(cache_, disk_.reader(), 4), second(cache_, disk_.reader(), 4);
  for (std::uint32_t shown = 0; shown < 40; ++shown) {
    const std::uint32_t a = shown % 20, b = (shown + 7) % 20;
    first.prefetch(one.next_for(a));
    second.prefetch(other.next_for(b));
    disk_.deliver(100);
    ASSERT_EQ(one.decode(a, first), GeometryStatus::ok);
    while (other.decode(b, second) == GeometryStatus::not_loaded) {
      second.prefetch(other.next_for(b));
      disk_.deliver(100);
    }
    expect_shown(one, a);
    expect_shown(other, b);
  }
  disk_.deliver(100);
}

TEST_F(frame_window, playing_allocates_nothing) {
  GeometryDecoder decoder(cache_);
  FrameWindow window(cache_, disk_.reader(), 4);
  const AllocationCounter counter;
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    window.prefetch(decoder.next_for(frame));
    decoder.decode(frame, window);
  }
  EXPECT_EQ(counter.count(), 0u);
}

/// Memory and reads for playing a cache of some length once, as an engine streams it.
struct Played {
  std::size_t decoder_bytes = 0, window_bytes = 0, largest_frame = 0, allocations = 0;
  std::uint64_t file_bytes = 0, frames_decoded = 0;
};

Played play_through(std::uint32_t frames, std::uint32_t window_frames) {
  GeometryTake take = noise_take(12, 1);
  auto& all = take.meshes[0].streams[0].frames;
  all.assign(frames, all[0]);
  FixedRandom random(1);
  for (std::uint32_t f = 1; f < frames; ++f)
    for (std::size_t v = 0; v < 12; ++v) all[f][v] = all[f - 1][v] + 1e-3f * random.vec3();
  Disk disk{*encode_geometry_cache(take)};
  const auto cache = GeometryCache::open(disk.file);
  GeometryDecoder decoder(*cache);
  FrameWindow window(*cache, disk.reader(), window_frames);
  std::vector<glm::vec3> shown(12);
  const AllocationCounter counter;
  for (std::uint32_t f = 0; f < frames; ++f) {
    window.prefetch(decoder.next_for(f));
    if (decoder.decode(f, window) == GeometryStatus::ok) decoder.write_vertices(0, shown);
  }
  return {decoder.memory_bytes(), window.memory_bytes(), cache->largest_frame(),
          counter.count(),        cache->file_bytes(),   decoder.frames_decoded()};
}

TEST(frame_window_length, ten_minutes_take_the_memory_of_ten_seconds_and_allocate_nothing) {
  constexpr std::uint32_t kTenMinutes = 18'000, kTenSeconds = 300, kWindow = 8;
  const Played shorter = play_through(kTenSeconds, kWindow), longer = play_through(kTenMinutes, kWindow);
  EXPECT_EQ(longer.frames_decoded, kTenMinutes);
  EXPECT_GT(longer.file_bytes, 50 * shorter.file_bytes);
  for (const Played& played : {shorter, longer}) {
    EXPECT_EQ(played.allocations, 0u);
    EXPECT_EQ(played.window_bytes, kWindow * played.largest_frame);
  }
  // Only the size of the largest frame differs, by chance.
  EXPECT_LE(longer.decoder_bytes, shorter.decoder_bytes + kBlockNumbers * sizeof(std::int32_t));
  EXPECT_LE(longer.window_bytes, shorter.window_bytes * 5 / 4);
}

}  // namespace
}  // namespace sinew::test
