// SPDX-License-Identifier: MIT
// `sinew plan --program` from outside: the operations of a pose program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "importer/graph/program_schema.h"
#include "runtime/pose_program/pose_program.h"
#include "tests/importer/tool_model.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;

class ToolProgram : public testing::Test {
 protected:
  CommandOutcome plan(const std::string& operations, std::vector<std::string> more = {"--json"}) {
    std::ofstream(model_.beside("p.json"))
        << R"({"program": 1, "masks": {"upper": ["tip"]}, "operations": )" << operations << "}";
    std::vector<std::string> arguments = {"plan", model_.path(), "--program", model_.beside("p.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tool(arguments);
  }
  Json operations_of(const std::string& operations) {
    const CommandOutcome outcome = plan(operations);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out)["operations"];
  }
  std::string refusal(const std::string& operations) {
    const CommandOutcome outcome = plan(operations);
    EXPECT_EQ(outcome.status, 1) << operations;
    return outcome.err;
  }

  ToolModelFile model_;
};

TEST_F(ToolProgram, each_operation_has_its_reason_and_its_share) {
  const Json rows = operations_of(R"([{"op": "sample", "clip": "bend", "time_s": 0.25, "weight": 0.25},
    {"op": "sample", "clip": "talk", "weight": 0.75}, {"op": "sample_mirrored", "clip": "bend", "weight": 0},
    {"op": "mean", "operands": 3}, {"op": "external", "mask": "upper"}, {"op": "overlay"},
    {"op": "procedure", "share": 0}, {"op": "rest"}, {"op": "overlay_model"}, {"op": "override_joints"}])");
  ASSERT_EQ(rows.size(), 10u);
  EXPECT_EQ(rows[0]["operation"], "sample \"bend\" at 0.25 s, weight 0.25");
  EXPECT_EQ(rows[2]["reason"], "its weight is 0");
  EXPECT_EQ(rows[4]["operation"], "external 0, mask \"upper\"");
  EXPECT_EQ(rows[6]["reason"], "operation 7 covers it in full");
  for (const std::size_t below : {0u, 1u, 3u, 4u}) {
    EXPECT_FALSE(rows[below]["needed"].get<bool>()) << below;
    EXPECT_THAT(rows[below]["reason"].get<std::string>(), HasSubstr("is not needed")) << below;
  }
  EXPECT_EQ(rows[5]["reason"], "operation 6 is not needed");
  EXPECT_EQ(rows[7]["reason"], "for operation 8 (overlay_model)");
  EXPECT_EQ(rows[9]["reason"], "the pose of the frame");
  const Json mixed = operations_of(R"([{"op": "sample", "clip": "bend", "weight": 0.25},
    {"op": "sample", "clip": "talk", "weight": 0.75}, {"op": "mean"}])");
  EXPECT_EQ(mixed[0]["share"], 0.25);
  EXPECT_EQ(mixed[0]["count"], 1) << "tracks";
  EXPECT_EQ(mixed[2]["count"], 2) << "poses";
  EXPECT_TRUE(mixed[0]["needed"].get<bool>());
  EXPECT_FALSE(mixed[0].contains("microseconds"));
  const Json idle = operations_of(R"([{"op": "sample", "clip": "bend"}, {"op": "procedure", "share": 0}])");
  EXPECT_EQ(idle[1]["reason"], "its share is 0");
  EXPECT_TRUE(idle[0]["needed"].get<bool>()) << "its pose passes";
}

TEST_F(ToolProgram, the_table_tells_times_where_they_are_asked_for) {
  const std::string program = R"([{"op": "sample", "clip": "bend"}, {"op": "cached"}])";
  const CommandOutcome plain = plan(program, {}), timed = plan(program, {"--times"});
  EXPECT_THAT(plain.out, HasSubstr("operations of the program:"));
  EXPECT_THAT(plain.out, testing::Not(HasSubstr(" us ")));
  EXPECT_THAT(timed.out, HasSubstr(" us "));
  EXPECT_EQ(plan(program, {}).out, plain.out) << "without times it is the same each time";
}

TEST_F(ToolProgram, faults_are_named_with_their_place) {
  EXPECT_THAT(refusal("3"), HasSubstr("p.json: /operations: is no list"));
  EXPECT_THAT(refusal("[]"), HasSubstr("p.json: /operations: "));
  EXPECT_THAT(refusal(R"([{"op": "sing"}])"), HasSubstr("/operations/0/op: is none of rest, sample, "));
  EXPECT_THAT(refusal(R"([{"op": "sample"}])"), HasSubstr("/operations/0: has no \"clip\""));
  EXPECT_THAT(refusal(R"([{"op": "sample", "clip": "sing"}])"),
              HasSubstr("/operations/0/clip: the model has no clip \"sing\""));
  EXPECT_THAT(refusal(R"([{"op": "rest", "clip": "bend"}])"), HasSubstr("/operations/0/clip: is not a known key here"));
  EXPECT_THAT(refusal(R"([{"op": "rest", "mask": "lower"}])"),
              HasSubstr("/operations/0/mask: there is no mask \"lower\""));
  EXPECT_THAT(refusal(R"([{"op": "external", "index": -1}])"), HasSubstr("/operations/0/index: lies outside of"));
  EXPECT_THAT(refusal(R"([{"op": "rest"}, {"op": "overlay"}])"),
              HasSubstr("/operations/1: it takes more poses than those before it leave"));
  EXPECT_THAT(refusal(R"([{"op": "rest", "weight": -1}])"), HasSubstr("/operations/0: "));
  std::string many = "[{\"op\": \"rest\"}";
  for (int i = 0; i < 255; ++i) many += ", {\"op\": \"cached\"}";
  EXPECT_THAT(refusal(many + "]"), HasSubstr("/operations: has more than 255 operations"));
}

TEST(program_schema, words_are_the_names_of_the_operations) {
  const auto words = graph_schema::words_of(PoseOpKind{});
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_STREQ(words[i], name_of(static_cast<PoseOpKind>(i)));
  EXPECT_STREQ(name_of(static_cast<PoseOpKind>(words.size())), "?");
}

}  // namespace
}  // namespace sinew::test
