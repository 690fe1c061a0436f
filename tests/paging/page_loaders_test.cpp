// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/paging/paged_clip.h"
#include "tests/clip/varied_clip.h"
#include "tests/paging/pages.h"

namespace sinew {
namespace {

constexpr double kLoaderPage_s = 0.25;

TEST(page_loaders, several_threads_load_while_another_plays) {
  const Clip whole = test::varied_clip(1);
  const auto pages = test::pages_of(whole, kLoaderPage_s);
  PagedClip paged(first_keys(whole), kLoaderPage_s, pages.size());
  std::atomic<bool> is_over = false;
  std::atomic<std::size_t> errors = 0;
  const auto load = [&] {
    while (!is_over) {
      if (const auto page = paged.next_page(); page && !paged.load_page(*page, pages[*page])) ++errors;
      std::this_thread::yield();
    }
  };
  std::vector<std::thread> loaders;
  for (int i = 0; i < 2; ++i) loaders.emplace_back(load);
  test::FixedRandom random(2);
  std::size_t shown = 0, wrong = 0;
  for (double t = 0.0; shown < 400 && errors == 0;) {
    const PageSample at = paged.at(t);
    wrong += !same_bits<float>(test::numbers_at(at.page, at.time_s), test::numbers_at(whole, at.time_s));
    wrong += paged.loaded_pages() > 4;
    if (at.is_missing) {
      std::this_thread::yield();
      continue;
    }
    ++shown;
    t = random.below(20) == 0 ? random.in(0.0, 4.0) : std::fmod(t + 0.05, 4.0);
  }
  is_over = true;
  for (std::thread& loader : loaders) loader.join();
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(errors, 0u);
}

}  // namespace
}  // namespace sinew
