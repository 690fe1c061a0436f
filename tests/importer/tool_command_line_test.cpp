// SPDX-License-Identifier: MIT
// The command line from outside: exit status, stdout, stderr.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;

TEST(command_line, help_and_version_are_results) {
  const CommandOutcome help = run_tool({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"info", "sample", "verify", "check", "plan", "convert", "compile"}) {
    EXPECT_THAT(help.out, HasSubstr(std::string("\n  ") + command + "  "));
  }
  const CommandOutcome version = run_tool({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, MatchesRegex("sinew [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_EQ(run_tool({"sample", "--help"}).status, 0);
}

TEST(command_line, wrong_usage_names_what_is_wrong_and_the_help_that_has_it_right) {
  using testing::HasSubstr;
  EXPECT_THAT(run_tool({"infoo", "x.glb"}).err, HasSubstr("there is no command infoo (see `sinew --help`)"));
  EXPECT_THAT(run_tool({"--infoo"}).err, HasSubstr("there is no option --infoo (see `sinew --help`)"));
  EXPECT_THAT(run_tool({"convert", "x.glb"}).err, HasSubstr("OUT is required (see `sinew convert --help`)"));
  EXPECT_THAT(run_tool({"info", "x.glb", "--foo"}).err,
              AllOf(HasSubstr("--foo"), HasSubstr("(see `sinew info --help`)")));
  EXPECT_THAT(run_tool({}).err, HasSubstr("A subcommand is required (see `sinew --help`)"));
}

TEST(command_line, wrong_usage_is_2_with_a_message_and_no_result) {
  const ToolModelFile model;
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"paint"},
      {"info"},
      {"info", model.path(), "--colour"},
      {"sample", model.path(), "--clip", "jump"},
      {"sample", model.path(), "--clip", "2"},
      {"sample", model.path(), "--times", "soon"},
      {"sample", model.path(), "--fps", "0"},
      {"sample", model.path(), "--fps", "1e9"},
      {"sample", model.path(), "--fps", "30", "--times", "1"},
      {"sample", model.path(), "--skinning", "spherical"},
      {"plan", model.path(), "--skinning", "all"},
      {"sample", model.path(), "--vertices", "many"},
      {"sample", model.path(), "-o", "/no such folder/out.json"},
      {"verify", model.path()},
      {"verify", model.path(), model.path(), "--tolerance", "-1"},
      {"plan", model.path(), "--needs", "joints,smell"},
      {"plan", model.path(), "--layers", "0"},
      {"plan", model.path(), "--skinning", "linear,linear,linear"},
      {"plan", model.path(), "--normals", "flat"},
      {"plan", model.path(), "--joint-tolerance", "-1mm"},
  };
  for (const auto& arguments : wrong) {
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.err, testing::StartsWith("sinew: ")) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.out, IsEmpty()) << testing::PrintToString(arguments);
  }
}

TEST(command_line, a_file_at_fault_is_1_and_named_on_stderr) {
  const ToolModelFile model;
  const std::string broken = model.beside("broken.gltf");
  std::ofstream(broken) << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}]})";
  for (const char* command : {"info", "sample", "plan"}) {
    const CommandOutcome outcome = run_tool({command, broken});
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_THAT(outcome.err, HasSubstr("sinew: " + broken + ": /nodes/0/mesh: ")) << command;
    EXPECT_THAT(outcome.out, IsEmpty()) << command;
    EXPECT_EQ(run_tool({command, model.beside("missing.glb")}).status, 1) << command;
  }
}

TEST(command_line, check_lists_broken_rules_on_stdout) {
  const ToolModelFile model;
  EXPECT_EQ(run_tool({"check", model.path()}).status, 0);
  const std::string broken = model.beside("broken.gltf");
  std::ofstream(broken) << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}]})";
  EXPECT_THAT(run_tool({"check", broken}).out, HasSubstr(broken + ": /nodes/0/mesh: "));
  const CommandOutcome outcome = run_tool({"check", broken, "--json"});
  EXPECT_EQ(outcome.status, 1);
  const json report = json::parse(outcome.out);
  EXPECT_GE(report["errors"], 1);
  EXPECT_EQ(report["issues"][0]["severity"], "error");
  EXPECT_EQ(report["issues"][0]["pointer"], "/nodes/0/mesh");
  EXPECT_FALSE(report["issues"][0]["rule"].get<std::string>().empty());
}

TEST(command_line, info_tells_what_is_inside) {
  const ToolModelFile model;
  const CommandOutcome outcome = run_tool({"info", model.path(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json info = json::parse(outcome.out);
  EXPECT_EQ(info["nodes"]["count"], 4);
  EXPECT_EQ(info["nodes"]["depth"], 2);
  EXPECT_EQ(info["generator"], "sinew tests");
  EXPECT_EQ(info["meshes"][0]["vertices"], 4);
  EXPECT_EQ(info["skins"][0]["vertices_by_influences"], (json{{"1", 3}, {"2", 1}}));
  EXPECT_EQ(info["skins"][0]["joints_with_weight"], 2);
  EXPECT_EQ(info["meshes"][1]["triangles"], 1);
  EXPECT_EQ(info["meshes"][1]["morph_targets"].size(), 2u);
  EXPECT_EQ(info["meshes"][1]["morph_targets"][1]["non_zero_deltas"], 1);
  EXPECT_EQ(info["skins"][0]["joints"], 2);
  EXPECT_EQ(info["clips"][0]["name"], "bend");
  EXPECT_EQ(info["clips"][0]["duration_s"], 1.0);
  EXPECT_EQ(info["clips"][0]["channels_by_property"], (json{{"rotation", 1}}));
  EXPECT_EQ(info["clips"][0]["bytes_of_keys"], 2 * 4 + 2 * 16);
  EXPECT_EQ(info["clips"][0]["most_keys_of_a_channel"], 2);
  EXPECT_EQ(info["clips"][1]["keys"], 2);
  EXPECT_EQ(info["clips"][1]["modes"], (json{{"linear", 1}}));
  const CommandOutcome text = run_tool({"info", model.path()});
  EXPECT_EQ(text.status, 0);
  for (const char* words :
       {"nodes: 4", "\"bend\"", "1: 3, 2: 1", "morph targets of mesh 1: 2", "skins: 1", "warnings: 0"})
    EXPECT_THAT(text.out, HasSubstr(words));
}

TEST(command_line, sample_writes_to_stdout_or_a_file_what_was_asked_for) {
  const ToolModelFile model;
  const CommandOutcome outcome =
      run_tool({"sample", model.path(), "--clip", "bend", "--times", "0,1", "--vertices", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json poses = json::parse(outcome.out);
  ASSERT_EQ(poses["clips"].size(), 1u);
  EXPECT_EQ(poses["clips"][0]["index"], 0);
  ASSERT_EQ(poses["clips"][0]["samples"].size(), 2u);
  EXPECT_EQ(poses["clips"][0]["samples"][0]["skinned"][0]["vertices"], (json{0, 3}));
  const std::string file = model.beside("poses.json");
  EXPECT_EQ(run_tool({"sample", model.path(), "-o", file, "--fps", "2"}).status, 0);
  const json all = json::parse(std::ifstream(file));
  ASSERT_EQ(all["clips"].size(), 3u);
  EXPECT_TRUE(all["clips"][0]["clip"].is_null());
  EXPECT_EQ(all["clips"][2]["samples"].size(), 5u);
}

TEST(command_line, verify_holds_for_what_sample_wrote_and_falls_when_the_file_changes) {
  const ToolModelFile model;
  for (const char* golden : {"golden.json", "golden.json.gz"}) {
    const std::string file = model.beside(golden);
    ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "all", "-o", file}).status, 0);
    EXPECT_EQ(run_tool({"verify", model.path(), file}).status, 0);
    EXPECT_EQ(run_tool({"verify", model.path(), file, "--tolerance", "0"}).status, 0);
  }
  std::string text = tool_model();
  text.replace(text.find("\"scale\": [1, 2, 1]"), 18, "\"scale\": [1, 3, 1]");
  std::ofstream(model.path(), std::ios::binary) << text;
  const CommandOutcome outcome = run_tool({"verify", model.path(), model.beside("golden.json")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out,
              HasSubstr("clip 1 \"talk\", 2 s, node 3 \"face\", primitive 0, vertex 2, positions: off by 3 m"));
  EXPECT_THAT(outcome.err, HasSubstr("poses differ"));
  EXPECT_EQ(run_tool({"verify", model.path(), model.beside("golden.json"), "--tolerance", "10"}).status, 0);
}

TEST(command_line, verify_finds_poses_in_a_folder_also_where_they_are_compressed) {
  const ToolModelFile model;
  const std::string folder = model.beside("poses");
  std::filesystem::create_directory(folder);
  EXPECT_EQ(run_tool({"verify", model.path(), folder}).status, 4) << "there are none";
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", folder + "/model.json.gz"}).status, 0);
  const CommandOutcome outcome = run_tool({"verify", model.path(), folder});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("compared with " + folder + "/model.json.gz"));
}

TEST(command_line, verify_exact_compares_the_bits_of_everything_and_tells_which_kind_differs) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "1", "--skinning", "all", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact"}).status, 0);
  json poses = json::parse(std::ifstream(golden));
  json& bits = poses["clips"][1]["samples"][0]["bits"];
  for (const char* kind : {"pose", "linear", "dualQuaternion", "centerOfRotation"}) {
    ASSERT_EQ(bits[kind].get<std::string>().size(), 16u) << kind;
    const std::string kept = bits[kind];
    bits[kind] = "0123456789abcdef";
    std::ofstream(golden) << poses;
    EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0) << "within the tolerance nothing moved";
    const CommandOutcome outcome = run_tool({"verify", model.path(), golden, "--exact"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr(std::string("clip 0 \"bend\", 0 s, ") + kind + ": not the same bits"));
    bits[kind] = kept;
  }
}

TEST(command_line, verify_exact_sees_vertices_that_the_file_does_not_list) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "1", "--clip", "1", "-o", golden}).status, 0);
  std::string text = tool_model();
  const auto at = text.find("\"scale\": [1, 2, 1]");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 18, "\"scale\": [1, 2.0000002, 1]");  // one ulp: within every tolerance
  std::ofstream(model.path(), std::ios::binary) << text;
  EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact"}).status, 1);
}

TEST(command_line, verify_exact_needs_a_golden_file_with_bits) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  json poses = json::parse(std::ifstream(golden));
  for (json& clip : poses["clips"])
    for (json& sample : clip["samples"]) sample.erase("bits");
  std::ofstream(golden) << poses;
  EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0);
  const CommandOutcome outcome = run_tool({"verify", model.path(), golden, "--exact"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("holds no bits"));
}

TEST(command_line, sample_fills_the_keys_of_the_kind_of_skinning_that_is_asked_for) {
  const ToolModelFile model;
  const auto strip = [&](const char* kind) {
    const CommandOutcome outcome =
        run_tool({"sample", model.path(), "--clip", "0", "--times", "1", "--skinning", kind});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out)["clips"][0]["samples"][0]["skinned"][0];
  };
  const json centers = strip("center-of-rotation"), all = strip("all");
  EXPECT_FALSE(centers.contains("positions") || centers.contains("dqs"));
  ASSERT_EQ(centers["cors"].size(), 4u);
  ASSERT_EQ(centers["corNormals"].size(), 4u);
  for (const char* key : {"positions", "normals", "dqs", "dqsNormals", "cors", "corNormals"})
    EXPECT_TRUE(all.contains(key)) << key;
  EXPECT_EQ(all["cors"], centers["cors"]);
  EXPECT_FALSE(strip("linear").contains("cors") || strip("dual-quaternion").contains("cors"));
}

TEST(command_line, N21_verify_compares_positions_about_centers_of_rotation) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json"), moved = model.beside("moved.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--skinning", "center-of-rotation", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--tolerance", "0"}).status, 0);
  json poses = json::parse(std::ifstream(golden));
  json& cor = poses["clips"][1]["samples"][0]["skinned"][0]["cors"][2][1];
  cor = cor.get<double>() + 0.25;
  std::ofstream(moved) << poses;
  const CommandOutcome outcome = run_tool({"verify", model.path(), moved});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("vertex 2, cors: off by 0.25 m"));
}

TEST(command_line, verify_refuses_a_golden_file_that_is_none) {
  const ToolModelFile model;
  const std::string empty = model.beside("empty.json");
  std::ofstream(empty) << R"({"clips": []})";
  for (const std::string& golden : {empty, model.path(), model.beside("missing.json")}) {
    const CommandOutcome outcome = run_tool({"verify", model.path(), golden});
    EXPECT_EQ(outcome.status, 4) << golden;
    EXPECT_THAT(outcome.err, HasSubstr("sinew: " + golden)) << golden;
  }
}

TEST(command_line, verify_tells_a_model_that_cannot_be_read_from_one_that_moved) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", model.beside("missing.glb"), golden}).status, 4);
  std::ofstream(model.beside("broken.gltf")) << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}]})";
  EXPECT_EQ(run_tool({"verify", model.beside("broken.gltf"), golden}).status, 4);
}

TEST(command_line, plan_names_each_stage_with_its_reason) {
  const ToolModelFile model;
  const json plan = json::parse(run_tool({"plan", model.path(), "--clip", "0", "--json"}).out);
  const auto stage = [](const json& report, const std::string& name) {
    for (const json& entry : report["stages"])
      if (entry["stage"] == name) return entry;
    return json();
  };
  ASSERT_TRUE(stage(plan, "skin_linear").is_object());
  EXPECT_EQ(stage(plan, "skin_linear")["runs"], true);
  EXPECT_EQ(stage(plan, "skin_linear")["count"], 4);
  for (const json& entry : plan["stages"]) {
    EXPECT_FALSE(entry["reason"].get<std::string>().empty()) << entry["stage"];
    EXPECT_TRUE(entry["count"].is_number_unsigned() && entry["bytes"].is_number_unsigned());
  }
  EXPECT_EQ(plan["work"]["vertices_skinned_linear"], 4);
  EXPECT_EQ(plan["work"]["vertices_skinned_dual_quaternion"], 0);
  EXPECT_EQ(stage(plan, "skin_center_of_rotation")["runs"], false);
  const json centers =
      json::parse(run_tool({"plan", model.path(), "--skinning", "center-of-rotation", "--clip", "0", "--json"}).out);
  EXPECT_EQ(stage(centers, "skin_center_of_rotation")["runs"], true);
  EXPECT_EQ(stage(centers, "split_palette")["runs"], true);
  EXPECT_EQ(centers["work"]["vertices_skinned_center_of_rotation"], 4);
  EXPECT_EQ(centers["work"]["vertices_skinned_linear"], 0);
  const json joints = json::parse(run_tool({"plan", model.path(), "--needs", "joints", "--clip", "0", "--json"}).out);
  EXPECT_EQ(stage(joints, "skin_linear")["runs"], false);
  EXPECT_EQ(joints["work"]["vertices_skinned_linear"], 0);
  EXPECT_THAT(run_tool({"plan", model.path()}).out, HasSubstr("left out"));
}

TEST(command_line, plan_takes_everything_that_a_consumer_can_ask_for) {
  const ToolModelFile model;
  const auto plan = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plan", model.path(), "--json"});
    return json::parse(run_tool(arguments).out);
  };
  const auto runs = [&](const std::string& stage, const std::vector<std::string>& arguments) {
    const json report = plan(arguments);
    for (const json& entry : report["stages"])
      if (entry["stage"] == stage) return entry["runs"].get<bool>();
    ADD_FAILURE() << stage;
    return false;
  };
  EXPECT_FALSE(runs("palette", {"--needs", "joints"}));
  EXPECT_TRUE(runs("palette", {"--needs", "joints,palettes"}));
  EXPECT_TRUE(runs("bounds", {"--needs", "bounds"}));
  EXPECT_FALSE(runs("add", {}));
  EXPECT_TRUE(runs("add", {"--needs", "joints,additive"}));
  EXPECT_TRUE(runs("blend", {}));
  EXPECT_FALSE(runs("blend", {"--layers", "1"}));
  EXPECT_TRUE(runs("blend", {"--layers", "1", "--needs", "joints,masks"}));
  EXPECT_TRUE(runs("skin_dual_quaternion", {"--skinning", "dual-quaternion,linear"}));
  EXPECT_FALSE(runs("skin_dual_quaternion", {"--skinning", "linear,dual-quaternion"})) << "the second mesh has no skin";
  EXPECT_GT(plan({"--needs", "joints,stage-times"})["frame_bytes"], plan({"--needs", "joints"})["frame_bytes"]);
  EXPECT_THAT(plan({"--normals", "cofactor"}).dump(), HasSubstr("normals of 1 primitive by cofactors"))
      << "uneven scale reaches a joint";
  EXPECT_THAT(plan({}).dump(), testing::Not(HasSubstr("cofactor")));
}

}  // namespace
}  // namespace sinew::test
