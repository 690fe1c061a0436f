// SPDX-License-Identifier: MIT
// `sinew graph` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

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
  EXPECT_THAT(fault("\"masks\"", "\"beats\": {\"l\": {\"foot\": \"claw\"}}, \"masks\""),
              HasSubstr("g.json: /beats/l/foot: the model has no joint \"claw\""));
  EXPECT_THAT(fault("\"duration_s\"", "\"seconds\""),
              HasSubstr("g.json: /nodes/m/states/bent/transitions/0/seconds: is not a known key here"));
  EXPECT_EQ(run_tool({"graph", "check", model.path(), model.beside("none.json")}).status, 1);
  EXPECT_EQ(run_tool({"graph", "check", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"graph", "draw", model.path(), graph_beside(model)}).status, 2);
}

TEST(tool_graph, compile_stores_graphs_beside_their_clips) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model), out = model.beside("m.sinew");
  const CommandOutcome done = run_tool({"compile", model.path(), "-o", out, "--graph", graph});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(run_tool({"info", out}).out, HasSubstr("graph \"g\": 3 nodes, 2 clips, programs of at most "));
  const Json info = Json::parse(run_tool({"info", out, "--json"}).out);
  EXPECT_EQ(info["graphs"][0]["name"], "g");
  EXPECT_GT(info["graphs"][0]["most_operations"], 1);
  EXPECT_EQ(run_tool({"check", out}).status, 0);
  const CommandOutcome twice = run_tool({"compile", model.path(), "-o", out, "--graph", graph, "--graph", graph});
  EXPECT_EQ(twice.status, 1);
  EXPECT_THAT(twice.err, HasSubstr("another graph has this name"));
  const std::string other = graph_beside(model, "\"talk\"", "\"sing\"");
  EXPECT_THAT(run_tool({"compile", model.path(), "-o", out, "--graph", other}).err, HasSubstr("has no clip \"sing\""));
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

TEST(tool_graph, diff_says_in_words_what_changed) {
  const ToolModelFile model;
  const std::string before = model.beside("before.json"), after = model.beside("after.json");
  const auto differences = [&](std::string text) {
    std::ofstream(before) << kGraph;
    std::ofstream(after) << text;
    return run_tool({"graph", "diff", before, after});
  };
  const auto changed = [](const char* from, const char* to) {
    std::string text = kGraph;
    return text.replace(text.find(from), std::string(from).size(), to);
  };
  const CommandOutcome same = differences(kGraph);
  EXPECT_EQ(same.status, 0);
  EXPECT_EQ(same.out, "");
  const CommandOutcome slower = differences(changed("\"duration_s\": 0.5", "\"duration_s\": 0.75"));
  EXPECT_EQ(slower.status, 1);
  EXPECT_EQ(slower.out, "node m, state bent, transition to talks: duration_s was 0.5 and is 0.75\n");
  EXPECT_EQ(differences(changed("\"clip\": \"talk\"", "\"clip\": \"talk\", \"speed\": 2")).out,
            "node b: speed is new, 2.0\n");
  EXPECT_EQ(differences(changed(", \"fade\": \"linear\"", "")).out,
            "node m, state bent, transition to talks: fade was \"linear\" and is unset\n");
  // A transition that comes first does not change the other one.
  EXPECT_EQ(differences(changed("\"transitions\": [", "\"transitions\": [{\"to\": \"bent\"},")).out,
            "node m, state bent, transition to bent: is new, {\"to\":\"bent\"}\n");
  EXPECT_EQ(differences(changed("\"b\": {\"kind\": \"clip\", \"clip\": \"talk\"},", "")).out, "node b: is gone\n");
  EXPECT_EQ(run_tool({"graph", "diff", before}).status, 2);
  std::ofstream(after) << "no JSON";
  EXPECT_THAT(run_tool({"graph", "diff", before, after}).err, HasSubstr("after.json: "));
}

TEST(tool_graph, dot_draws_machines_and_what_states_play) {
  const ToolModelFile model;
  const CommandOutcome drawn = run_tool({"graph", "dot", graph_beside(model)});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  for (const char* part : {"digraph", "subgraph \"cluster m\"", "label=\"a\\nclip bend\"",
                           "\"state m/bent\" -> \"state m/talks\" [label=\"go\\n0.5 s\"]",
                           "\"node a\" -> \"state m/bent\"", "\"node m\" -> pose"})
    EXPECT_THAT(drawn.out, HasSubstr(part));
}

TEST(tool_graph, plan_lists_the_program_of_a_moment_with_reasons) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model);
  const CommandOutcome outcome =
      run_tool({"graph", "plan", model.path(), graph, "--set", "go=1@0.5", "--for", "0.75", "--fps", "8", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["time_s"], 0.75);
  ASSERT_EQ(json["states"].size(), 2u);
  ASSERT_EQ(json["operations"].size(), 3u);
  EXPECT_EQ(json["operations"][0]["operation"], "sample \"bend\" at 0.75 s, weight 0.5");
  EXPECT_EQ(json["operations"][0]["reason"], "for operation 2 (mean)");
  EXPECT_EQ(json["operations"][1]["share"], 0.5);
  EXPECT_GT(json["operations"][1]["microseconds"], 0.0);
  EXPECT_THAT(run_tool({"graph", "plan", model.path(), graph}).out, HasSubstr("the pose of the frame"));
  EXPECT_EQ(run_tool({"graph", "plan", model.path(), graph, "--set", "stop=1"}).status, 2);
}

TEST(tool_graph, verify_compares_a_golden_trace_frame_by_frame) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model), golden = model.beside("golden.json");
  const auto write = [&] {
    return run_tool(
        {"graph", "trace", model.path(), graph, "--set", "go=1@0.5", "--for", "1", "--fps", "4", "-o", golden});
  };
  ASSERT_EQ(write().status, 0);
  std::ifstream file(golden);
  const Json json = Json::parse(file);
  EXPECT_EQ(json["graph"], "g.json") << "relative to the trace";
  EXPECT_EQ(json["frames"][3],
            "0.75 s | m:bent 0.5 for 0.75 s, m:talks 0.5 for 0.25 s | sample bend at 0.75 x 0.5, sample talk at 0.25 x "
            "0.5, mean 2 x 1 | m enters talks at 0.5");
  const CommandOutcome same = run_tool({"verify", model.path(), golden});
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("5 frames compared"));

  graph_beside(model, "\"duration_s\": 0.5", "\"duration_s\": 0.4");
  const CommandOutcome differs = run_tool({"verify", model.path(), golden, "--junit", model.beside("report.xml")});
  EXPECT_EQ(differs.status, 1);
  EXPECT_THAT(differs.out, HasSubstr("frame 3: was \"0.75 s | m:bent 0.5 for"));
  EXPECT_THAT(differs.out, HasSubstr("and is \"0.75 s | m:bent 0.375 for"));
  const CommandOutcome updated = run_tool({"verify", model.path(), golden, "--update"});
  EXPECT_EQ(updated.status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0);

  graph_beside(model, "\"talk\"", "\"sing\"");
  const CommandOutcome broken = run_tool({"verify", model.path(), golden});
  EXPECT_EQ(broken.status, 4);
  EXPECT_THAT(broken.err, HasSubstr("g.json: /nodes/b/clip: the model has no clip"));
  std::ofstream(golden) << R"({"trace": 1, "graph": "g.json", "frames": []})";
  EXPECT_THAT(run_tool({"verify", model.path(), golden}).err, HasSubstr("golden.json: has no \"duration_s\""));
  EXPECT_EQ(run_tool({"graph", "trace", model.path(), graph, "-o", graph}).status, 1) << "the graph is at fault now";
}

TEST(tool_graph, a_golden_trace_is_not_written_over_what_it_is_made_from) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model);
  for (const std::string& input : {graph, model.path()})
    EXPECT_EQ(run_tool({"graph", "trace", model.path(), graph, "-o", input}).status, 2) << input;
}

TEST(tool_graph, outputs_of_other_kinds_are_told_apart) {
  const ToolModelFile model;
  const std::string graph = graph_beside(model), folder = model.beside("taken.json");
  std::filesystem::create_directory(folder);
  for (const auto& [out, status] : {std::pair<std::string, int>{folder, 2}, {"/dev/full", 3}, {"/dev/null", 0}})
    EXPECT_EQ(run_tool({"graph", "trace", model.path(), graph, "-o", out}).status, status) << out;
}

}  // namespace
}  // namespace sinew::test
