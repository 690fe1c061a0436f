// SPDX-License-Identifier: MIT
// `sinew graph` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/importer/tool_model.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;

const char* const kGraph = R"({"graph": 1, "root": "m",
  "parameters": {"go": {"kind": "flag"}}, "masks": {"upper": ["tip"]},
  "nodes": {"a": {"kind": "clip", "clip": "bend"}, "b": {"kind": "clip", "clip": "talk"},
    "m": {"kind": "machine", "initial": "bent", "states": {
      "bent": {"node": "a", "transitions": [
        {"to": "talks", "when": [{"kind": "on", "parameter": "go"}], "duration_s": 0.5, "fade": "linear"}]},
      "talks": {"node": "b"}}}}})";

std::string graph_beside(const ToolModelFile& model, const std::string& from = {}, const std::string& to = {}) {
  std::string text = kGraph;
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  std::ofstream(model.beside("g.json")) << text;
  return model.beside("g.json");
}

TEST(tool_graph, check_tells_sizes_and_names_faults_with_their_place) {
  const ToolModelFile model;
  const CommandOutcome sound = run_tool({"graph", "check", model.path(), graph_beside(model)});
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("3 nodes, 2 clips, 1 machine, 2 states, 1 transition"));
  EXPECT_THAT(sound.out, HasSubstr("a character's state takes"));
  const auto fault = [&](const char* from, const char* to) {
    const CommandOutcome outcome = run_tool({"graph", "check", model.path(), graph_beside(model, from, to)});
    EXPECT_EQ(outcome.status, 1);
    return outcome.err;
  };
  EXPECT_THAT(fault("\"talk\"", "\"sing\""), HasSubstr("g.json: /nodes/b/clip: the model has no clip \"sing\""));
  EXPECT_THAT(fault("\"tip\"", "\"toe\""), HasSubstr("g.json: /masks/upper/0: the model has no joint \"toe\""));
  EXPECT_THAT(fault("\"duration_s\"", "\"seconds\""),
              HasSubstr("g.json: /nodes/m/states/bent/transitions/0/seconds: is not a known key here"));
  EXPECT_EQ(run_tool({"graph", "check", model.path(), model.beside("none.json")}).status, 1);
  EXPECT_EQ(run_tool({"graph", "check", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"graph", "draw", model.path(), graph_beside(model)}).status, 2);
}

TEST(tool_graph, trace_tells_each_frame_and_a_hash) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model);
  const auto traced = [&](const std::string& setting) {
    const CommandOutcome outcome =
        run_tool({"graph", "trace", model.path(), graph, "--set", setting, "--for", "1", "--fps", "8", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  };
  const Json trace = traced("go=1@0.5");
  ASSERT_EQ(trace["frames"].size(), 9u);
  EXPECT_EQ(trace["frames"][4]["program"].size(), 1u);
  const Json& fading = trace["frames"][6];  // the flag counts from 0.5 s on
  EXPECT_EQ(fading["time_s"], 0.75);
  ASSERT_EQ(fading["states"].size(), 2u);
  EXPECT_EQ(fading["states"][1]["state"], "talks");
  EXPECT_EQ(fading["states"][1]["weight"], 0.5);
  EXPECT_EQ(fading["program"].size(), 3u);
  EXPECT_EQ(trace["frames"][5]["events"][0]["entered"], "talks");
  EXPECT_EQ(trace["frames"][5]["events"][0]["time_s"], 0.5);
  EXPECT_EQ(trace["hash"], traced("go=1@0.5")["hash"]);
  EXPECT_NE(trace["hash"], traced("go=1@0.6")["hash"]);
  const CommandOutcome table = run_tool({"graph", "trace", model.path(), graph, "--for", "0.1"});
  EXPECT_THAT(table.out, HasSubstr("m:bent 1.000"));
  EXPECT_THAT(table.out, HasSubstr("hash "));
}

TEST(tool_graph, trace_refuses_settings_that_mean_nothing) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model);
  for (const char* setting : {"go", "stop=1", "go=much", "go=1@soon", "go=nan"}) {
    const CommandOutcome outcome = run_tool({"graph", "trace", model.path(), graph, "--set", setting});
    EXPECT_EQ(outcome.status, 2) << setting;
    EXPECT_THAT(outcome.err, HasSubstr("--set"));
  }
  EXPECT_THAT(run_tool({"graph", "trace", model.path(), graph, "--set", "stop=1"}).err, HasSubstr("it has \"go\""));
}

TEST(tool_graph, new_needs_clips_that_are_called_like_gaits) {
  const ToolModelFile model;
  const CommandOutcome outcome = run_tool({"graph", "new", model.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no clip is called"));
}

}  // namespace
}  // namespace sinew::test
