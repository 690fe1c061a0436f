// SPDX-License-Identifier: MIT
// Graphs that refer to graphs of other files, and variations of their clips.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/importer/tool_model.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;

const char* const kOuter = R"({"graph": 1, "root": "m",
  "parameters": {"go": {"kind": "flag"}, "pace": {"kind": "number", "initial": 1}},
  "nodes": {
    "legs": {"kind": "graph", "file": "legs.json", "parameters": {"speed": "pace"}},
    "b": {"kind": "clip", "clip": "talk"},
    "m": {"kind": "machine", "initial": "moves", "states": {
      "moves": {"node": "legs", "transitions": [{"to": "talks", "when": [{"kind": "on", "parameter": "go"}]}]},
      "talks": {"node": "b"}}}}})";
const char* const kLegs = R"({"graph": 1, "root": "all", "masks": {"upper": ["tip"]},
  "parameters": {"speed": {"kind": "number"}, "lean": {"kind": "number", "formula": "speed / 2"}},
  "variations": {"quiet": {"bend": "talk"}},
  "nodes": {"all": {"kind": "layers", "base": "walk",
                    "layers": [{"node": "over", "mask": "upper", "weight_by": "lean"}]},
            "walk": {"kind": "clip", "clip": "bend", "speed_by": "speed"},
            "over": {"kind": "clip", "clip": "bend"}}})";

/// Texts of graphs in files beside a model.
class graph_files : public testing::Test {
 protected:
  std::string write(const std::string& name, std::string text, const std::string& from = {},
                    const std::string& to = {}) {
    if (!from.empty()) {
      EXPECT_NE(text.find(from), text.npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    std::ofstream(model_.beside(name)) << text;
    return model_.beside(name);
  }
  CommandOutcome check(const std::string& graph, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"graph", "check", model_.path(), graph};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_tool(arguments);
  }
  Json first_frame(const std::string& graph, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"graph", "trace", model_.path(), graph, "--for", "0", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out)["frames"][0];
  }

  ToolModelFile model_;
};

TEST_F(graph_files, a_reference_plays_as_if_its_graph_stood_there) {
  const std::string legs = write("legs.json", kLegs), outer = write("outer.json", kOuter);
  const CommandOutcome sound = check(outer);
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("5 nodes, 2 clips, 1 machine"));
  EXPECT_THAT(sound.out, HasSubstr("with " + legs));
  EXPECT_THAT(sound.out, HasSubstr("\"go\", \"lean\" (computed), \"pace\""));
  const Json frame = first_frame(outer, {"--set", "pace=0.5"});
  ASSERT_EQ(frame["program"].size(), 3u);
  EXPECT_EQ(frame["program"][1]["weight"], 0.25) << "lean, computed from the outer graph's pace";
  EXPECT_EQ(frame["program"][1]["mask"], 0);
  // By hand, in one file.
  std::string flat = kOuter;
  const std::string reference = R"("legs": {"kind": "graph", "file": "legs.json", "parameters": {"speed": "pace"}},)";
  flat.replace(
      flat.find(reference), reference.size(),
      R"("legs": {"kind": "layers", "base": "walk", "layers": [{"node": "over", "mask": "upper", "weight_by": "lean"}]},
                  "walk": {"kind": "clip", "clip": "bend", "speed_by": "pace"}, "over": {"kind": "clip", "clip": "bend"},)");
  flat.replace(flat.find("\"parameters\": {"), 15,
               R"("masks": {"upper": ["tip"]}, "parameters": {"lean": {"kind": "number", "formula": "pace / 2"}, )");
  EXPECT_EQ(first_frame(write("flat.json", flat), {"--set", "pace=0.5"})["program"], frame["program"]);
}

TEST_F(graph_files, references_may_refer_on_and_be_used_twice) {
  write("legs.json", kLegs);
  write("middle.json", R"({"graph": 1, "root": "r", "parameters": {"speed": {"kind": "number"}},
    "nodes": {"r": {"kind": "graph", "file": "legs.json"}}})");
  const std::string outer = write("outer.json", kOuter, R"("b": {"kind": "clip", "clip": "talk"})",
                                  R"("b": {"kind": "graph", "file": "middle.json", "clips": {"bend": "talk"},
                                      "parameters": {"speed": "pace"}})");
  const CommandOutcome sound = check(outer);
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("7 nodes, 2 clips"));
  const CommandOutcome stored = run_tool({"compile", model_.path(), "-o", model_.beside("m.sinew"), "--graph", outer});
  EXPECT_EQ(stored.status, 0) << stored.err;
  write("legs.json", kLegs, "\"tip\"", "\"toe\"");
  EXPECT_THAT(check(outer).err, HasSubstr("legs.json: /masks/upper/0: the model has no joint \"toe\""));
}

TEST_F(graph_files, faults_are_named_in_the_file_that_has_them) {
  const auto fault = [&](const std::string& in_legs, const std::string& to) {
    write("legs.json", kLegs, in_legs, to);
    const CommandOutcome outcome = check(write("outer.json", kOuter));
    EXPECT_EQ(outcome.status, 1);
    return outcome.err;
  };
  EXPECT_THAT(fault("\"clip\": \"bend\", \"speed_by\"", "\"clip\": \"sing\", \"speed_by\""),
              HasSubstr("legs.json: /nodes/walk/clip: the model has no clip \"sing\""));
  EXPECT_THAT(fault("\"mask\": \"upper\"", "\"mask\": \"lower\""),
              HasSubstr("legs.json: /nodes/all/layers/0/mask: there is no mask"));
  EXPECT_THAT(fault("speed / 2", "speed /"), HasSubstr("legs.json: /parameters/lean/formula: at character 8"));
  EXPECT_THAT(fault("\"kind\": \"layers\"", "\"kind\": \"layer\""),
              HasSubstr("legs.json: /nodes/all/kind: is none of"));
  EXPECT_THAT(fault("\"root\": \"all\"", "\"root\": \"al\""),
              HasSubstr("outer.json: /nodes/legs/file: " + model_.beside("legs.json") + ": has no node \"al\""));
  EXPECT_THAT(fault("\"speed\": {\"kind\": \"number\"}", "\"speed\": {\"kind\": \"flag\"}"),
              HasSubstr("outer.json: /nodes/legs/file: " + model_.beside("legs.json") +
                        ": its parameter \"speed\" is of another kind than \"pace\" here"));
  write("legs.json", kLegs);
  const auto outer_fault = [&](const std::string& from, const std::string& to) {
    return check(write("outer.json", kOuter, from, to)).err;
  };
  EXPECT_THAT(outer_fault("legs.json", "arms.json"), HasSubstr("arms.json: is no file"));
  EXPECT_THAT(outer_fault("\"speed\": \"pace\"", "\"sped\": \"pace\""),
              HasSubstr("outer.json: /nodes/legs/parameters/sped: "));
  EXPECT_THAT(outer_fault("\"speed\": \"pace\"", "\"speed\": \"paces\""), HasSubstr("there is no parameter \"paces\""));
  EXPECT_THAT(outer_fault("\"file\": \"legs.json\"", "\"file\": \"legs.json\", \"clips\": {\"sing\": \"talk\"}"),
              HasSubstr("outer.json: /nodes/legs/clips/sing: "));
}

TEST_F(graph_files, graphs_that_refer_to_themselves_are_named) {
  const std::string a =
      write("a.json", R"({"graph": 1, "root": "r", "nodes": {"r": {"kind": "graph", "file": "b.json"}}})");
  write("b.json", R"({"graph": 1, "root": "r", "nodes": {"r": {"kind": "graph", "file": "./a.json"}}})");
  const CommandOutcome outcome = check(a);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("b.json: /nodes/r/file: graphs that refer to themselves: a.json refers to b.json "
                                     "refers to a.json"));
}

TEST_F(graph_files, a_variation_plays_other_clips_by_name) {
  write("legs.json", kLegs);
  const std::string outer = write("outer.json", kOuter);
  EXPECT_EQ(first_frame(outer, {})["program"][0]["index"], 0);
  EXPECT_EQ(first_frame(outer, {"--variation", "quiet"})["program"][0]["index"], 1);
  EXPECT_THAT(check(outer, {"--variation", "loud"}).err, HasSubstr("there is no variation \"loud\""));
  write("legs.json", kLegs, "{\"bend\": \"talk\"}", "{\"bend\": \"sing\"}");
  EXPECT_THAT(check(outer).err, HasSubstr("outer.json: /variations/quiet/bend: the model has no clip \"sing\""));
  write("legs.json", kLegs, "{\"bend\": \"talk\"}", "{\"bow\": \"talk\"}");
  EXPECT_THAT(check(outer).err, HasSubstr("/variations/quiet/bow: the graph plays no clip \"bow\""));
}

TEST_F(graph_files, computed_parameters_are_not_set) {
  write("legs.json", kLegs);
  const CommandOutcome outcome =
      run_tool({"graph", "trace", model_.path(), write("outer.json", kOuter), "--set", "lean=1"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--set lean: the graph computes this parameter"));
}

}  // namespace
}  // namespace sinew::test
