// SPDX-License-Identifier: MIT
#include "importer/graph/graph_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/graph/graph_builder.h"
#include "runtime/graph/update_graph.h"

namespace sinew {
namespace {

using testing::HasSubstr;

/// A graph with every kind of node.
const char* const kText = R"({
  "graph": 1,
  "root": "all",
  "parameters": {"jump": {"kind": "trigger"}, "speed": {"kind": "number", "initial": 0.1}},
  "masks": {"arms": ["Arm.L", "Arm.R"]},
  "editor": {"zoom": 3},
  "nodes": {
    "all": {"kind": "layers", "base": "body", "layers": [{"node": "wave", "weight_by": "speed", "mask": "arms"}]},
    "wave": {"kind": "clip", "clip": "Wave", "speed": 0.5},
    "body": {"kind": "machine", "initial": "ground", "states": {
      "ground": {"node": "gaits", "transitions": [
        {"to": "air", "when": [{"kind": "trigger", "parameter": "jump"}], "duration_s": 0.1}]},
      "air": {"node": "choice", "transitions": [{"to": "ground", "when": [{"kind": "played", "value": 1}]}]}}},
    "gaits": {"kind": "blend_space", "x": "speed", "points": [{"x": 0, "node": "idle"}, {"x": 1.5, "node": "walk"}]},
    "idle": {"kind": "clip", "clip": "Idle"},
    "walk": {"kind": "clip", "clip": "Walk", "mirror": true},
    "choice": {"kind": "select", "by": "speed", "children": ["leap", "ragdoll"]},
    "leap": {"kind": "clip", "clip": "Jump", "loop": false},
    "ragdoll": {"kind": "external", "pose": 1}
  }
})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// "POINTER: sentence" of the first fault.
std::string fault_of(const std::string& text) {
  const auto document = read_graph(text);
  if (!document) return document.error().json_pointer + ": " + document.error().sentence;
  const auto graph = compile_graph(*document);
  return graph ? "none" : graph.error().json_pointer + ": " + graph.error().sentence;
}

TEST(graph_text, faults_have_a_place_and_a_sentence) {
  const std::vector<std::tuple<const char*, const char*, const char*>> cases = {
      {R"("speed": 0.5)", R"("sped": 0.5)", "/nodes/wave/sped: is not a known key here"},
      {R"("graph": 1)", R"("graph": 2)", "/graph: is a version that is not known"},
      {R"("kind": "trigger"})", R"("kind": "button"})", "/parameters/jump/kind: is none of number, flag, trigger"},
      {R"("root": "all")", R"("root": "al")", "/root: there is no node \"al\""},
      {R"("root": "all",)", "", ": has no \"root\""},
      {R"("weight_by": "speed")", R"("weight_by": "sped")",
       "/nodes/all/layers/0/weight_by: there is no parameter \"sped\""},
      {R"("mask": "arms")", R"("mask": "legs")", "/nodes/all/layers/0/mask: there is no mask \"legs\""},
      {R"("to": "air")", R"("to": "water")", "/nodes/body/states/ground/transitions/0/to: there is no state \"water\""},
      {R"("to": "air")", R"("to": "ground")", "/nodes/body/states/air: no transition leads to it"},
      {R"("parameter": "jump")", R"("parameter": "speed")",
       "/nodes/body/states/ground/transitions/0/when/0: its parameter is no trigger"},
      {R"("duration_s": 0.1)", R"("duration_s": -1)",
       "/nodes/body/states/ground/transitions/0: it does not last 0 to 3600 s"},
      {R"("x": 1.5)", R"("x": -1)", "/nodes/gaits/points/1: points of a line do not rise"},
      {R"("children": ["leap", "ragdoll"])", R"("children": ["leap", "leap"])",
       "/nodes/choice/children/1: its node is used elsewhere, too"},
      {R"(["leap", "ragdoll"])", R"(["leap", "body"])", "/nodes/choice/children/1: its node is used elsewhere, too"},
      {R"("base": "body")", R"("base": "idle")", "/nodes/gaits/points/0: its node is used elsewhere, too"},
      {R"("pose": 1)", R"("pose": -1)", "/nodes/ragdoll/pose: is no index of a pose"},
      {R"("pose": 1)", R"("pose": 1e99)", "/nodes/ragdoll/pose: is no whole number of a sensible size"},
      {R"("initial": 0.1)", R"("initial": "fast")", "/parameters/speed/initial: is no number"},
      {R"("clip": "Wave")", R"("clip": 3)", "/nodes/wave/clip: is no text"},
      {R"("played", "value": 1)", R"("played", "parameter": "speed")",
       "/nodes/body/states/air/transitions/0/when/0/parameter: is not used by a condition of time"},
  };
  EXPECT_EQ(fault_of(kText), "none");
  for (const auto& [from, to, fault] : cases) EXPECT_EQ(fault_of(replaced(kText, from, to)), fault);
  EXPECT_EQ(fault_of("[]"), ": is no JSON object");
  EXPECT_EQ(fault_of("{"), ": is no JSON object");
  EXPECT_EQ(fault_of(std::string(100'000, '[')), ": is nested more than 64 deep");
}

TEST(graph_text, masks_within_masks_stand_in_their_place) {
  const auto with_masks = [](const std::string& masks) {
    return replaced(kText, R"({"arms": ["Arm.L", "Arm.R"]})", masks);
  };
  const auto document = read_graph(with_masks(R"({"arms": ["L", {"joint": "R", "weight": 0.5, "below": false}],
    "top": ["Spine", {"mask": "arms", "weight": 0.5}, {"mask": "arms"}, "Head"]})"));
  ASSERT_TRUE(document);
  const auto graph = compile_graph(*document);
  ASSERT_TRUE(graph) << graph.error().sentence;
  const GraphTables& t = graph->tables();
  std::string found;
  for (std::size_t j = 0; j < t.masks[1].joint_count; ++j) {
    const GraphMaskJoint& joint = t.mask_joints[t.masks[1].first_joint + j];
    found += std::string(t.name_at(joint.name)) + (joint.below ? "*" : "") + std::to_string(joint.weight).substr(0, 4);
  }
  EXPECT_EQ(found, "Spine*1.00L*0.50R0.25L*1.00R0.50Head*1.00");
  EXPECT_EQ(write_graph(*read_graph(write_graph(*document))), write_graph(*document));
  EXPECT_EQ(fault_of(with_masks(R"({"arms": ["A", {}]})")), "/masks/arms/1: names either a joint or a mask");
  EXPECT_EQ(fault_of(with_masks(R"({"arms": [{"mask": "legs"}]})")), "/masks/arms/0/mask: there is no mask \"legs\"");
  EXPECT_EQ(fault_of(with_masks(R"({"arms": [{"mask": "b"}], "b": ["x", {"mask": "arms"}]})")),
            "/masks/b/1/mask: the mask lies within itself");
  EXPECT_EQ(fault_of(with_masks(R"({"arms": [{"mask": "b", "weight": 2}], "b": []})")),
            "/masks/arms/0/weight: lies in [0, 1]");
  std::string doubling = R"({"arms": [{"mask": "n0"}, {"mask": "n0"}])", chain = R"({"arms": [{"mask": "n0"}])";
  for (int n = 0; n < 20; ++n) {
    const std::string next = R"({"mask": "n)" + std::to_string(n + 1) + "\"}",
                      key = ", \"n" + std::to_string(n) + "\": [";
    chain += key + next + "]";
    if (n < 14) doubling += key + next + "," + next + "," + next + "]";
  }
  EXPECT_THAT(fault_of(with_masks(doubling + R"(, "n14": []})")), HasSubstr("more than 65534 entries of masks"));
  EXPECT_THAT(fault_of(with_masks(chain + R"(, "n20": []})")), HasSubstr("it lies more than 16 deep"));
}

TEST(graph_text, a_machine_below_itself_is_a_cycle) {
  std::string text = replaced(kText, R"("base": "body")", R"("base": "spare")");
  text = replaced(text, R"("ragdoll": {"kind")", R"("spare": {"kind": "clip", "clip": "Idle"}, "ragdoll": {"kind")");
  text = replaced(text, R"(["leap", "ragdoll"])", R"(["leap", "ragdoll", "body"])");
  EXPECT_EQ(fault_of(text), "/nodes/body: it lies on a cycle");
}

TEST(graph_text, what_is_written_reads_as_the_same_text) {
  const auto document = read_graph(kText);
  ASSERT_TRUE(document);
  const std::string text = write_graph(*document);
  const auto again = read_graph(text);
  ASSERT_TRUE(again) << again.error().json_pointer << again.error().sentence;
  EXPECT_EQ(write_graph(*again), text);
  EXPECT_THAT(text, HasSubstr("\"initial\": 0.1\n")) << "not 0.10000000149";
  EXPECT_THAT(text, testing::Not(HasSubstr("\"loop\": true"))) << "defaults are left out";
}

TEST(graph_text, plays_like_the_graph_of_a_builder) {
  const auto graph = compile_graph(*read_graph(R"({"graph": 1, "root": "m", "parameters": {"speed": {"kind": "number"}},
    "nodes": {"a": {"kind": "clip", "clip": "A"}, "b": {"kind": "clip", "clip": "B"},
      "m": {"kind": "machine", "initial": "one", "states": {
        "one": {"node": "a", "transitions": [{"to": "two", "when": [{"kind": "above", "parameter": "speed"}]}]},
        "two": {"node": "b"}}}}})"));
  ASSERT_TRUE(graph);
  GraphBuilder b;
  const GraphIndex speed = b.number("speed");
  const GraphIndex m = b.machine("m");
  const GraphIndex one = b.state(m, "one", b.clip("A")), two = b.state(m, "two", b.clip("B"));
  b.transition(m, one, {.to = two}, {when_above(speed, 0.0f)});
  const GraphDefinition built = *b.build(m);
  const GraphClipSet clips = *GraphClipSet::make(std::vector<GraphClip>{{0, 1.0}, {1, 1.0}});
  const float values[] = {1.0f};
  std::vector<PoseOp> programs[2];
  for (const GraphDefinition* g : {&*graph, &built}) {
    std::vector<std::uint64_t> state(g->state_bytes() / 8 + 1);
    const auto bytes = std::as_writable_bytes(std::span(state));
    PoseProgram program;
    GraphStep step;
    ASSERT_EQ(run(StartGraphJob{g, &clips, values, bytes}), ErrorCode::ok);
    ASSERT_EQ(run(UpdateGraphJob{g, &clips, values, bytes, 0.1, &program, {}, &step}), ErrorCode::ok);
    programs[g == &built].assign(program.ops().begin(), program.ops().end());
  }
  EXPECT_EQ(programs[0].size(), 3u);
  EXPECT_EQ(programs[0], programs[1]);
}

TEST(graph_text, a_new_graph_has_the_gaits_that_clips_are_called_after) {
  const auto document = new_graph({"Walking_Backwards", "Walking_A", "Idle", "Running_A", "Jump_Full_Long", "Wave"});
  ASSERT_TRUE(document);
  const auto& points = document->nodes.at("gaits").points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(document->nodes.at("walk").clip, "Walking_A");
  EXPECT_TRUE(compile_graph(*document));
  EXPECT_EQ(fault_of(write_graph(*document)), "none");
  EXPECT_FALSE(new_graph({"Wave"}));
}

TEST(graph_text, the_documentation_lists_every_member) {
  std::ifstream file(SINEW_SOURCE_DIR "/importer/graph/README.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(describe_graph_format())) << "write it anew";
}

}  // namespace
}  // namespace sinew
