// SPDX-License-Identifier: MIT
// Inertialization and dead blending as graphs write them: no jump in pose or velocity, whenever they begin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/math/quat_log_exp.h"
#include "runtime/playback/root_track.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/pose_program/run_pose_program.h"
#include "tests/graph/graph_player.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

constexpr std::size_t kJoints = 3;
constexpr double kStep_s = 0.0005;

/// How the root joint of a body moves: not at all, or by metres, on the spot (baked out) or in the pose.
enum class Walk { stands, on_the_spot, in_pose };
constexpr Walk kWalks[] = {Walk::stands, Walk::on_the_spot, Walk::in_pose};

/// Clips of one second in which each joint turns steadily; they do not close.
struct Body {
  Walk walk;
  Skeleton skeleton;
  std::vector<Clip> clips;
  std::vector<RootTrack> tracks;
  PoseMemory rest{kJoints}, result{kJoints};
  PoseProgramAssets assets;
  std::unique_ptr<std::byte[], decltype(&std::free)> block{nullptr, std::free};
  std::size_t bytes = 0;

  explicit Body(Walk how = Walk::stands) : walk(how) {
    skeleton = chain_skeleton(kJoints);
    for (std::size_t j = 0; j < kJoints; ++j) rest.span().set(j, skeleton.rest[j]);
    for (int c = 0; c < 3; ++c) {
      Animation animation;
      for (std::uint32_t j = 0; j < kJoints; ++j) {
        const Vec3<double> axis = glm::normalize(Vec3<double>(1.0 + c, 0.5 * j, 1.0 - 0.7 * c));
        BoneAnimation bone;
        bone.joint = j;
        bone.rotation = {Interpolation::linear,
                         {0.0f, 1.0f},
                         {quat_cast<float>(quat_from_axis_angle(axis, 0.3 * c - 0.2 * j)),
                          quat_cast<float>(quat_from_axis_angle(axis, 0.3 * c - 0.2 * j + 0.9 - 0.5 * c))}};
        if (walk != Walk::stands && j == 0) {
          const auto way = static_cast<float>(1 + 2 * c);
          bone.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 1, 0}, {0.3f * way, 0.9f, way}}};
          tracks.push_back(RootTrack::make(bone, skeleton.rest[0], {}, 1e-6));
          if (walk == Walk::on_the_spot) bone = bake_out_root(bone, skeleton.rest[0], tracks.back(), 1e-6);
          bone.joint = j;
        }
        animation.bones.push_back(bone);
      }
      animation.duration_s = 1.0f;
      clips.push_back(compile_clip(animation, skeleton, {}, {}));
    }
    assets = {.skeleton = &skeleton, .clips = clips, .rest = rest.span()};
  }

  /// Place of the root joint in the world, for the last pose.
  Vec3<double> place_of(const GraphPlayer& player) {
    const Transform root = result.span().get(0);
    const DualQuatd local =
        dual_quat_from(normalised(quat_cast<double>(root.rotation)), Vec3<double>(root.translation));
    return translation_of(player.root() * dual_quat_conjugate(player.step().root_place) * local);
  }

  std::vector<Quat<double>> pose_of(const GraphPlayer& player) {
    if (bytes == 0) {
      bytes = pose_program_bytes(assets, player.graph().room());
      block.reset(static_cast<std::byte*>(std::aligned_alloc(64, bytes)));
    }
    EXPECT_EQ(run(PoseProgramJob{
                  .program = player.ops(), .assets = &assets, .memory = {block.get(), bytes}, .pose = result.span()}),
              ErrorCode::ok);
    std::vector<Quat<double>> pose;
    for (std::size_t j = 0; j < kJoints; ++j) pose.push_back(quat_cast<double>(result.span().get(j).rotation));
    return pose;
  }
};

/// Three states that follow each other whenever the trigger is set.
struct Ring {
  GraphBuilder b;
  GraphIndex machine, go;

  explicit Ring(GraphTransitionKind kind, float duration_s = 0.25f) {
    machine = b.machine("m", {.fades = 8});
    go = b.trigger("go");
    for (int c = 0; c < 3; ++c) b.state(machine, "s", b.clip("c" + std::to_string(c)));
    for (GraphIndex c = 0; c < 3; ++c)
      b.transition(machine, c, {.duration_s = duration_s, .to = static_cast<GraphIndex>((c + 1) % 3), .kind = kind},
                   {when_triggered(go)});
  }
  GraphPlayer player() const { return GraphPlayer(b, machine, {{0, 1.0}, {1, 1.0}, {2, 1.0}}); }
  GraphPlayer player(const Body& body) const {
    if (body.tracks.empty()) return player();
    std::vector<GraphClip> clips;
    for (std::uint32_t c = 0; c < 3; ++c)
      clips.push_back(
          {.clip = c, .duration_s = 1.0, .root = &body.tracks[c], .root_in_pose = body.walk == Walk::in_pose});
    return GraphPlayer(b, machine, clips);
  }
};

double largest_turn(const std::vector<Quat<double>>& a, const std::vector<Quat<double>>& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) most = std::max(most, angle_between(a[j], b[j]));
  return most;
}

using Poses = std::vector<Quat<double>>;

/// Velocities at a pose from those one and two steps further on, to the second order.
std::vector<Vec3<double>> velocities(const Poses& at, const Poses& one, const Poses& two, double step_s) {
  std::vector<Vec3<double>> found;
  for (std::size_t j = 0; j < at.size(); ++j) {
    const auto turn = [&](const Poses& to) {
      const Quat<double> q = to[j] * quat_conjugate(at[j]);
      return quat_log(q.w < 0.0 ? q * -1.0 : q) * 2.0;
    };
    found.push_back((turn(one) * 4.0 - turn(two)) / (2.0 * step_s));
  }
  return found;
}

constexpr GraphTransitionKind kKinds[] = {GraphTransitionKind::inertialize, GraphTransitionKind::dead_blend};

/// The speed of the character in the ground plane, in a step of the clock.
double speed_of(const GraphPlayer& player, double step_s) {
  return glm::length(translation_of(player.step().root_motion)) / step_s;
}

/// Begins a transition, and compares pose and velocity before and after.
void expect_no_jump(Body& body, GraphPlayer& player, GraphIndex go, double at_s) {
  player.advance(at_s);
  const Poses two_before = body.pose_of(player);
  player.advance(kStep_s);
  const Poses before = body.pose_of(player);
  player.advance(kStep_s);
  const Poses at = body.pose_of(player);
  const Vec3<double> place = body.place_of(player);
  player.trigger(go);
  player.advance(0.0);
  EXPECT_LT(largest_turn(at, body.pose_of(player)), 1e-5) << at_s;
  EXPECT_LT(glm::length(body.place_of(player) - place), 1e-5) << at_s;
  EXPECT_EQ(player.log().size(), 1u);
  player.advance(kStep_s);
  const Poses after = body.pose_of(player);
  player.advance(kStep_s);
  const auto left = velocities(at, before, two_before, -kStep_s);
  const auto right = velocities(at, after, body.pose_of(player), kStep_s);
  double jump = 0.0, side = 0.0;
  for (std::size_t j = 0; j < kJoints; ++j) {
    jump = std::max(jump, glm::length(left[j] - right[j]));
    side = std::max({side, glm::length(left[j]), glm::length(right[j])});
  }
  EXPECT_LT(jump, 0.01 * side) << at_s;
}

TEST(graph_transitions, begin_without_a_jump_at_240_phases) {
  for (const Walk walk : kWalks) {
    Body body(walk);
    for (const GraphTransitionKind kind : kKinds) {
      const Ring ring(kind);
      for (int phase = 1; phase <= 240; ++phase) {
        GraphPlayer player = ring.player(body);
        expect_no_jump(body, player, ring.go, phase / 242.0);
      }
    }
  }
}

TEST(graph_transitions, interrupt_each_other_20_times_a_second) {
  for (const Walk walk : kWalks) {
    Body body(walk);
    for (const GraphTransitionKind kind : kKinds) {
      const Ring ring(kind);
      GraphPlayer player = ring.player(body);
      player.advance(0.013);
      double speed = 0.0;
      for (int i = 0; i < 100; ++i) {
        const auto at = body.pose_of(player);
        const Vec3<double> place = body.place_of(player);
        player.trigger(ring.go);
        player.advance(0.0);
        EXPECT_LT(largest_turn(at, body.pose_of(player)), 1e-5) << i;
        EXPECT_LT(glm::length(body.place_of(player) - place), 1e-5) << i;
        for (int frame = 0; frame < 5; ++frame) {
          player.advance(0.01);
          const double now = speed_of(player, 0.01);
          EXPECT_LT(i + frame == 0 ? 0.0 : std::fabs(now - speed), 1.0) << i;
          speed = now;
        }
      }
      EXPECT_EQ(player.log().size(), 100u);
      player.advance(1.0);
      EXPECT_EQ(player.ops().size(), 1u) << "in the end the target alone";
    }
  }
}

TEST(graph_transitions, name_what_stands_still_with_the_same_bytes_each_frame) {
  const Ring ring(GraphTransitionKind::inertialize);
  GraphPlayer player = ring.player();
  player.advance(0.3);
  player.trigger(ring.go);
  player.advance(0.01);
  const std::vector<PoseOp> first(player.ops().begin(), player.ops().end());
  player.advance(0.01);
  const std::vector<PoseOp> second(player.ops().begin(), player.ops().end());
  ASSERT_EQ(first.size(), 9u);
  ASSERT_EQ(second.size(), 9u);
  EXPECT_NE(first[0], second[0]) << "the target plays";
  for (std::size_t i = 1; i < 8; ++i) EXPECT_EQ(first[i], second[i]) << i;
  EXPECT_NE(first[8], second[8]);
  EXPECT_LE(pose_slots(player.ops()), player.graph().room().slots);
  EXPECT_LE(room_of(player.ops()).kept, player.graph().room().kept);
}

TEST(graph_transitions, keep_the_parameters_of_the_moment_when_they_began) {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed", 0.25f), go = b.trigger("go");
  const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("idle")}, {1, 0, b.clip("walk")}};
  const GraphIndex m = b.machine("m");
  b.state(m, "gaits", b.blend_space("gaits", {.x = speed}, points));
  const GraphIndex jump = b.state(m, "jump", b.clip("jump"));
  b.transition(m, 0, {.duration_s = 0.5f, .to = jump, .kind = GraphTransitionKind::dead_blend}, {when_triggered(go)});
  GraphPlayer player(b, m, {{0, 1.0}, {1, 0.8}, {2, 1.0}});
  player.advance(0.3);
  player.trigger(go);
  player.advance(0.0);
  const std::vector<PoseOp> first(player.ops().begin(), player.ops().end());
  player.set(speed, 0.75f);
  player.advance(0.1);
  ASSERT_EQ(first.size(), 8u);
  ASSERT_EQ(player.ops().size(), 8u);
  for (std::size_t i = 1; i < 7; ++i) EXPECT_EQ(first[i], player.ops()[i]) << i;
}

TEST(graph_transitions, do_not_depend_on_how_time_is_cut) {
  for (const GraphTransitionKind kind : kKinds) {
    GraphBuilder b;
    const GraphIndex m = b.machine("m");
    for (int c = 0; c < 3; ++c) b.state(m, "s", b.clip("c" + std::to_string(c)));
    for (GraphIndex c = 0; c < 3; ++c)
      b.transition(m, c,
                   {.duration_s = 0.4f,
                    .to = static_cast<GraphIndex>((c + 1) % 3),
                    .kind = c == 1 ? GraphTransitionKind::cross_fade : kind},
                   {when_in_state_for(0.15f)});
    GraphPlayer one(b, m, {{0, 1.0}, {1, 1.0}, {2, 1.0}}), many(b, m, {{0, 1.0}, {1, 1.0}, {2, 1.0}});
    for (int i = 0; i < 5; ++i) {
      one.advance(1.0);
      many.advance(0.001, 1000);
      EXPECT_EQ(one.log(), many.log());
      EXPECT_TRUE(std::equal(one.ops().begin(), one.ops().end(), many.ops().begin(), many.ops().end()));
      EXPECT_LE(one.ops().size(), one.graph().room().ops);
      EXPECT_LE(pose_slots(one.ops()), one.graph().room().slots);
    }
  }
}

TEST(graph_transitions, are_cross_fades_where_clips_move_the_character) {
  const Ring ring(GraphTransitionKind::inertialize);
  BoneAnimation forward;
  forward.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 0, 0}, {0, 0, 2}}};
  const RootTrack track = RootTrack::make(forward, {}, {}, 1e-5);
  GraphPlayer player(ring.b, ring.machine, {{0, 1.0, {}, &track}, {1, 1.0}, {2, 1.0}});
  player.trigger(ring.go);
  player.advance(0.1);
  ASSERT_EQ(player.ops().size(), 3u);
  EXPECT_EQ(player.ops()[2].kind, PoseOpKind::mean);
}

TEST(graph_transitions, a_select_that_was_left_keeps_its_choice) {
  for (const auto kind : {GraphTransitionKind::inertialize, GraphTransitionKind::dead_blend}) {
    GraphBuilder b;
    const GraphIndex pick = b.number("pick"), go = b.flag("go");
    const std::vector<GraphIndex> children = {b.clip("a"), b.clip("b")};
    const GraphIndex machine = b.machine("m");
    const GraphIndex choice = b.state(machine, "choice", b.select("select", pick, children));
    const GraphIndex other = b.state(machine, "other", b.clip("c"));
    b.transition(machine, choice, {.duration_s = 1.0f, .to = other, .kind = kind}, {when_on(go)});
    GraphPlayer player(b, machine, {{0, 1.0}, {1, 1.0}, {2, 1.0}});
    player.advance(0.3);
    player.set(go, 1.0f);
    player.advance(0.1);
    const std::vector<PoseOp> before(player.ops().begin(), player.ops().end());
    player.set(pick, 1.0f);
    player.advance(0.0);
    EXPECT_EQ(std::vector<PoseOp>(player.ops().begin(), player.ops().end()), before);
  }
}

}  // namespace
}  // namespace sinew::test
