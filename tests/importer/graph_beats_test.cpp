// SPDX-License-Identifier: MIT
// Beats of clips: named events, and touchdowns of feet where a clip has no such events.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "importer/graph/graph_beats.h"
#include "importer/graph/graph_text.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kTurn = 6.283185307179586;

/// Heights of a foot that is highest at a phase, and on the ground in the other half of the cycle.
std::vector<double> steps(double top, int count, double lift = 0.2) {
  std::vector<double> heights;
  for (int i = 0; i < count; ++i)
    heights.push_back(lift * std::max(0.0, std::cos(kTurn * (static_cast<double>(i) / count - top))));
  return heights;
}

TEST(graph_beats, a_foot_comes_down_after_its_highest_place) {
  // The height falls through a tenth of the lift at acos(0.1) of a turn behind the top.
  const double behind = std::acos(0.1) / kTurn;
  for (const double top : {0.0, 0.3, 0.9}) {
    const std::vector<double> phases = find_touchdowns(steps(top, 512), 0.05);
    ASSERT_EQ(phases.size(), 1u) << top;
    EXPECT_NEAR(phases[0], top + behind - std::floor(top + behind), 1e-5) << top;
  }
}

TEST(graph_beats, small_bounces_and_feet_that_stay_are_no_steps) {
  std::vector<double> heights = steps(0.3, 512);
  for (std::size_t i = 400; i < 410; ++i) heights[i] = 0.05;  // below three tenths of the lift
  EXPECT_EQ(find_touchdowns(heights, 0.05).size(), 1u);
  heights[405] = 0.1;
  EXPECT_EQ(find_touchdowns(heights, 0.05).size(), 2u);
  EXPECT_THAT(find_touchdowns(steps(0.3, 512, 0.04), 0.05), IsEmpty());
  EXPECT_THAT(find_touchdowns(std::vector<double>(16, 1.0), 0.0), IsEmpty());
  EXPECT_THAT(find_touchdowns({}, 0.0), IsEmpty());
}

/// A model of three joints; joint "left" is raised in the first half of the clip.
struct Walker {
  Skeleton skeleton;
  Animation clip;

  Walker() {
    skeleton = test::skeleton_of({kNone, 0, 0});
    skeleton.names = {"body", "left", "right"};
    skeleton.rest[0].translation = {0, 1, 0};
    for (const std::size_t foot : {1, 2}) skeleton.rest[foot].translation = {0, -1, 0};
    BoneAnimation left;
    left.joint = 1;
    left.translation = {
        Interpolation::linear, {0.0f, 0.25f, 0.5f, 1.0f}, {{0, -1, 0}, {0, -0.8f, 0}, {0, -1, 0}, {0, -1, 0}}};
    clip.bones = {left};
    clip.duration_s = 1.0f;
  }
};

GraphDocument document() {
  GraphDocument document;
  document.beats["left"] = {.foot = "left", .mirror = "right"};
  document.beats["right"] = {.event = "right down", .foot = "right", .mirror = "left"};
  return document;
}

TEST(graph_beats, events_come_before_touchdowns) {
  Walker walker;
  std::vector<SyncBeat> beats = find_beats(document(), walker.clip, walker.skeleton);
  ASSERT_EQ(beats.size(), 1u) << "the right foot does not move";
  EXPECT_NEAR(beats[0].phase, 0.475, 1e-4);
  EXPECT_EQ(beats[0].name, 0u);
  walker.clip.annotations.add_event(1.0, "right down");
  walker.clip.annotations.add_event(0.3, "left");
  walker.clip.annotations.add_event(0.3005, "right down");
  beats = find_beats(document(), walker.clip, walker.skeleton);
  ASSERT_EQ(beats.size(), 2u) << "the third event is less than a thousandth of the clip behind the second";
  EXPECT_EQ(beats[0].phase, 0.0) << "the end of a clip is its start";
  EXPECT_EQ(beats[0].name, 1u);
  EXPECT_EQ(beats[1].phase, 0.3);
  EXPECT_EQ(beats[1].name, 0u);
}

TEST(graph_beats, have_mirrored_names_that_exist) {
  EXPECT_THAT(mirrored_beats(document()), ElementsAre(1u, 0u));
  GraphDocument graph = document();
  graph.root = "a";
  graph.nodes["a"].clip = "a";
  graph.beats["left"].mirror = "middle";
  const auto compiled = compile_graph(graph);
  ASSERT_FALSE(compiled.has_value());
  EXPECT_EQ(compiled.error().json_pointer, "/beats/left/mirror");
}

}  // namespace
}  // namespace sinew
