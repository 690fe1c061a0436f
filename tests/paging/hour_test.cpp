// SPDX-License-Identifier: MIT
// A clip of one hour at 30 Hz plays from a window of four pages of four seconds.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/base/same_bits.h"
#include "runtime/paging/paged_clip.h"
#include "tests/paging/pages.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr std::uint32_t kJoints = 8, kKeys = 3600 * 30 + 1;
constexpr double kHourPage_s = 4.0;

Clip clip_of_an_hour() {
  std::vector<float> times_s;
  for (std::uint32_t k = 0; k < kKeys; ++k) times_s.push_back(static_cast<float>(k / 30.0));
  Animation animation;
  animation.name = "hour";
  animation.duration_s = 3600.0;
  KeyTolerances rounding;
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    BoneAnimation bone{.joint = j, .rotation = {Interpolation::linear, times_s, {}}};
    if (j == 0) bone.translation = {Interpolation::linear, times_s, {}};
    for (std::uint32_t k = 0; k < kKeys; ++k) {
      const double t = k / 30.0, angle = std::sin(t * (1.0 + 0.1 * j)) + 0.3 * std::sin(7.3 * t + j);
      bone.rotation.values.push_back(glm::angleAxis(static_cast<float>(angle), glm::vec3(0.6f, 0.0f, 0.8f)));
      if (j == 0) bone.translation.values.emplace_back(std::sin(0.01 * t), std::cos(0.3 * t), 0.1 * std::sin(5.0 * t));
    }
    animation.bones.push_back(std::move(bone));
    rounding.bones.push_back({1e-4, j == 3 ? 0.0 : 1e-4, 0.0});
  }
  return compile_clip(animation, test::chain_skeleton(kJoints), {}, std::vector<std::uint32_t>{0}, {}, rounding);
}

struct HourTest : testing::Test {
  static void SetUpTestSuite() {
    whole = new Clip(clip_of_an_hour());
    pages = new std::vector<std::vector<std::byte>>(test::pages_of(*whole, kHourPage_s));
  }
  static void TearDownTestSuite() {
    delete whole;
    delete pages;
  }
  static bool same(const PageSample& at, double time_s) {
    static test::PoseBuffer a(kJoints), b(kJoints);
    EXPECT_EQ(run(SampleClipJob{&at.page, at.time_s, a.span(), {}}), ErrorCode::ok);
    EXPECT_EQ(run(SampleClipJob{whole, time_s, b.span(), {}}), ErrorCode::ok);
    return same_bits<float>({a.span().planes, PoseSpan::floats_for(kJoints)},
                            {b.span().planes, PoseSpan::floats_for(kJoints)});
  }

  inline static Clip* whole = nullptr;
  inline static std::vector<std::vector<std::byte>>* pages = nullptr;
};

TEST_F(HourTest, plays_with_the_bits_of_the_whole_clip_in_a_hundredth_of_its_memory) {
  ASSERT_EQ(pages->size(), 900u);
  PagedClip paged(first_keys(*whole), kHourPage_s, pages->size());
  std::size_t loads = 0, missing = 0, most_bytes = 0;
  for (double t = 0.0; t < 3600.0; t += 1.0 / 30.0) {
    if (const auto page = paged.next_page()) {  // loads one page a frame, before it is needed
      ASSERT_TRUE(paged.load_page(*page, (*pages)[*page]));
      ++loads;
    }
    const PageSample at = paged.at(t);
    missing += at.is_missing;
    most_bytes = std::max(most_bytes, paged.loaded_bytes());
    ASSERT_TRUE(same(at, t)) << t;
  }
  EXPECT_EQ(missing, 0u);
  EXPECT_LE(loads, pages->size() + 3) << "each page once, and what the loop needs next";
  EXPECT_LT(most_bytes * 100, whole->byte_size());
}

/// The loader needs 90 frames for each page, so it is late after each jump.
TEST_F(HourTest, a_slow_loader_is_late_after_jumps_and_never_wrong) {
  PagedClip paged(first_keys(*whole), kHourPage_s, pages->size());
  test::FixedRandom random(1);
  double t = 0.0;
  std::size_t missing = 0, shown = 0, frames_left = 90;
  std::optional<std::size_t> reading;
  for (int frame = 0; frame < 20000; ++frame) {
    t = random.below(2000) == 0 ? random.in(0.0, 3600.0) : std::fmod(t + 1.0 / 30.0, 3600.0);
    const PageSample at = paged.at(t);
    ++(at.is_missing ? missing : shown);
    ASSERT_TRUE(same(at, at.time_s)) << t;
    ASSERT_EQ(at.is_missing, at.time_s != t);
    if (!reading) {
      reading = paged.next_page();
      frames_left = 90;
    } else if (--frames_left == 0) {
      ASSERT_TRUE(paged.load_page(*reading, (*pages)[*reading]));
      reading.reset();
    }
  }
  EXPECT_GT(missing, 90u);
  EXPECT_GT(shown, 5 * missing);
}

}  // namespace
}  // namespace sinew
