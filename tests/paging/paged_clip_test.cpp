// SPDX-License-Identifier: MIT
#include "runtime/paging/paged_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "tests/clip/varied_clip.h"
#include "tests/paging/pages.h"
#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

using test::numbers_at;
using test::varied_clip;

constexpr double kPage_s = 0.5;  // a clip of 4 s has eight pages

struct PagedTest : testing::Test {
  const Clip whole = varied_clip(1);
  const std::vector<std::vector<std::byte>> bytes = test::pages_of(whole, kPage_s);

  PagedClip paged(PagedClip::Options options = {}) const { return {first_keys(whole), kPage_s, bytes.size(), options}; }
  bool load(PagedClip& clip, std::size_t page) const { return clip.load_page(page, bytes[page]).value(); }
  /// Loads all pages of the window; returns them in the order of loading.
  std::vector<std::size_t> load_all(PagedClip& clip) const {
    std::vector<std::size_t> pages;
    while (const auto page = clip.next_page()) {
      pages.push_back(*page);
      EXPECT_TRUE(load(clip, *page));
    }
    return pages;
  }
  void expect_shows(const PageSample& at, double time_s, bool is_missing) const {
    EXPECT_EQ(at.is_missing, is_missing);
    EXPECT_EQ(at.time_s, time_s);
    EXPECT_TRUE(same_bits<float>(numbers_at(at.page, at.time_s), numbers_at(whole, time_s))) << time_s;
  }
};

using Pages = std::vector<std::size_t>;

TEST_F(PagedTest, pages_are_asked_for_in_the_order_in_which_they_are_needed) {
  PagedClip clip = paged();
  clip.at(1.1);
  EXPECT_EQ(load_all(clip), (Pages{2, 3, 4, 1}));
  EXPECT_EQ(clip.next_page(), std::nullopt);
  clip.at(1.6);
  EXPECT_EQ(load_all(clip), (Pages{5})) << "2 is now the one before";
  clip.at(3.9);
  EXPECT_EQ(load_all(clip), (Pages{7, 0, 1, 6})) << "the loop goes on at the first page";
  clip.at(0.7, true);
  EXPECT_EQ(load_all(clip), (Pages{2})) << "backwards: 1, 0, 7, and 2 behind";
  EXPECT_EQ(clip.loaded_pages(), 4u);
}

TEST_F(PagedTest, without_a_loop_no_page_follows_the_last) {
  PagedClip clip = paged({.window = 3, .loops = false});
  clip.at(3.9);
  EXPECT_EQ(load_all(clip), (Pages{7, 6}));
  clip.at(-3.0);
  EXPECT_EQ(load_all(clip), (Pages{0, 1}));
  clip.at(1e9);
  EXPECT_EQ(load_all(clip), (Pages{7})) << "6 is there still";
  PagedClip pair = paged({.window = 2});
  pair.at(2.0);
  EXPECT_EQ(load_all(pair), (Pages{4, 5})) << "no room for the one before";
}

TEST_F(PagedTest, a_loaded_page_shows_the_bits_of_the_whole_clip) {
  PagedClip clip = paged();
  for (const double step_s : {0.031, 0.49, -0.031, 1.3})
    for (double t = step_s > 0 ? -0.1 : 4.2; t > -0.2 && t < 4.3; t += step_s) {
      clip.at(t, step_s < 0);
      load_all(clip);
      expect_shows(clip.at(t, step_s < 0), t, false);
    }
}

TEST_F(PagedTest, a_missing_page_shows_the_nearest_pose_that_is_there_and_says_so) {
  PagedClip clip = paged();
  expect_shows(clip.at(2.2), 0.0, true);  // the start of the clip, from the head
  clip.at(1.2);
  load(clip, 2);  // 1.0 to 1.5 s
  expect_shows(clip.at(1.7), 1.5, true);
  expect_shows(clip.at(0.3), 1.0, true);
  clip.at(2.6);
  load(clip, 5);  // 2.5 to 3.0 s
  expect_shows(clip.at(2.3), 2.5, true);
  expect_shows(clip.at(1.6), 1.5, true);
  expect_shows(clip.at(9.0), 3.0, true);
  expect_shows(clip.at(2.75), 2.75, false);
}

TEST_F(PagedTest, a_page_that_the_window_has_left_is_not_taken) {
  PagedClip clip = paged();
  clip.at(0.1);  // the window is pages 0, 1, 2 and 7
  EXPECT_FALSE(load(clip, 4));
  EXPECT_EQ(clip.loaded_pages(), 0u);
  EXPECT_TRUE(load(clip, 7));
  EXPECT_TRUE(load(clip, 7)) << "again";
  EXPECT_EQ(clip.loaded_pages(), 1u);
}

TEST_F(PagedTest, memory_never_exceeds_the_window) {
  PagedClip clip = paged({.window = 3});
  std::size_t largest = 0;
  for (const std::vector<std::byte>& page : bytes) largest = std::max(largest, load_clips(page)->front().byte_size());
  test::FixedRandom random(5);
  for (int i = 0; i < 300; ++i) {
    clip.at(0.01 * random.below(420), random.below(2) == 0);
    for (std::uint32_t loads = random.below(5); loads > 0; --loads)
      if (const auto page = clip.next_page()) load(clip, *page);
    load(clip, random.below(8));
    ASSERT_LE(clip.loaded_pages(), 3u);
    ASSERT_LE(clip.loaded_bytes(), 3 * largest);
  }
}

TEST_F(PagedTest, loaded_bytes_are_those_of_the_pages) {
  PagedClip clip = paged();
  clip.at(0.0);
  EXPECT_EQ(clip.loaded_bytes(), 0u);
  load(clip, 0);
  EXPECT_EQ(clip.loaded_bytes(), clip.at(0.0).page.byte_size());
  load(clip, 1);
  EXPECT_EQ(clip.loaded_bytes(), clip.at(0.0).page.byte_size() + clip.at(0.5).page.byte_size());
}

TEST_F(PagedTest, a_sample_keeps_its_keys_while_pages_go) {
  PagedClip clip = paged({.window = 2});
  clip.at(0.2);
  load_all(clip);
  const PageSample first = clip.at(0.2);
  for (const double t : {1.2, 2.2, 3.2}) {
    clip.at(t);
    load_all(clip);
  }
  expect_shows(first, 0.2, false);
}

TEST_F(PagedTest, pages_share_the_numbers_at_rest_of_the_head) {
  const Clip head = first_keys(whole);
  PagedClip clip(head, kPage_s, bytes.size());
  clip.at(0.0);
  load_all(clip);
  EXPECT_EQ(clip.at(0.0).page.layout().base_pose.rest(), head.layout().base_pose.rest());
  EXPECT_EQ(clip.at(0.0).page.layout().base_weights.rest(), head.layout().base_weights.rest());
}

TEST_F(PagedTest, playing_allocates_nothing) {
  PagedClip clip = paged();
  clip.at(0.0);
  load_all(clip);
  const test::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) clip.at(0.04 * i);
  EXPECT_EQ(allocations.count(), 0u);
}

TEST_F(PagedTest, a_block_that_is_another_page_is_refused_by_name) {
  PagedClip clip = paged();
  clip.at(0.0);
  const auto refused = [&](std::size_t page, std::span<const std::byte> block) {
    const auto taken = clip.load_page(page, block);
    return taken ? "taken" : taken.error().rule + ": " + taken.error().detail;
  };
  EXPECT_EQ(refused(0, bytes[1]), R"(clip-page: the block is not page "varied [0]", but "varied [1]")");
  EXPECT_EQ(refused(0, save_clips({})), R"(clip-page: the block is not page "varied [0]")");
  const auto others = test::pages_of(varied_clip(2), kPage_s);
  EXPECT_EQ(refused(0, others[0]), R"(clip-page: page "varied [0]" does not move what its clip moves)");
  std::vector<std::byte> damaged = bytes[0];
  damaged.back() ^= std::byte{1};
  EXPECT_EQ(refused(0, damaged).substr(0, 13), "clip-checksum");
  EXPECT_EQ(clip.loaded_pages(), 0u);
  EXPECT_EQ(refused(0, bytes[0]), "taken");
}

TEST(paged_clip, pages_have_a_length_and_the_window_holds_two) {
  const auto code = [](double page_s, std::size_t count, std::size_t window) {
    return PagedClip::check(page_s, count, {.window = window});
  };
  EXPECT_EQ(code(0.1, 1, 2), ErrorCode::ok);
  EXPECT_EQ(code(0.1, 0, 2), ErrorCode::unsupported);
  EXPECT_EQ(code(0.1, 1, 1), ErrorCode::unsupported);
  for (const double bad : {0.0, -0.1, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_EQ(code(bad, 1, 2), ErrorCode::unsupported);
}

TEST(page_table, a_whole_clip_has_no_page) {
  EXPECT_EQ(PageTable{}.page_count(), 0u);
  EXPECT_EQ((PageTable{1.0, {64, 80, 99}}.page_count()), 2u);
}

TEST(page_table, times_fall_on_the_page_that_has_their_keys) {
  EXPECT_EQ(page_count_of(4.0, 0.5), 8u);
  EXPECT_EQ(page_count_of(4.1, 0.5), 9u);
  EXPECT_EQ(page_count_of(0.0, 0.5), 1u);
  EXPECT_EQ(page_count_of(1.0, 1e-300), std::size_t{1} << 53) << "as the table of a damaged file may say";
  EXPECT_EQ(page_count_of(1e300, 5e-324), std::size_t{1} << 53) << "infinitely many";
  EXPECT_EQ(page_at(-1.0, 0.5, 8), 0u);
  EXPECT_EQ(page_at(0.49, 0.5, 8), 0u);
  EXPECT_EQ(page_at(0.5, 0.5, 8), 1u) << "of two pages the later one";
  EXPECT_EQ(page_at(4.0, 0.5, 8), 7u);
  EXPECT_EQ(page_at(1e300, 0.5, 8), 7u);
  EXPECT_EQ(page_at(std::nan(""), 0.5, 8), 0u);
  for (std::size_t page = 0; page < 8; ++page) {
    const PageTimes times = times_of_page(page, 0.1, 8);
    for (double t = -0.05; t < 1.0; t += 0.0123)
      EXPECT_TRUE(page_at(t, 0.1, 8) != page || times.nearest(t) == t) << page;
  }
}

}  // namespace
}  // namespace sinew
