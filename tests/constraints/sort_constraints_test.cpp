// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/procedures/constraints/node_constraints.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using Kind = NodeConstraint::Kind;

/// Joint 0 has the children 1 and 2; 3 is below 1, 4 below 2.
const Skeleton& tree() {
  static const Skeleton skeleton = test::skeleton_of({kNone, 0, 0, 1, 2});
  return skeleton;
}

std::vector<std::uint32_t> order_of(const std::vector<NodeConstraint>& list) {
  std::vector<std::uint32_t> joints;
  const NodeConstraints sorted = sort_constraints(tree(), list).value();
  for (const NodeConstraint& c : sorted.ordered()) joints.push_back(c.joint);
  return joints;
}

TEST(sort_constraints, each_comes_after_those_that_it_reads) {
  EXPECT_EQ(order_of({{Kind::rotation, 4, 3}, {Kind::rotation, 3, 1}, {Kind::rotation, 1, 2}}),
            (std::vector<std::uint32_t>{1, 3, 4}));
}

TEST(sort_constraints, an_aim_reads_the_joints_above_its_source_and_itself) {
  EXPECT_EQ(order_of({{Kind::aim, 4, 3, {0, 1, 0}}, {Kind::rotation, 2, 0}, {Kind::rotation, 1, 0}}),
            (std::vector<std::uint32_t>{1, 2, 4}));
}

TEST(sort_constraints, circles_are_refused_by_name) {
  const NodeConstraint circle[] = {{Kind::rotation, 1, 2}, {Kind::rotation, 2, 3}, {Kind::rotation, 3, 1}};
  const auto sorted = sort_constraints(tree(), circle);
  ASSERT_FALSE(sorted);
  EXPECT_EQ(sorted.error().code, ErrorCode::follows_itself);
  EXPECT_EQ(sorted.error().text,
            "constraints[0]: joint \"joint1\" follows \"joint2\", which follows \"joint3\", which follows \"joint1\"");
  const NodeConstraint aims_below[] = {{Kind::aim, 1, 3, {0, 1, 0}}};
  EXPECT_EQ(sort_constraints(tree(), aims_below).error().text, "constraints[0]: joint \"joint1\" follows \"joint1\"");
}

TEST(sort_constraints, names_the_entry_and_the_rule) {
  const auto text_of = [](const std::vector<NodeConstraint>& list) {
    const auto sorted = sort_constraints(tree(), list);
    return sorted ? std::string() : sorted.error().text;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(text_of({{Kind::rotation, 9, 0}}), "constraints[0]: the skeleton has no such joint");
  EXPECT_EQ(text_of({{Kind::rotation, 1, 0}, {Kind::rotation, 1, 2}}),
            "constraints[1]: joint \"joint1\" has a constraint already");
  EXPECT_EQ(text_of({{Kind::aim, 1, 2}}), "constraints[0]: its axis has no direction");
  EXPECT_EQ(text_of({{Kind::aim, 1, 2, {0, nan, 0}}}), "constraints[0]: its axis is not finite");
  EXPECT_EQ(text_of({{Kind::rotation, 1, 2, {}, 1.5}}), "constraints[0]: its weight is not between 0 and 1");
}

/// A chain of a hundred thousand constraints, each of which reads the next, needs no deep stack.
TEST(sort_constraints, long_chains_are_sorted_without_recursion) {
  constexpr std::uint32_t kCount = 100000;
  const Skeleton skeleton = test::skeleton_of(std::vector<std::uint32_t>(kCount, kNone));
  std::vector<NodeConstraint> list;
  for (std::uint32_t j = 0; j + 1 < kCount; ++j) list.push_back({Kind::rotation, j, j + 1});
  const auto sorted = sort_constraints(skeleton, list);
  ASSERT_TRUE(sorted);
  EXPECT_EQ(sorted->ordered().front().joint, kCount - 2);
}

}  // namespace
}  // namespace sinew
