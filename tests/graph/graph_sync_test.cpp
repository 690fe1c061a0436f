// SPDX-License-Identifier: MIT
// Blend spaces whose clips play in step by their beats, and transitions that start states by beats or by time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/playback/root_track.h"
#include "tests/graph/graph_player.h"
#include "tests/playback/motion_distance.h"
#include "tests/reference/sync.h"

namespace sinew {
namespace {

using test::GraphPlayer;

constexpr std::uint32_t kLeft = 0, kRight = 1, kFrontLeft = 2, kFrontRight = 3;
constexpr std::uint32_t kMirrored[] = {kRight, kLeft, kFrontRight, kFrontLeft};

/// A clip of a space: its length and speed, its beats, and the beat that is beat 0 of the space.
struct Gait {
  double duration_s;
  std::vector<SyncBeat> beats;
  std::uint32_t first_beat = 0;
  float speed = 1.0f;
  bool mirror = false;
  std::vector<SyncBeat> kept = {};  ///< the beats that all clips share; empty = all
};

/// A space on a line with the gaits at 0, 1, 2, ...
struct Gaits {
  std::vector<Gait> gaits;
  GraphBuilder b;
  GraphIndex place, space;
  std::vector<GraphClip> clips;

  explicit Gaits(std::vector<Gait> all) : gaits(std::move(all)) {
    place = b.number("place");
    std::vector<GraphBlendPoint> points;
    for (std::size_t g = 0; g < gaits.size(); ++g) {
      const std::string name = std::string("gait") + std::to_string(g);
      points.push_back(
          {static_cast<float>(g), 0.0f, b.clip(name, {.speed = gaits[g].speed, .mirror = gaits[g].mirror})});
      clips.push_back(
          {.clip = static_cast<std::uint32_t>(g), .duration_s = gaits[g].duration_s, .beats = gaits[g].beats});
    }
    space = b.blend_space("space", {.x = place}, points);
  }
  GraphPlayer player() const { return GraphPlayer(b, space, clips, 4096, kMirrored); }

  /// The group at a place on the line, by its own rules.
  std::vector<SyncMember> group(double at) const {
    std::vector<SyncMember> members;
    for (std::size_t g = 0; g < gaits.size(); ++g) {
      const Gait& gait = gaits[g];
      SyncMember member;
      member.track = {gait.kept.empty() ? std::span<const SyncBeat>(gait.beats) : std::span<const SyncBeat>(gait.kept),
                      gait.duration_s / static_cast<double>(gait.speed)};
      member.weight = std::max(0.0, 1.0 - std::fabs(at - static_cast<double>(g)));
      member.first_beat = gait.first_beat;
      members.push_back(member);
    }
    return members;
  }
};

/// Clip times, by clip, in a program of samples.
double clip_time(const GraphPlayer& player, std::uint32_t clip) {
  for (const PoseOp& op : player.ops())
    if ((op.kind == PoseOpKind::sample || op.kind == PoseOpKind::sample_mirrored) && op.index == clip) return op.time_s;
  return -1.0;
}

void expect_in_step(const Gaits& gaits) {
  const double last = static_cast<double>(gaits.gaits.size() - 1);
  for (double at = 0.0; at <= last; at += 0.125) {
    const std::vector<SyncMember> group = gaits.group(at);
    GraphPlayer player = gaits.player();
    player.set(gaits.place, static_cast<float>(at));
    double time_s = 0.0;
    for (const double dt : {0.0, 0.013, 0.2, 0.31, 0.0167, 2.7, 0.45}) {
      player.advance(dt);
      time_s += dt;
      const double beats = reference::beats_after(group, time_s);
      for (std::size_t g = 0; g < group.size(); ++g) {
        if (!(group[g].weight > 0.0)) continue;
        const CyclePlace place =
            cycle_place(group[g], BeatPlace{static_cast<std::int64_t>(std::floor(beats)), beats - std::floor(beats)});
        const double off = clip_time(player, static_cast<std::uint32_t>(g)) / gaits.gaits[g].duration_s - place.phase;
        EXPECT_LT(std::fabs(off - std::round(off)), 1e-7) << "gait " << g << " at " << at << " after " << time_s;
      }
    }
  }
}

TEST(graph_sync, two_feet_meet_in_clips_that_begin_with_different_feet) {
  expect_in_step(Gaits({{1.0, {{0.1, kLeft}, {0.55, kRight}}}, {0.6, {{0.2, kRight}, {0.8, kLeft}}, 1}}));
}

TEST(graph_sync, a_clip_of_two_steps_plays_twice_beside_a_clip_of_four) {
  expect_in_step(Gaits(
      {{2.2, {{0.0, kLeft}, {0.2, kRight}, {0.5, kLeft}, {0.7, kRight}}}, {0.7, {{0.3, kRight}, {0.9, kLeft}}, 1}}));
}

TEST(graph_sync, gaits_with_other_orders_of_four_feet_meet_in_the_feet_that_they_share) {
  const std::vector<SyncBeat> walk = {{0.0, kLeft}, {0.25, kFrontLeft}, {0.5, kRight}, {0.75, kFrontRight}};
  const std::vector<SyncBeat> gallop = {{0.1, kLeft}, {0.2, kRight}, {0.5, kFrontLeft}, {0.65, kFrontRight}};
  Gait walks{1.2, walk}, gallops{0.5, gallop};
  walks.kept = {walk[0], walk[1], walk[3]};
  gallops.kept = {gallop[0], gallop[2], gallop[3]};
  expect_in_step(Gaits({walks, gallops}));
}

TEST(graph_sync, mirrored_clips_meet_by_the_mirrored_names) {
  Gait other{0.8, {{0.1, kLeft}, {0.5, kRight}}, 1};
  other.mirror = true;
  other.speed = 1.5f;
  expect_in_step(Gaits({{1.0, {{0.0, kLeft}, {0.45, kRight}}}, other}));
}

TEST(graph_sync, a_clip_without_beats_plays_once_in_a_common_cycle) {
  const Gaits gaits({{3.0, {}}, {1.0, {{0.2, kLeft}, {0.7, kRight}}}});
  GraphPlayer player = gaits.player();
  player.set(gaits.place, 0.5f);
  player.advance(1.0);  // half of the mean length of 2 s: one of two equal beats
  EXPECT_NEAR(clip_time(player, 0), 1.5, 1e-7);
  EXPECT_NEAR(clip_time(player, 1), 0.7, 1e-7);
}

TEST(graph_sync, events_of_a_foot_come_at_one_time_from_all_clips) {
  Gaits gaits({{1.0, {{0.1, kLeft}, {0.55, kRight}}}, {0.6, {{0.2, kRight}, {0.8, kLeft}}}});
  const std::vector<double> walk = {0.1, 0.55}, run = {0.12, 0.48};
  gaits.clips[0].event_times_s = walk;
  gaits.clips[1].event_times_s = run;
  for (const double dt : {10.0, 0.01}) {
    GraphPlayer player = gaits.player();
    player.set(gaits.place, 0.25f);
    player.advance(dt, static_cast<int>(std::lround(10.0 / dt)));
    const auto& log = player.log();
    ASSERT_EQ(log.size() % 2, 0u);
    EXPECT_NEAR(static_cast<double>(log.size()), 4 * 10.0 / 0.9, 4.0);
    for (std::size_t e = 0; e < log.size(); e += 2) {
      EXPECT_LE(std::abs(log[e].at - log[e + 1].at), 1) << e;
      EXPECT_NE(log[e].clip, log[e + 1].clip);
      EXPECT_NE(log[e].index, log[e + 1].index) << "left is the first event of the walk, and the second of the run";
    }
  }
}

TEST(graph_sync, does_not_depend_on_how_time_is_cut_or_on_its_direction) {
  const Gaits gaits({{1.0, {{0.1, kLeft}, {0.55, kRight}}}, {0.6, {{0.2, kRight}, {0.8, kLeft}}}});
  GraphPlayer one = gaits.player(), many = gaits.player();
  for (GraphPlayer* player : {&one, &many}) player->set(gaits.place, 0.4f);
  for (int i = 0; i < 5; ++i) {
    one.advance(1.0);
    many.advance(0.001, 1000);
    EXPECT_TRUE(std::equal(one.ops().begin(), one.ops().end(), many.ops().begin(), many.ops().end()));
  }
  const double before = clip_time(one, 1);
  one.advance(1.7);
  one.advance(-1.7);
  EXPECT_NEAR(clip_time(one, 1), before, 1e-7);
}

TEST(graph_sync, root_motion_follows_the_clips_through_their_beats) {
  BoneAnimation forward;
  forward.translation = {Interpolation::linear, {0.0f, 0.3f, 1.0f}, {{0, 0, 0}, {0, 0, 0.9f}, {0, 0, 1.5f}}};
  const RootTrack walk = RootTrack::make(forward, {}, {}, 1e-6);
  Gaits gaits({{1.0, {{0.1, kLeft}, {0.55, kRight}}}, {0.6, {{0.2, kRight}, {0.8, kLeft}}}});
  gaits.clips[0].root = &walk;
  GraphPlayer player = gaits.player();
  for (const double dt : {0.05, 0.3, 1.4, 0.9}) {
    const double from = std::max(0.0, clip_time(player, 0));
    player.advance(dt);
    PlaybackStep step;
    step.mode = PlayMode::loop;
    step.duration_s = 1.0;
    step.from_s = from == 0.0 ? 0.1 : from;  // a space starts at its first beat
    step.to_s = clip_time(player, 0);
    step.to_turns = std::floor(step.from_s + dt);
    EXPECT_LT(test::apart(player.step().root_motion, walk.motion(step)), 1e-7) << dt;
  }
}

TEST(graph_sync, transitions_start_by_phase_by_beat_or_by_time_left) {
  const std::vector<SyncBeat> walk = {{0.1, kLeft}, {0.6, kRight}}, run = {{0.2, kRight}, {0.8, kLeft}};
  const auto start_of = [&](SyncStart rule) {
    GraphBuilder b;
    const GraphIndex m = b.machine("m"), go = b.trigger("go");
    const GraphIndex from = b.state(m, "walk", b.clip("walk")), to = b.state(m, "run", b.clip("run", {.speed = 2.0f}));
    b.transition(m, from, {.to = to, .sync = GraphSync::start, .start_by = rule}, {when_triggered(go)});
    GraphPlayer player(b, m,
                       {{.clip = 0, .duration_s = 1.0, .beats = walk}, {.clip = 1, .duration_s = 1.2, .beats = run}});
    player.advance(0.7);
    player.trigger(go);
    player.advance(0.0);
    player.advance(1e-6);
    return clip_time(player, 1);
  };
  EXPECT_NEAR(start_of(SyncStart::phase), 0.7 * 1.2, 1e-5);
  EXPECT_NEAR(start_of(SyncStart::beat), (0.2 + 0.6 * 0.2) * 1.2, 1e-5) << "a fifth of the beat of the right foot";
  EXPECT_NEAR(start_of(SyncStart::time_left), 1.2 - 2.0 * 0.3, 1e-5) << "0.3 s before its end, at twice the speed";
}

TEST(graph_sync, refuses_beats_that_cannot_be) {
  const Gaits gaits({{1.0, {}}, {1.0, {}}});
  const GraphDefinition graph = *gaits.b.build(gaits.space);
  const auto code_of = [&](std::vector<SyncBeat> a, std::vector<SyncBeat> b, std::size_t names) {
    const GraphClip clips[] = {{.duration_s = 1.0, .beats = a}, {.duration_s = 1.0, .beats = b}};
    const auto set = GraphClipSet::make(graph, clips, std::span(kMirrored).first(names));
    return set ? ErrorCode::ok : set.error();
  };
  EXPECT_EQ(code_of({{0.5, 0}, {0.2, 1}}, {}, 2), ErrorCode::times_not_increasing);
  EXPECT_EQ(code_of({{1.0, 0}}, {}, 2), ErrorCode::times_not_increasing);
  std::vector<SyncBeat> eight, nine;
  for (std::uint32_t k = 0; k < 9; ++k) {
    if (k < 8) eight.push_back({k / 8.0, 0});
    nine.push_back({k / 9.0, 0});
  }
  EXPECT_EQ(code_of(eight, nine, 2), ErrorCode::too_large) << "72 beats in a common cycle";
  EXPECT_EQ(code_of(eight, eight, 2), ErrorCode::ok);
  EXPECT_EQ(GraphClipSet::make(graph, std::vector<GraphClip>{{0, 1.0}}).error(), ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew
