// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "importer/tool/poses/compare_poses.h"

namespace sinew::tool {
namespace {

Pose simple_pose() {
  Pose pose;
  pose.time_s = 1.5;
  pose.nodes = {{0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}};
  pose.weights = {{0, {0.5, 4.0}}};
  PrimitivePose primitive{.node = 0, .mesh = 0, .primitive = 1, .vertices = {2, 9}, .values = {}};
  primitive.of(VertexKind::positions) = {0, 0, 0, 1, 1, 1};
  primitive.of(VertexKind::normals) = {0, 0, 1, 0, 1, 0};
  primitive.of(VertexKind::dqs) = {0, 0, 0, NAN, NAN, NAN};
  pose.primitives = {primitive};
  return pose;
}

/// Compares the simple pose with what `change` made of it.
template <class Change>
PoseComparison after(const Change& change, PoseTolerance tolerance = {.distance_m = 0.01, .model_size_m = 2.0}) {
  Pose golden = simple_pose(), pose = simple_pose();
  change(golden, pose);
  PoseComparison comparison(tolerance);
  comparison.compare(4, golden, pose);
  return comparison;
}

TEST(compare_poses, an_unchanged_pose_has_no_deviation_at_all) {
  const auto same = after([](Pose&, Pose&) {}, {.distance_m = 0.0, .direction = 0.0, .weight = 0.0});
  EXPECT_EQ(same.failed(), 0u);
  EXPECT_EQ(same.compared(), 2u + 1u + 2u + 2u + 1u);  // null entries are passed over
  EXPECT_EQ(same.largest_m(), 0.0);
}

TEST(compare_poses, a_moved_vertex_is_named_with_its_distance) {
  const auto moved = after([](Pose&, Pose& pose) { pose.primitives[0].of(VertexKind::positions)[4] += 0.02; });
  ASSERT_EQ(moved.failed(), 1u);
  EXPECT_EQ(moved.worst()[0].where, "clip 4, 1.5 s, node 0, primitive 1, vertex 9, positions");
  EXPECT_NEAR(moved.worst()[0].amount, 0.02, 1e-12);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].of(VertexKind::positions)[4] += 0.009; }).failed(), 0u);
}

TEST(compare_poses, a_turned_node_counts_by_what_it_moves_at_the_models_size) {
  const auto turn = [](double by) { return [by](Pose&, Pose& pose) { pose.nodes[0].world[1] = by; }; };
  EXPECT_EQ(after(turn(0.006)).failed(), 1u);  // 0.006 * 2 m > 0.01 m
  EXPECT_EQ(after(turn(0.004)).failed(), 0u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.nodes[0].world[12] += 0.011; }).failed(), 1u);
}

TEST(compare_poses, without_a_distance_values_count_relative_to_their_size) {
  const PoseTolerance relative{.distance_m = {}, .model_size_m = 2.0};
  const auto shift = [](double by) { return [by](Pose&, Pose& pose) { pose.nodes[0].world[12] += by; }; };
  EXPECT_EQ(after(shift(0.0009), relative).failed(), 0u);  // 1e-4 of 10 m
  EXPECT_EQ(after(shift(0.0011), relative).failed(), 1u);
}

TEST(compare_poses, weights_beyond_one_count_relative_and_directions_absolute) {
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.weights[0].weights[1] += 3e-4; }).failed(), 0u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.weights[0].weights[1] += 5e-4; }).failed(), 1u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].of(VertexKind::normals)[0] = 9e-4; }).failed(), 0u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].of(VertexKind::normals)[0] = 2e-3; }).failed(), 1u);
}

TEST(compare_poses, what_is_missing_fails_and_what_is_more_does_not) {
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.nodes.clear(); }).failed(), 2u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.weights[0].weights.pop_back(); }).failed(), 1u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives.clear(); }).failed(), 5u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].vertices[1] = 8; }).failed(), 2u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].vertices[1] = 10; }).failed(), 2u) << "a vertex behind it";
  EXPECT_EQ(after([](Pose& golden, Pose& pose) {
              golden.primitives[0].vertices[1] = 8;  // the pose has the same values for vertex 9
              pose.primitives[0].of(VertexKind::dqs)[3] = NAN;
            }).failed(),
            2u);
  EXPECT_EQ(after([](Pose&, Pose& pose) { pose.primitives[0].of(VertexKind::dqs)[0] = NAN; }).failed(), 1u);
  EXPECT_EQ(after([](Pose& golden, Pose&) {
              golden.primitives.clear();
              golden.nodes.clear();
            }).failed(),
            0u);
}

TEST(compare_poses, rotations_that_are_not_unit_in_the_golden_sample_widen_the_tolerance) {
  const auto change = [](Pose& golden, Pose& pose) {
    golden.non_unit = 0.01;
    pose.primitives[0].of(VertexKind::positions)[4] += 0.035;  // 0.01 + 1.5 * 0.01 * 2 m = 0.04 m
  };
  EXPECT_EQ(after(change).failed(), 0u);
}

TEST(compare_poses, tolerances_of_every_kind_grow_by_what_rotations_may_change) {
  const std::pair<const char*, double& (*)(Pose&)> values[] = {
      {"translation", [](Pose& p) -> double& { return p.nodes[0].world[13]; }},
      {"rotation", [](Pose& p) -> double& { return p.nodes[0].world[1]; }},
      {"weights", [](Pose& p) -> double& { return p.weights[0].weights[0]; }},
      {"positions", [](Pose& p) -> double& { return p.primitives[0].of(VertexKind::positions)[0]; }},
      {"normals", [](Pose& p) -> double& { return p.primitives[0].of(VertexKind::normals)[0]; }},
      {"dqs", [](Pose& p) -> double& { return p.primitives[0].of(VertexKind::dqs)[0]; }}};
  for (const auto& [name, value] : values) {
    const auto failed = [&, value = value](double non_unit) {
      return after([&](Pose& golden, Pose& pose) {
               golden.non_unit = non_unit;
               value(pose) += 0.02;
             })
          .failed();
    };
    EXPECT_EQ(failed(0.0), 1u) << name;
    EXPECT_EQ(failed(0.02), 0u) << name;
  }
}

TEST(compare_poses, keeps_the_worst_in_order) {
  const auto many = after([](Pose&, Pose& pose) {
    pose.primitives[0].of(VertexKind::positions) = {0.05, 0, 0, 1, 1, 1.5};
    pose.nodes[0].world[13] = 0.2;
    pose.primitives[0].of(VertexKind::dqs)[2] = 0.02;
  });
  EXPECT_EQ(many.failed(), 4u);
  const std::vector<Deviation> worst = many.worst();
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_NEAR(worst[0].amount, 0.5, 1e-12);
  EXPECT_EQ(worst[0].more, 1u) << "another vertex of the primitive";
  EXPECT_NEAR(worst[1].amount, 0.2, 1e-12);
  EXPECT_NEAR(worst[2].amount, 0.02, 1e-12);
}

TEST(compare_poses, names_follow_numbers_where_they_are_known) {
  Pose golden = simple_pose(), pose = simple_pose();
  pose.nodes[0].world[12] += 1.0;
  PoseComparison comparison({.distance_m = 0.01, .model_size_m = 2.0}, {{"", "", "", "", "\"Walk\""}, {"\"hand\""}});
  comparison.compare(4, golden, pose);
  EXPECT_EQ(comparison.worst()[0].where, "clip 4 \"Walk\", 1.5 s, node 0 \"hand\", translation");
}

TEST(compare_poses, what_has_no_tolerance_is_ordered_by_its_amount) {
  const auto moved = after(
      [](Pose&, Pose& pose) {
        pose.primitives[0].of(VertexKind::positions)[0] = 0.001;
        pose.nodes[0].world[12] += 1.0;
      },
      {.distance_m = 0.0, .model_size_m = 2.0});
  ASSERT_EQ(moved.worst().size(), 2u);
  EXPECT_NEAR(moved.worst()[0].amount, 1.0, 1e-12);
}

TEST(compare_poses, directions_and_matrices_have_tolerances_of_their_own) {
  const auto turn_normal = [](double rad) {
    return [rad](Pose&, Pose& pose) {
      pose.primitives[0].of(VertexKind::normals)[1] = std::sin(rad);
      pose.primitives[0].of(VertexKind::normals)[2] = std::cos(rad);
    };
  };
  const PoseTolerance degree{.distance_m = 0.01, .direction = 2.0 * std::sin(0.5 * M_PI / 180.0), .model_size_m = 2.0};
  EXPECT_EQ(after(turn_normal(0.9 * M_PI / 180.0), degree).failed(), 0u);
  const auto turned = after(turn_normal(2.0 * M_PI / 180.0), degree);
  ASSERT_EQ(turned.failed(), 1u);
  EXPECT_NEAR(turned.worst()[0].amount, 2.0, 1e-9);
  EXPECT_STREQ(turned.worst()[0].unit, "deg");
  const auto turn_node = [](Pose&, Pose& pose) { pose.nodes[0].world[1] = 0.3; };
  EXPECT_EQ(after(turn_node, {.distance_m = 0.01, .matrix = 0.4, .model_size_m = 2.0}).failed(), 0u);
  EXPECT_EQ(after(turn_node, {.distance_m = 9.0, .matrix = 0.2, .model_size_m = 2.0}).failed(), 1u);
}

/// A pose of a fan of ten vertices, and the same with vertices numbered from the other end.
std::pair<Pose, Pose> renumbered_poses() {
  std::pair<Pose, Pose> poses;
  PrimitivePose primitive{.node = 3, .mesh = 0, .primitive = 0, .vertices = {}, .values = {}};
  PrimitivePose reversed = primitive;
  for (std::uint32_t v = 0; v < 10; ++v) {
    primitive.vertices.push_back(v);
    for (const double x : {static_cast<double>(v), 0.1 * v * v, 0.0}) primitive.of(VertexKind::positions).push_back(x);
    const double w = 9.0 - v;
    for (const double x : {w, 0.1 * w * w, 0.0}) reversed.of(VertexKind::positions).push_back(x);
  }
  reversed.vertices = primitive.vertices;
  poses.first.primitives = {primitive};
  poses.second.primitives = {reversed};
  return poses;
}

TEST(compare_poses, vertices_with_other_numbers_are_told_once_and_not_as_distances) {
  auto [golden, pose] = renumbered_poses();
  PoseComparison comparison({.distance_m = 1e-3, .model_size_m = 2.0});
  comparison.compare(0, golden, pose);
  comparison.compare(0, golden, pose);
  ASSERT_EQ(comparison.worst().size(), 1u);
  EXPECT_STREQ(comparison.worst()[0].unit, "numbers");
  EXPECT_EQ(comparison.failed(), 1u);
  EXPECT_EQ(comparison.largest_m(), 0.0);
  pose.primitives[0].of(VertexKind::positions)[0] += 0.5;  // one golden place is nobody's
  PoseComparison moved({.distance_m = 1e-3, .model_size_m = 2.0});
  moved.compare(0, golden, pose);
  EXPECT_EQ(moved.failed(), 10u);
  EXPECT_NEAR(moved.largest_m(), std::hypot(9.0, 8.1), 1.0);
}

}  // namespace
}  // namespace sinew::tool
