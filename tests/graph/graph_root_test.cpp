// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/graph/rigid_exponential.h"
#include "runtime/math/axis_angle.h"
#include "tests/graph/graph_player.h"
#include "tests/playback/motion_distance.h"

namespace sinew {
namespace {

using test::apart;
using test::GraphPlayer;
using Vec3d = Vec3<double>;

/// A clip that moves along z and turns.
RootTrack moving(double duration_s, double metres, double turn_rad) {
  BoneAnimation root;
  const auto end = static_cast<float>(duration_s);
  const auto half = static_cast<float>(0.4 * metres);  // faster in its second half
  root.translation = {
      Interpolation::linear, {0.0f, 0.5f * end, end}, {{0, 1, 0}, {0, 1, half}, {0, 1, static_cast<float>(metres)}}};
  const auto about_y = [](double angle) { return quat_cast<float>(quat_from_axis_angle(Vec3d(0, 1, 0), angle)); };
  root.rotation = {Interpolation::linear, {0.0f, end}, {about_y(0), about_y(turn_rad)}};
  return RootTrack::make(root, {}, {}, 1e-6);
}

TEST(rigid_exponential, is_the_inverse_of_the_logarithm_at_all_sizes) {
  for (const double angle : {0.0, 1e-12, 1e-5, 0.0099, 0.0101, 0.7, 3.1}) {
    const RigidTwist twist{Vec3d(0.6, 0.0, -0.8) * angle, Vec3d(0.3, -2.0, 0.5)};
    const RigidTwist again = logarithm(exponential(twist));
    EXPECT_LT(glm::length(again.turn - twist.turn), 1e-12) << angle;
    EXPECT_LT(glm::length(again.shift - twist.shift), 1e-11) << angle;
    const DualQuatd halves = exponential({twist.turn * 0.5, twist.shift * 0.5});
    EXPECT_LT(apart(halves * halves, exponential(twist)), 1e-12) << angle;
  }
}

TEST(graph_root, one_clip_moves_as_its_track) {
  const RootTrack track = moving(0.8, 1.5, 0.4);
  GraphBuilder b;
  GraphPlayer player(b, b.clip("walk"), {{0, 0.8, {}, &track}});
  PlaybackClock clock(seconds_of(ticks_of(0.8)));
  DualQuatd world;
  for (const double dt : {0.1, 0.9, 0.0, 3.3, -0.7}) {
    player.advance(dt);
    world = normalised(world * track.motion(clock.advance(dt)));
    EXPECT_LT(apart(player.root(), world), 1e-9) << dt;
    EXPECT_LT(apart(player.step().root_place, track.place(clock.time_s())), 1e-9);
  }
}

/// A walk, a run that turns, and a fade between them every second.
struct TwoGaits {
  RootTrack walk = moving(0.9, 1.5, 0.0), run = moving(0.6, 3.0, 0.5);
  GraphBuilder b;
  GraphIndex root;

  explicit TwoGaits(GraphSync sync) {
    root = b.machine("gait");
    const GraphIndex slow = b.state(root, "walk", b.clip("walk")), fast = b.state(root, "run", b.clip("run"));
    b.transition(root, slow, {.duration_s = 0.35f, .to = fast, .sync = sync}, {when_in_state_for(0.77f)});
    b.transition(root, fast, {.duration_s = 0.45f, .to = slow, .sync = sync}, {when_in_state_for(0.91f)});
  }
  GraphPlayer player() const { return GraphPlayer(b, root, {{0, 0.9, {}, &walk}, {1, 0.6, {}, &run}}); }
};

TEST(graph_root, does_not_depend_on_how_time_is_cut) {
  for (const GraphSync sync : {GraphSync::none, GraphSync::locked}) {
    const TwoGaits gaits(sync);
    GraphPlayer one = gaits.player(), milliseconds = gaits.player(), frames = gaits.player();
    for (int second = 0; second < 10; ++second) {
      one.advance(1.0);
      milliseconds.advance(0.001, 1000);
      frames.advance(1.0 / 144.0, 144);
    }
    EXPECT_LT(apart(one.root(), milliseconds.root()), 1e-9);
    EXPECT_LT(apart(one.root(), frames.root()), 1e-9);
    EXPECT_EQ(one.log(), milliseconds.log());
    EXPECT_GT(glm::length(translation_of(one.root())), 1.0);
  }
}

TEST(graph_root, follows_the_curve_of_the_fade) {
  const RootTrack stand = moving(1.0, 0.0, 0.0), walk = moving(1.0, 0.0, 0.0);
  BoneAnimation steady;
  steady.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 0, 0}, {0, 0, 2}}};
  const RootTrack run = RootTrack::make(steady, {}, {}, 1e-6);
  GraphBuilder b;
  const GraphIndex root = b.machine("gait");
  b.state(root, "stand", b.clip("stand"));
  const GraphIndex fast = b.state(root, "run", b.clip("run"));
  b.transition(root, 0, {.duration_s = 0.5f, .to = fast, .fade = GraphFade::smooth}, {});
  GraphPlayer player(b, root, {{0, 1.0, {}, &stand}, {1, 1.0, {}, &run}});
  for (int frame = 0; frame < 30; ++frame) {
    player.advance(1.0 / 60.0);
    const double u = (frame + 0.5) / 30.0, speed = translation_of(player.step().root_motion).z * 60.0;
    EXPECT_NEAR(speed, 2.0 * u * u * (3.0 - 2.0 * u), 1e-5) << frame;
  }
  player.advance(0.5);
  EXPECT_NEAR(translation_of(player.step().root_motion).z, 1.0, 1e-6);
}

/// Three states whose clips move on the spot, at 1, 4 and 2 m/s; each transition is triggered.
struct ThreeSpeeds {
  static constexpr double kSpeeds[] = {1.0, 4.0, 2.0};
  std::array<RootTrack, 3> tracks;
  GraphBuilder b;
  GraphIndex root, go;
  double duration_s = 0.5;

  explicit ThreeSpeeds(GraphTransitionKind kind) {
    root = b.machine("gait", {.fades = 8});
    go = b.trigger("go");
    for (std::size_t s = 0; s < 3; ++s) {
      BoneAnimation steady;
      const auto end = static_cast<float>(kSpeeds[s]);
      steady.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 0, 0}, {0, 0, end}}};
      tracks[s] = RootTrack::make(steady, {}, {}, 1e-6);
      b.state(root, "state", b.clip("clip" + std::to_string(s)));
    }
    for (GraphIndex s = 0; s < 3; ++s)
      b.transition(root, s, {.duration_s = 0.5f, .to = static_cast<GraphIndex>((s + 1) % 3), .kind = kind},
                   {when_triggered(go)});
  }
  GraphPlayer player() const {
    std::vector<GraphClip> clips;
    for (std::uint32_t s = 0; s < 3; ++s)
      clips.push_back({.clip = s, .duration_s = 1.0, .root = &tracks[s], .root_in_pose = false});
    return GraphPlayer(b, root, clips);
  }
};

/// Share of the new state, written from the equations of the transitions.
double share_of(GraphTransitionKind kind, double u) {
  if (u >= 1.0) return 1.0;
  return kind == GraphTransitionKind::dead_blend ? 3 * u * u - 2 * u * u * u : 1.0 - std::pow(1 - u, 4) * (1 + 4 * u);
}

TEST(graph_root, inertialized_and_dead_blended_velocity_follows_the_curve_of_the_pose) {
  for (const GraphTransitionKind kind : {GraphTransitionKind::inertialize, GraphTransitionKind::dead_blend}) {
    const ThreeSpeeds speeds(kind);
    GraphPlayer player = speeds.player();
    player.advance(0.5);
    // The second transition interrupts the first one after 10 frames.
    double before = 0.0;
    for (int frame = 0; frame < 60; ++frame) {
      if (frame == 0 || frame == 10) player.trigger(speeds.go);
      player.advance(1.0 / 60.0);
      const double first = share_of(kind, (frame + 0.5) / 30.0), second = share_of(kind, (frame - 9.5) / 30.0);
      const double target = frame < 10 ? 4.0 : 4.0 + second * (2.0 - 4.0);
      const double speed = translation_of(player.step().root_motion).z * 60.0;
      EXPECT_NEAR(speed, 1.0 + first * (target - 1.0), 2e-5) << frame;
      EXPECT_LT(apart(player.step().root_place, DualQuatd()), 1e-12) << "nothing is left in the pose";
      EXPECT_LT(frame == 0 ? 0.0 : std::fabs(speed - before), 0.35) << frame;
      before = speed;
    }
    EXPECT_NEAR(before, 2.0, 1e-5);
  }
}

TEST(graph_root, transitions_without_cross_fades_do_not_depend_on_how_time_is_cut) {
  const ThreeSpeeds speeds(GraphTransitionKind::inertialize);
  GraphPlayer one = speeds.player(), many = speeds.player();
  for (int i = 0; i < 7; ++i) {
    for (GraphPlayer* player : {&one, &many}) player->trigger(speeds.go);
    one.advance(0.3);
    many.advance(0.001, 300);
    EXPECT_LT(apart(one.root(), many.root()), 1e-9) << i;
  }
  EXPECT_TRUE(std::equal(one.ops().begin(), one.ops().end(), many.ops().begin(), many.ops().end()));
  EXPECT_EQ(one.ops().back().kind, PoseOpKind::inertialize);
}

TEST(graph_root, layers_that_overlay_leave_the_root_alone_and_means_do_not) {
  const RootTrack walk = moving(1.0, 2.0, 0.0);
  for (const GraphLayerKind kind : {GraphLayerKind::overlay, GraphLayerKind::additive, GraphLayerKind::mean}) {
    GraphBuilder b;
    const GraphIndex base = b.clip("stand");
    const GraphLayer layer{.node = b.clip("walk"), .kind = kind};
    GraphPlayer player(b, b.layers("body", base, std::vector{layer}), {{0, 1.0}, {1, 1.0, {}, &walk}});
    player.advance(1.0);
    EXPECT_NEAR(translation_of(player.root()).z, kind == GraphLayerKind::mean ? 1.0 : 0.0, 1e-5);
  }
}

TEST(graph_root, a_mirrored_clip_moves_to_the_other_side) {
  BoneAnimation aside;
  aside.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 0, 0}, {1, 0, 2}}};
  const RootTrack track = RootTrack::make(aside, {}, {}, 1e-6);
  GraphBuilder b;
  GraphPlayer player(b, b.clip("strafe", {.mirror = true}), {{0, 1.0, {}, &track}});
  player.advance(2.0);
  EXPECT_NEAR(translation_of(player.root()).x, -2.0, 1e-6);
  EXPECT_NEAR(translation_of(player.root()).z, 4.0, 1e-6);
  EXPECT_EQ(player.ops()[0].kind, PoseOpKind::sample_mirrored);
}

}  // namespace
}  // namespace sinew
