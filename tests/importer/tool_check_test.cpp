// SPDX-License-Identifier: MIT
// `sinew check`: grouped reports with true counts, severities as the user wants them, the table of rules.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "importer/rules.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// A file with `count` rotations that are too long.
std::string long_rotations(std::size_t count) {
  json nodes = json::array();
  for (std::size_t n = 0; n < count; ++n) nodes.push_back({{"rotation", {0, 0, 0, 2}}});
  return json{{"asset", {{"version", "2.0"}}}, {"nodes", nodes}}.dump();
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(check_command, cases_of_one_rule_share_a_line_with_their_true_number) {
  const ToolModelFile model;
  const std::string file = model.beside("long.gltf");
  std::ofstream(file) << long_rotations(183);
  const std::string text = run_tool({"check", file}).out;
  EXPECT_EQ(line_count(text), 2u);
  EXPECT_THAT(text, HasSubstr(file + ": /nodes/0/rotation: rotation-length x183: warning: "));
  EXPECT_THAT(text, HasSubstr(": 0 errors, 183 warnings\n"));
  const std::string all = run_tool({"check", file, "--all"}).out;
  EXPECT_EQ(line_count(all), 184u);
  EXPECT_THAT(all, HasSubstr(file + ": /nodes/182/rotation: rotation-length: warning: "));
  EXPECT_THAT(run_tool({"plan", file}).err, HasSubstr("/nodes/0/rotation: rotation-length x183: warning: "));
  const json report = json::parse(run_tool({"check", file, "--json"}).out);
  EXPECT_EQ(report["warnings"], 183);
  std::size_t cases = 0;
  for (const json& issue : report["issues"]) cases += issue["cases"].get<std::size_t>();
  EXPECT_EQ(cases, 183u);
}

TEST(check_command, info_tells_each_warning_once) {
  const ToolModelFile model;
  const std::string file = model.beside("long.gltf");
  std::ofstream(file) << long_rotations(70);
  const CommandOutcome outcome = run_tool({"info", file});
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("warnings: 70\n  /nodes/0/rotation: rotation-length x70: "));
  EXPECT_THAT(outcome.out, Not(HasSubstr("/nodes/1/")));
  EXPECT_THAT(run_tool({"info", file, "--all"}).out, HasSubstr("\n  /nodes/63/rotation: rotation-length: "));
}

TEST(check_command, strict_fails_on_warnings_but_not_on_infos) {
  const ToolModelFile model;
  const std::string warned = model.beside("long.gltf"), spare = model.beside("spare.gltf");
  std::ofstream(warned) << long_rotations(1);
  std::ofstream(spare) << R"({"asset": {"version": "2.0"}, "materials": [{}]})";
  EXPECT_EQ(run_tool({"check", warned}).status, 0);
  EXPECT_EQ(run_tool({"check", warned, "--strict"}).status, 1);
  const CommandOutcome outcome = run_tool({"check", spare, "--strict"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, spare + ": /materials/0: unused-object: info: nothing refers to it\n" + spare +
                             ": 0 errors, 0 warnings, 1 info\n");
}

TEST(check_command, severities_are_what_the_user_says) {
  const ToolModelFile model;
  const std::string warned = model.beside("long.gltf"), broken = model.beside("broken.gltf");
  std::ofstream(warned) << long_rotations(3);
  std::ofstream(broken) << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}], "materials": [{}]})";
  const CommandOutcome raised = run_tool({"check", warned, "--severity", "rotation-length=error"});
  EXPECT_EQ(raised.status, 1);
  EXPECT_THAT(raised.out, HasSubstr("rotation-length x3: error: "));
  EXPECT_THAT(raised.out, HasSubstr(": 3 errors, 0 warnings\n"));
  EXPECT_EQ(run_tool({"check", warned, "--severity", "rotation-length=off", "--strict"}).out,
            warned + ": 0 errors, 0 warnings\n");
  EXPECT_EQ(run_tool({"check", broken, "--severity", "json-bom=error,reference=warning"}).status, 0);
  EXPECT_EQ(run_tool({"check", "--severity", "reference=warning", broken}).status, 0) << "the file is no severity";
  EXPECT_EQ(run_tool({"check", broken, "--severity", "reference=off", "--severity", "reference=error"}).status, 1);
  EXPECT_THAT(run_tool({"check", broken, "--severity", "refrence=off"}).err, HasSubstr("there is no rule refrence"));
  for (const char* wrong : {"refrence=off", "reference", "reference=fatal", "=off"})
    EXPECT_EQ(run_tool({"check", broken, "--severity", wrong}).status, 2) << wrong;
}

TEST(check_command, errors_come_first_then_warnings_then_infos) {
  const ToolModelFile model;
  const std::string file = model.beside("mixed.gltf");
  std::ofstream(file) << R"({"asset": {"version": "2.0"}, "materials": [{}], "nodes": [{"rotation": [0, 0, 0, 2]}]})";
  const std::string text = run_tool({"check", file, "--severity", "unused-object=error"}).out;
  EXPECT_LT(text.find("unused-object: error"), text.find("rotation-length: warning"));
  const std::string plain = run_tool({"check", file}).out;
  EXPECT_LT(plain.find("rotation-length: warning"), plain.find("unused-object: info"));
}

TEST(check_command, a_faulty_channel_is_an_error_here_and_costs_no_other_command_the_file) {
  const ToolModelFile place;
  TinyGltf gltf;
  gltf.add_triangle();
  gltf.animate("translation", gltf.times({0, 1}), gltf.vec3({0, 0, 0, 1, 2, 3}));
  const std::string counts = place.beside("counts.gltf"), data = place.beside("data.gltf");
  gltf.root["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
  std::ofstream(counts) << gltf.text();
  gltf.root["accessors"][2]["count"] = 50;
  std::ofstream(data) << gltf.text();
  for (const std::string& file : {counts, data}) {
    const CommandOutcome check = run_tool({"check", file});
    EXPECT_EQ(check.status, 1);
    EXPECT_THAT(check.out, HasSubstr("left out"));
    EXPECT_THAT(check.out, HasSubstr(": error: "));
    for (const char* command : {"info", "plan", "sample"}) {
      const CommandOutcome outcome = run_tool({command, file});
      EXPECT_EQ(outcome.status, 0) << command << ": " << outcome.err;
      EXPECT_THAT(outcome.out + outcome.err, HasSubstr("left out")) << command;
    }
  }
  EXPECT_THAT(run_tool({"info", data, "--json"}).out, HasSubstr("\"rule\": \"accessor-fit\""))
      << "what keeps it from being converted";
}

TEST(check_command, the_table_of_rules_names_every_rule_within_100_columns) {
  const CommandOutcome outcome = run_tool({"check", "--rules"});
  EXPECT_EQ(outcome.status, 0);
  for (const RuleText& rule : all_rules())
    EXPECT_THAT("\n" + outcome.out, HasSubstr("\n" + std::string(rule.id) + " ")) << rule.id;
  std::istringstream stream(outcome.out);
  for (std::string line; std::getline(stream, line);) EXPECT_LE(line.size(), 100u) << line;
  const json rules = json::parse(run_tool({"check", "--rules", "--json"}).out);
  ASSERT_EQ(rules.size(), all_rules().size());
  EXPECT_EQ(rules[0]["severity"], "error");
  EXPECT_EQ(run_tool({"check"}).status, 2) << "without --rules a file is needed";
}

}  // namespace
}  // namespace sinew::test
