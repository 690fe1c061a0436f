// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_masks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "runtime/graph/graph_builder.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;

/// joint0, with joint1 and joint2 below it, and joint3 below joint1.
const Skeleton kTree = test::skeleton_of({kNone, 0, 0, 1});

class GraphMasks : public testing::Test {
 protected:
  GraphMasks() {
    GraphBuilder b;
    tables_ = b.tables(b.clip("walk"));
  }

  GraphMaskJoint joint(std::string_view name, float weight, bool below = true) {
    const auto offset = static_cast<std::uint32_t>(tables_.names.size());
    tables_.names.append(name).push_back('\0');
    return {.name = offset, .weight = weight, .below = below};
  }

  GraphTables tables_;
};

TEST_F(GraphMasks, set_joints_and_those_below_them_in_the_order_of_their_entries) {
  tables_.mask_joints = {joint("joint0", 0.5f), joint("joint1", 1.0f), joint("joint3", 0.0f),
                         joint("joint1", 0.25f, false), joint("joint0", 1.0f, false)};
  tables_.masks = {{.first_joint = 0, .joint_count = 2},
                   {.first_joint = 0, .joint_count = 3},
                   {.first_joint = 3, .joint_count = 1},
                   {.first_joint = 4, .joint_count = 1},
                   {.first_joint = 0, .joint_count = 0}};
  const auto masks = make_graph_masks(tables_, kTree);
  ASSERT_TRUE(masks);
  EXPECT_THAT(*masks, ElementsAre(ElementsAre(0.5f, 1.0f, 0.5f, 1.0f), ElementsAre(0.5f, 1.0f, 0.5f, 0.0f),
                                  ElementsAre(0.0f, 0.25f, 0.0f, 0.0f), ElementsAre(1.0f, 0.0f, 0.0f, 0.0f),
                                  ElementsAre(0.0f, 0.0f, 0.0f, 0.0f)));
}

TEST_F(GraphMasks, of_joints_that_the_skeleton_lacks_are_refused) {
  tables_.mask_joints = {joint("tail", 1.0f)};
  tables_.masks = {{.first_joint = 0, .joint_count = 1}};
  EXPECT_EQ(make_graph_masks(tables_, kTree).error(), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew
