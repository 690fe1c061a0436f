// SPDX-License-Identifier: MIT
#include "runtime/procedures/feet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "runtime/base/same_bits.h"
#include "tests/procedures/walker.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using V = Vec3<double>;

/// Height of the ground at z of the world.
using Profile = double (*)(double z);
double flat(double) { return 0.0; }
double uphill(double z) { return z * std::tan(25.0 * M_PI / 180.0); }
double downhill(double z) { return -uphill(z); }
double stairs(double z) { return 0.18 * std::floor(z / 0.6); }

bool find_ground(void* context, std::size_t, const V& place, GroundHit& hit) {
  const Profile& profile = *static_cast<Profile*>(context);
  hit.height_m = profile(place.z);
  const double slope = (profile(place.z + 1e-4) - profile(place.z - 1e-4)) / 2e-4;
  hit.normal = std::abs(slope) > 2.0 ? V(0, 1, 0) : normalised_or(V(0, 1, -slope), V(0, 1, 0));
  return true;
}

/// Places of one foot and knee in one frame.
struct Seen {
  V tip, knee;
  bool stands = false;
  FootResult result;
};

/// A walk over a profile: the character follows the ground at its root, which moves `pace` times as fast as the clip.
struct Walk {
  test::Walker walker;
  std::array<FootSetup, 2> feet;
  FeetSetup setup;
  FeetState state;
  std::vector<std::array<Seen, 2>> seen, clip;
  std::vector<double> pelvis;

  Walk() {
    for (std::uint32_t side = 0; side < 2; ++side)
      feet[side] = foot_on_rest_ground(walker.skeleton, scenes::left_thigh + side, scenes::left_shank + side,
                                       scenes::left_foot + side, scenes::left_toes + side);
    setup.pelvis = scenes::hips;
    setup.feet = feet;
  }

  void run(Profile profile, double pace, double fps, double seconds) {
    seen.clear();
    clip.clear();
    pelvis.clear();
    state = {};
    for (int f = 0; f <= static_cast<int>(seconds * fps); ++f) {
      const double time = f / fps;
      test::PoseBuffer pose = walker.pose(time);
      Affined root;
      root.row[2].w = time * test::Walker::kSpeed_m_s * pace;
      root.row[1].w = profile == stairs ? uphill_of_stairs(root.row[2].w) : profile(root.row[2].w);
      clip.push_back(look(pose.span(), root));
      std::array<FootResult, 2> results;
      const FeetJob job{.skeleton = &walker.skeleton,
                        .local = pose.span(),
                        .setup = &setup,
                        .root = root,
                        .dt_s = f == 0 ? 0.0 : 1.0 / fps,
                        .ground = {find_ground, &profile},
                        .state = &state,
                        .results = results};
      ASSERT_EQ(sinew::run(job), ErrorCode::ok);
      seen.push_back(look(pose.span(), root));
      for (std::size_t i = 0; i < 2; ++i) {
        seen.back()[i].result = results[i];
        seen.back()[i].stands = clip.back()[i].tip.y - root.row[1].w < 0.005;
      }
      pelvis.push_back(translation_of(root * model_matrix(walker.skeleton, pose.span(), scenes::hips)).y);
    }
  }
  /// The root of a capsule that slides up the stairs.
  static double uphill_of_stairs(double z) { return 0.3 * z - 0.09; }

  std::array<Seen, 2> look(const PoseSpan& pose, const Affined& root) const {
    std::array<Seen, 2> out;
    for (std::uint32_t side = 0; side < 2; ++side) {
      const auto at = [&](std::uint32_t joint, const Vec3<float>& point) {
        return transform_point(root * model_matrix(walker.skeleton, pose, joint), V(point));
      };
      out[side].tip = at(scenes::left_toes + side, feet[side].tip);
      out[side].knee = at(scenes::left_shank + side, Vec3<float>(0.0f));
    }
    return out;
  }

  /// Largest horizontal distance that a tip slides in one stand.
  static double slide(const std::vector<std::array<Seen, 2>>& frames, const std::vector<std::array<Seen, 2>>& stands) {
    double most = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      std::size_t begin = 0;
      for (std::size_t f = 1; f < frames.size(); ++f) {
        if (!stands[f][i].stands || !stands[f - 1][i].stands) begin = f + 3;  // the frames in which it touches down
        if (f > begin && stands[f][i].stands)
          most = std::max(most, std::hypot(frames[f][i].tip.x - frames[begin][i].tip.x,
                                           frames[f][i].tip.z - frames[begin][i].tip.z));
      }
    }
    return most;
  }

  /// Largest second difference of the knees' places, in m/s^2.
  static double knee_acceleration(const std::vector<std::array<Seen, 2>>& frames, double fps) {
    double most = 0.0;
    for (std::size_t f = 2; f < frames.size(); ++f)
      for (std::size_t i = 0; i < 2; ++i)
        most = std::max(
            most, glm::length(frames[f][i].knee - 2.0 * frames[f - 1][i].knee + frames[f - 2][i].knee) * fps * fps);
    return most;
  }
};

TEST(feet, on_flat_ground_at_its_own_speed_a_clip_stays_as_it_is) {
  Walk walk;
  walk.run(flat, 1.0, 120.0, 3.0);
  for (std::size_t f = 0; f < walk.seen.size(); ++f)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_LT(glm::length(walk.seen[f][i].tip - walk.clip[f][i].tip), 0.025) << f;  // it stands until it is fast
  EXPECT_LT(Walk::slide(walk.seen, walk.seen), 1e-5);
}

TEST(feet, of_a_clip_at_another_speed_stand_still_and_go_on_without_a_jump) {
  constexpr double kFps = 240.0;
  for (const double pace : {0.85, 1.15}) {
    Walk walk;
    walk.run(flat, pace, kFps, 4.0);
    EXPECT_GT(Walk::slide(walk.clip, walk.seen), 0.07) << "the clip alone slides";
    EXPECT_LT(Walk::slide(walk.seen, walk.seen), 1e-5);
    double fastest = 0.0, of_clip = 0.0;
    for (std::size_t f = 1; f < walk.seen.size(); ++f)
      for (std::size_t i = 0; i < 2; ++i) {
        fastest = std::max(fastest, glm::length(walk.seen[f][i].tip - walk.seen[f - 1][i].tip));
        of_clip = std::max(of_clip, glm::length(walk.clip[f][i].tip - walk.clip[f - 1][i].tip));
      }
    EXPECT_LT(fastest, 1.5 * of_clip) << "no pop";
  }
}

TEST(feet, lie_on_slopes_with_heel_and_tip_up_and_down_hill) {
  for (const Profile profile : {uphill, downhill}) {
    Walk walk;
    walk.run(profile, 1.0, 120.0, 4.0);
    int stands = 0, locked = 0;
    for (std::size_t f = 10; f < walk.seen.size(); ++f)
      for (const Seen& foot : walk.seen[f]) {
        if (!foot.stands) continue;
        ++stands;
        locked += foot.result.is_locked;
        EXPECT_LT(std::abs(foot.result.tip_above_ground_m), 0.005f) << f;
        EXPECT_LT(std::abs(foot.result.heel_above_ground_m), 0.005f) << f;
      }
    EXPECT_GT(stands, 400);
    EXPECT_GT(locked, stands * 9 / 10) << "a root that goes up makes no foot fast";
    EXPECT_LT(Walk::slide(walk.seen, walk.seen), 0.003);
  }
}

TEST(feet, climb_stairs_without_shaking) {
  constexpr double kFps = 120.0;
  Walk level, walk;
  level.run(flat, 1.0, kFps, 4.0);
  walk.run(stairs, 1.0, kFps, 4.0);
  int stands = 0, off = 0;
  for (std::size_t f = 10; f < walk.seen.size(); ++f)
    for (const Seen& foot : walk.seen[f]) {
      if (!foot.stands) continue;
      ++stands;
      off += std::abs(foot.result.tip_above_ground_m) > 0.005f;
    }
  EXPECT_GT(stands, 400);
  EXPECT_LT(off, stands / 18) << "the frames in which a jump of the ground fades";
  EXPECT_LT(Walk::slide(walk.seen, walk.seen), 0.003);
  EXPECT_LT(Walk::knee_acceleration(walk.seen, kFps), 3.0 * Walk::knee_acceleration(level.seen, kFps));
}

TEST(feet, weight_0_keeps_every_bit_and_the_same_moment_again_remembers_nothing) {
  Walk walk;
  walk.run(stairs, 1.1, 60.0, 1.0);
  test::PoseBuffer pose = walk.walker.pose(1.0), before = pose;
  FeetState state = walk.state;
  Profile profile = stairs;
  FeetJob job{.skeleton = &walk.walker.skeleton,
              .local = pose.span(),
              .setup = &walk.setup,
              .ground = {find_ground, &profile},
              .state = &state,
              .weight = 0.0f};
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t j = 0; j < 9; ++j) EXPECT_TRUE(same_bits(pose.span().get(j), before.span().get(j)));
  EXPECT_FALSE(state.has_started) << "it starts anew when it comes back";

  job.weight = 1.0f;
  job.root.row[2].w = 1.1;
  job.root.row[1].w = Walk::uphill_of_stairs(1.1);
  std::vector<Transform> first;
  for (int round = 0; round < 3; ++round) {
    state = walk.state;
    pose = walk.walker.pose(1.0);
    job.local = pose.span();
    {
      const test::AllocationCounter allocations;
      EXPECT_EQ(run(job), ErrorCode::ok);
      EXPECT_EQ(allocations.count(), 0u);
    }
    for (std::size_t j = 0; j < 9; ++j)
      if (round == 0)
        first.push_back(pose.span().get(j));
      else
        EXPECT_TRUE(same_bits(pose.span().get(j), first[j])) << "rolled back and run again";
  }
}

/// A spider: eight legs around a body, over ground that is uneven everywhere.
TEST(feet, of_a_spider_all_reach_uneven_ground) {
  std::vector<std::uint32_t> parents = {kNone};
  std::vector<glm::vec3> places = {{0, 0.4f, 0}};
  for (std::uint32_t leg = 0; leg < 8; ++leg) {
    const float angle = static_cast<float>(leg) * 0.785398f, c = std::cos(angle), s = std::sin(angle);
    const auto hip = static_cast<std::uint32_t>(parents.size());
    for (const glm::vec3 place : {glm::vec3(0.1f * c, 0.4f, 0.1f * s), glm::vec3(0.5f * c, 0.7f, 0.5f * s),
                                  glm::vec3(0.8f * c, 0.05f, 0.8f * s)}) {
      parents.push_back(places.size() == hip ? 0 : static_cast<std::uint32_t>(places.size() - 1));
      places.push_back(place);
    }
  }
  std::vector<glm::vec3> offsets;
  for (std::size_t j = 0; j < places.size(); ++j)
    offsets.push_back(parents[j] == kNone ? places[j] : places[j] - places[parents[j]]);
  const Skeleton spider = scenes::breadth_first(parents, offsets);
  std::vector<FootSetup> feet;
  for (std::uint32_t leg = 0; leg < 8; ++leg) {
    const std::uint32_t first = 1 + 3 * leg;
    feet.push_back(foot_on_rest_ground(spider, spider.joint_of_node[first], spider.joint_of_node[first + 1],
                                       spider.joint_of_node[first + 2]));
  }
  FeetSetup setup;
  setup.feet = feet;
  FeetState state;
  std::vector<FootResult> results(8);
  test::PoseBuffer pose(spider.joint_count());
  for (std::size_t j = 0; j < spider.joint_count(); ++j) pose.span().set(j, spider.rest[j]);
  const Ground ground{[](void*, std::size_t, const V& place, GroundHit& hit) {
                        hit.height_m = 0.12 * std::sin(5.0 * place.x) * std::cos(4.0 * place.z);
                        return true;
                      },
                      nullptr};
  ASSERT_EQ(run(FeetJob{.skeleton = &spider,
                        .local = pose.span(),
                        .setup = &setup,
                        .ground = ground,
                        .state = &state,
                        .results = results}),
            ErrorCode::ok);
  for (const FootResult& foot : results) {
    EXPECT_EQ(foot.ik.status, IkStatus::reached);
    EXPECT_LT(std::abs(foot.tip_above_ground_m), 1e-3f);
  }
}

TEST(feet, wrong_setups_are_refused_and_ground_that_is_none_is_flat) {
  Walk walk;
  test::PoseBuffer pose = walk.walker.pose(0.2);
  const auto code = [&](auto change) {
    FeetSetup setup = walk.setup;
    std::array<FootSetup, 2> feet = walk.feet;
    setup.feet = feet;
    FeetState state;
    FeetJob job{.skeleton = &walk.walker.skeleton, .local = pose.span(), .setup = &setup, .state = &state};
    change(job, setup, feet);
    return run(job);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code([](auto&, auto&, auto&) {}), ErrorCode::ok);
  EXPECT_EQ(code([](FeetJob& job, auto&, auto&) { job.state = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto&, auto&, auto& feet) { feet[0].knee = 99; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([](auto&, auto&, auto& feet) { std::swap(feet[0].knee, feet[0].ankle); }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto&, auto&, auto& feet) { feet[1].hip = feet[0].hip; }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto&, FeetSetup& setup, auto&) { setup.pelvis = scenes::left_foot; }), ErrorCode::unsupported);
  EXPECT_EQ(code([&](FeetJob& job, auto&, auto&) { job.dt_s = nan; }), ErrorCode::not_finite);
  EXPECT_EQ(code([](FeetJob& job, auto&, auto&) { job.dt_s = -0.1; }), ErrorCode::not_a_fraction);
  EXPECT_EQ(code([&](FeetJob& job, auto&, auto&) { job.root.row[1].w = nan; }), ErrorCode::not_finite);
  EXPECT_EQ(code([](FeetJob& job, auto&, auto&) { job.weight = 1.5f; }), ErrorCode::not_a_fraction);
  const Ground lost{[](void*, std::size_t, const V&, GroundHit& hit) {
                      hit = {std::nan(""), {0, 0, 0}};
                      return true;
                    },
                    nullptr};
  EXPECT_EQ(code([&](FeetJob& job, auto&, auto&) { job.ground = lost; }), ErrorCode::ok);
  for (std::size_t j = 0; j < 9; ++j) EXPECT_TRUE(std::isfinite(pose.span().get(j).rotation.w)) << j;
}

}  // namespace
}  // namespace sinew
