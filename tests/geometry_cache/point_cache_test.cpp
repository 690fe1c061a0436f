// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/point_cache.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "importer/geometry_cache/read_obj.h"
#include "tests/geometry_cache/point_cache_files.h"

namespace sinew::test {
namespace {

using Frames = std::vector<std::vector<glm::vec3>>;

const Frames kFrames = {{{1, 2, 3}, {-4, 5, 6.5f}}, {{1, 2, 4}, {0, 0, 0}}, {{7, 8, 9}, {1e-3f, -2e5f, 3}}};

std::string rule_of(const std::vector<std::byte>& file) {
  const auto points = read_point_cache(file, "file", 30.0);
  return points ? std::string() : points.error().issue.rule;
}

TEST(point_cache, mdd_files_are_read) {
  const auto points = read_point_cache(mdd_file(kFrames, {0.5f, 0.54f, 0.58f}), "file", 30.0);
  ASSERT_TRUE(points.has_value());
  EXPECT_EQ(points->frames, kFrames);
  EXPECT_EQ(points->start_s, 0.5);
  EXPECT_NEAR(points->frame_s, 0.04, 1e-7);
}

TEST(point_cache, pc2_files_are_read_and_count_time_in_frames) {
  const auto points = read_point_cache(pc2_file(kFrames, 10.0f, 2.0f), "file", 25.0);
  ASSERT_TRUE(points.has_value());
  EXPECT_EQ(points->frames, kFrames);
  EXPECT_DOUBLE_EQ(points->start_s, 0.4);
  EXPECT_DOUBLE_EQ(points->frame_s, 0.08);
}

TEST(point_cache, every_other_length_is_refused) {
  for (const auto& good : {mdd_file(kFrames, {0, 1, 2}), pc2_file(kFrames, 0, 1)}) {
    EXPECT_EQ(rule_of(good), "");
    for (std::size_t size = 0; size < good.size(); ++size)
      EXPECT_EQ(rule_of({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}), "points-size") << size;
    std::vector<std::byte> longer = good;
    longer.resize(good.size() + 1);
    EXPECT_EQ(rule_of(longer), "points-size");
  }
}

TEST(point_cache, counts_that_no_file_can_hold_are_refused) {
  std::vector<std::byte> file = mdd_file(kFrames, {0, 1, 2});
  for (std::size_t at = 0; at < 8; ++at) file[at] = std::byte(0xff);
  EXPECT_EQ(rule_of(file), "points-size");
  EXPECT_EQ(rule_of(mdd_file({}, {})), "points-size") << "no frames";
}

TEST(point_cache, values_times_and_heads_that_make_no_sense_are_refused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Frames frames = kFrames;
  frames[1][1].y = nan;
  EXPECT_EQ(rule_of(mdd_file(frames, {0, 1, 2})), "points-values");
  EXPECT_EQ(rule_of(pc2_file(frames, 0, 1)), "points-values");
  EXPECT_EQ(rule_of(mdd_file(kFrames, {0, 1, nan})), "points-times");
  EXPECT_EQ(rule_of(mdd_file(kFrames, {0, 1, 3})), "points-times");
  EXPECT_EQ(rule_of(mdd_file(kFrames, {2, 1, 0})), "points-times");
  EXPECT_EQ(rule_of(pc2_file(kFrames, 0, 0)), "points-header");
  EXPECT_EQ(rule_of(pc2_file(kFrames, nan, 1)), "points-header");
  std::vector<std::byte> file = pc2_file(kFrames, 0, 1);
  file[12] = std::byte(2);
  EXPECT_EQ(rule_of(file), "points-header");
}

TEST(point_cache, frames_without_points_are_frames_and_points_without_frames_are_none) {
  const auto none = read_point_cache(mdd_file({{}, {}}, {0, 1}), "file", 30.0);
  ASSERT_TRUE(none.has_value());
  EXPECT_EQ(none->frames.size(), 2u);
  EXPECT_EQ(none->point_count(), 0u);
  std::vector<std::byte> file = mdd_file({}, {});
  file[7] = std::byte(5);  // five points in no frame
  EXPECT_EQ(rule_of(file), "points-size");
}

TEST(point_cache, counts_whose_product_passes_64_bits_are_refused) {
  // 12 * 2^31 * 2^31 overflows to 0 in 64 bits: a file that is only a head would seem complete.
  std::vector<std::byte> file = pc2_file(kFrames, 0, 1);
  file.resize(32);
  file[16] = file[17] = file[18] = std::byte(0);
  file[28] = file[29] = file[30] = std::byte(0);
  file[19] = file[31] = std::byte(0x80);
  EXPECT_EQ(rule_of(file), "points-size");
  file[19] = file[31] = std::byte(0);
  EXPECT_EQ(rule_of(file), "points-size") << "no frames";
}

TEST(point_cache, times_may_be_off_by_a_hundredth_of_their_distance) {
  // Ten frames of 0.1 s from 2 s on; one in the middle has a wrong time.
  const auto rule_with = [](float off) {
    std::vector<float> times;
    for (int f = 0; f <= 10; ++f) times.push_back(2.0f + 0.1f * static_cast<float>(f));
    times[4] += off;
    return rule_of(mdd_file(Frames(11, kFrames[0]), times));
  };
  EXPECT_EQ(rule_with(0.0009f), "");
  EXPECT_EQ(rule_with(-0.0009f), "");
  EXPECT_EQ(rule_with(0.0011f), "points-times");
  EXPECT_EQ(rule_with(-0.0011f), "points-times");
  EXPECT_EQ(rule_of(mdd_file(kFrames, {0, 101, 200})), "") << "a hundredth of 100 exactly";
  EXPECT_EQ(rule_of(mdd_file(kFrames, {0, 101.5f, 200})), "points-times");
}

TEST(point_cache, one_frame_lasts_as_the_rate_says_and_the_same_time_twice_is_none) {
  const auto one = read_point_cache(mdd_file({kFrames[0]}, {3.0f}), "file", 50.0);
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(one->start_s, 3.0);
  EXPECT_EQ(one->frame_s, 0.02);
  EXPECT_EQ(rule_of(mdd_file({kFrames[0], kFrames[1]}, {3.0f, 3.0f})), "points-times");
}

std::string axis_of(const PointCache& points, std::span<const glm::vec3> rest) {
  const auto up = find_up_axis(points, rest, "file");
  return !up ? up.error().issue.rule : *up == UpAxis::y ? "y" : "z";
}

TEST(point_cache, the_axis_that_is_up_is_found_or_not_guessed) {
  PointCache points{kFrames};
  const std::vector<glm::vec3> y_up = kFrames[0];
  std::vector<glm::vec3> z_up;
  for (const glm::vec3& p : y_up) z_up.emplace_back(p.x, p.z, -p.y);
  EXPECT_EQ(axis_of(points, y_up), "y");
  EXPECT_EQ(axis_of(points, z_up), "z");
  std::vector<glm::vec3> other = y_up;
  other[0].x += 0.5f;
  EXPECT_EQ(axis_of(points, other), "points-axes");
  points.frames = {{{1, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(axis_of(points, points.frames[0]), "points-axes") << "both ways fit";
  EXPECT_EQ(axis_of(points, std::span(y_up).first(1)), "points-count");
  turn_to_y_up(points);
  points.frames = {y_up};
  turn_to_y_up(points);
  EXPECT_EQ(points.frames[0], z_up);
}

TEST(point_cache, an_axis_fits_within_a_thousandth_of_the_size_of_the_mesh) {
  for (const glm::vec3& corner : {glm::vec3(0, 0, 0), glm::vec3(-1, -2, -6), glm::vec3(50, 90, 70)})
    for (const bool z_up : {false, true}) {
      const std::vector<glm::vec3> rest = {corner,
                                           corner + glm::vec3(3, 4, 12)};  // the diagonal is 13, wherever the box is
      const auto axis_with = [&](double off) {
        PointCache points;
        auto& frame = points.frames.emplace_back();
        for (const glm::vec3& p : rest) frame.push_back(z_up ? glm::vec3(p.x, -p.z, p.y) : p);
        frame[1].x += static_cast<float>(off);
        return axis_of(points, rest);
      };
      EXPECT_EQ(axis_with(0.0129), z_up ? "z" : "y");
      EXPECT_EQ(axis_with(-0.0129), z_up ? "z" : "y");
      EXPECT_EQ(axis_with(0.0131), "points-axes");
    }
}

TEST(point_cache, a_mesh_of_one_point_on_the_axis_or_of_none_says_nothing) {
  PointCache points{{{{1, 0, 0}}}};
  EXPECT_EQ(axis_of(points, points.frames[0]), "points-axes");
  points.frames = {{{1, 2, 0}}};
  EXPECT_EQ(axis_of(points, points.frames[0]), "y");
  points.frames = {{}};
  EXPECT_EQ(axis_of(points, {}), "points-axes");
}

TEST(read_obj, vertices_and_faces_of_any_number_of_corners) {
  const auto mesh = read_obj(
      "# comment\r\no flag\nv 0 0 0\nv 1 0 0 1.0\r\nv +1 1e0 0 0.5 0.5 0.5\n\tv 0 1 -2.5\nvn 0 0 1\nf 1/2/3 2//4 3/1 "
      "4\n"
      "f -4 -3 -2",
      "file");
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, -2.5f}}));
  EXPECT_EQ(mesh->triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 1, 2}));
}

TEST(read_obj, broken_lines_are_refused_with_their_number) {
  const auto error_of = [](const char* text) {
    const auto mesh = read_obj(text, "file");
    return mesh ? std::string() : mesh.error().issue.rule + " " + mesh.error().issue.detail.substr(0, 6);
  };
  EXPECT_EQ(error_of("v 1 2"), "obj-syntax line 1");
  EXPECT_EQ(error_of("\nv 1 2 x"), "obj-syntax line 2");
  EXPECT_EQ(error_of("v 1 2 nan"), "obj-values line 1");
  EXPECT_EQ(error_of("v 1 2 1e99"), "obj-values line 1");
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* face : {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1 2 99999999999"})
    EXPECT_EQ(error_of((three + face).c_str()), "obj-index line 4") << face;
  for (const char* face : {"f 1 2", "f", "f 1 2 x", "f 1 2 /3"})
    EXPECT_EQ(error_of((three + face).c_str()), "obj-syntax line 4") << face;
}

}  // namespace
}  // namespace sinew::test
