// SPDX-License-Identifier: MIT
// `sinew convert` from outside, and an independent validator on the files that it writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "samples/showcase/showcase.h"
#include "tests/importer/gltf_validator.h"
#include "tests/importer/tool_model.h"
#include "tests/support/corpus.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::size_t files_beside(const ToolModelFile& model) {
  const fs::path folder = fs::path(model.path()).parent_path();
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(convert, writes_one_file_that_samples_the_same_poses) {
  const ToolModelFile model;
  const std::string out = model.beside("out.glb"), golden = model.beside("golden.json");
  const CommandOutcome outcome = run_tool({"convert", model.path(), out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(std::to_string(fs::file_size(out)) + " bytes"));
  ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "all", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, golden, "--tolerance", "0"}).status, 0);
  EXPECT_EQ(files_beside(model), 3u) << "no temporary file is left";
}

TEST(convert, replaces_an_older_file_and_what_a_link_points_at) {
  const ToolModelFile model;
  const fs::path out = model.beside("out.glb"), link = model.beside("link.glb");
  std::ofstream(out) << "old";
  fs::create_symlink(out, link);
  ASSERT_EQ(run_tool({"convert", model.path(), link.string()}).status, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(import_gltf(out));
}

TEST(convert, never_overwrites_its_input_by_any_name) {
  const ToolModelFile model;
  const std::string glb = model.beside("in.glb"), link = model.beside("link.glb");
  ASSERT_EQ(run_tool({"convert", model.path(), glb}).status, 0);
  const std::string before = text_of_file(glb);
  fs::create_symlink(glb, link);
  for (const std::string& out : {glb, link, model.beside("./in.glb")}) {
    const CommandOutcome outcome = run_tool({"convert", glb, out});
    EXPECT_EQ(outcome.status, 2) << out;
    EXPECT_THAT(outcome.err, HasSubstr(out)) << out;
  }
  EXPECT_EQ(text_of_file(glb), before);
}

TEST(convert, tells_usage_from_a_file_at_fault_and_leaves_the_old_output) {
  const ToolModelFile model;
  const std::string out = model.beside("out.glb"), broken = model.beside("broken.gltf");
  std::ofstream(out) << "old";
  std::ofstream(broken) << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}]})";
  EXPECT_EQ(run_tool({"convert", broken, out}).status, 1);
  EXPECT_EQ(run_tool({"convert", model.beside("missing.glb"), out}).status, 1);
  EXPECT_EQ(run_tool({"convert", model.path(), model.beside("out.obj")}).status, 2);
  EXPECT_EQ(run_tool({"convert", model.path(), "/no such folder/out.glb"}).status, 2);
  EXPECT_EQ(run_tool({"convert", model.path()}).status, 2);
  EXPECT_EQ(text_of_file(out), "old");
}

TEST(convert, writes_text_with_its_buffer_beside_it) {
  const ToolModelFile model;
  const std::string out = model.beside("out.gltf"), golden = model.beside("golden.json");
  const CommandOutcome outcome = run_tool({"convert", model.path(), out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(std::to_string(fs::file_size(out) + fs::file_size(model.beside("out.bin")))));
  EXPECT_THAT(outcome.out, HasSubstr(std::to_string(fs::file_size(model.path())) + " before"));
  EXPECT_EQ(nlohmann::json::parse(text_of_file(out))["buffers"][0]["uri"], "out.bin");
  ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "all", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, golden, "--tolerance", "0"}).status, 0);
  EXPECT_EQ(files_beside(model), 4u) << "no temporary file is left";
}

TEST(convert, never_overwrites_a_buffer_that_it_reads) {
  const ToolModelFile model;
  const std::string pair = model.beside("pair.gltf");
  ASSERT_EQ(run_tool({"convert", model.path(), pair}).status, 0);
  const std::string before = text_of_file(model.beside("pair.bin"));
  fs::create_symlink(model.beside("pair.bin"), model.beside("other.bin"));
  const CommandOutcome outcome = run_tool({"convert", pair, model.beside("other.gltf")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("other.bin is read; it is left as it is"));
  EXPECT_EQ(text_of_file(model.beside("pair.bin")), before);
  EXPECT_FALSE(fs::exists(model.beside("other.gltf")));
}

TEST(convert, lists_what_cannot_be_carried_and_writes_nothing_unless_it_may_be_dropped) {
  const ToolModelFile model;
  const std::string in = model.beside("in.gltf"), out = model.beside("out.glb");
  std::ofstream(in) << R"({"asset": {"version": "2.0"}, "images": [{"uri": "a.png"}, {"uri": "b.png"}]})";
  const CommandOutcome refused = run_tool({"convert", in, out});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("/images/0: not-carried: image-missing"));
  EXPECT_THAT(refused.err, HasSubstr("/images/1: not-carried: image-missing"));
  EXPECT_THAT(refused.err, HasSubstr("2 things cannot be carried"));
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(run_tool({"convert", in, out, "--drop", "json-duplicate"}).status, 1);
  const CommandOutcome written = run_tool({"convert", in, out, "--drop", "json-duplicate,image-missing"});
  EXPECT_EQ(written.status, 0);
  EXPECT_THAT(written.err, HasSubstr("warning: image-missing"));
  EXPECT_TRUE(fs::exists(out));
}

TEST(convert, G23_resamples_clips_on_request_and_measures_what_that_moved) {
  const ToolModelFile model;
  const std::string out = model.beside("out.glb"), golden = model.beside("golden.json");
  const CommandOutcome outcome = run_tool({"convert", model.path(), out, "--fps", "10"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("measured"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("NO"))) << "no budget was asked for";
  const auto before = import_gltf(fs::path(model.path())), after = import_gltf(fs::path(out));
  ASSERT_TRUE(before && after);
  for (std::size_t a = 0; a < before->scene.animations.size(); ++a)
    EXPECT_EQ(before->scene.animations[a].duration_s, after->scene.animations[a].duration_s);
  EXPECT_EQ(after->scene.animations[0].bones[0].rotation.times_s.size(), 11u);
  ASSERT_EQ(run_tool({"sample", model.path(), "--vertices", "all", "-o", golden}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, golden, "--tolerance", "1e-5"}).status, 0);
  EXPECT_EQ(run_tool({"convert", model.path(), out, "--fps", "10", "--budget", "1mm"}).status, 2);
  EXPECT_EQ(run_tool({"convert", model.path(), out, "--fps", "0"}).status, 2);
}

TEST(convert, says_why_the_output_cannot_be_written) {
  const ToolModelFile model;
  const std::string folder = model.beside("folder.glb"), endless = model.beside(std::string(252, 'n') + ".glb");
  fs::create_directory(folder);
  const CommandOutcome taken = run_tool({"convert", model.path(), folder});
  EXPECT_EQ(taken.status, 2);
  EXPECT_THAT(taken.err, HasSubstr(folder + " exists and is not a regular file"));
  const CommandOutcome failed = run_tool({"convert", model.path(), endless});
  EXPECT_EQ(failed.status, 3);
  EXPECT_THAT(failed.err, HasSubstr(endless + ": write-file: "));
}

TEST(convert, an_independent_validator_finds_no_error_in_the_samples_as_they_are_written) {
  const ToolModelFile folder;
  std::vector<std::string> files;
  for (const auto& sample : showcase::showcase()) {
    const std::string in = folder.beside("in" + std::to_string(files.size()) + ".glb"),
                      out = folder.beside("out" + std::to_string(files.size()) + ".glb");
    ASSERT_TRUE(export_glb(sample.scene, fs::path(in)));
    ASSERT_EQ(run_tool({"convert", in, out}).status, 0);
    files.push_back(out);
  }
  ASSERT_EQ(run_tool({"convert", folder.path(), folder.beside("model.glb")}).status, 0);
  files.push_back(folder.beside("model.glb"));
  const auto errors = issues_by_validator(folder, files, 0);
  if (!errors) GTEST_SKIP() << kNoValidator;
  for (const std::string& file : files) EXPECT_TRUE(errors->at(file).empty()) << file << ": " << errors->at(file);
}

bool has_code(const nlohmann::json& errors, const nlohmann::json& code) {
  return std::any_of(errors.begin(), errors.end(), [&](const auto& error) { return error[0] == code; });
}

/// Errors of the model itself (such as joints without a common root) remain after conversion.
void expect_no_new_errors(const std::vector<std::string>& how, const char* extension) {
  const ToolModelFile folder;
  std::vector<std::string> files;
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const char* models : {"models", "vrm", "retarget"})
    for (const fs::path& file : files_for_tests(models, {".gltf", ".glb", ".vrm", ".vrma"})) {
      const std::string out = folder.beside(std::to_string(pairs.size()) + extension);
      if (run_tool({"check", file.string()}).status != 0) continue;
      std::vector<std::string> command{"convert", file.string(), out, "--drop", "image-missing"};
      command.insert(command.end(), how.begin(), how.end());
      const CommandOutcome outcome = run_tool(command);
      ASSERT_EQ(outcome.status, 0) << file << outcome.err;
      files.insert(files.end(), {file.string(), out});
      pairs.emplace_back(file.string(), out);
    }
  ASSERT_FALSE(pairs.empty());
  const auto errors = issues_by_validator(folder, files, 0);
  if (!errors) GTEST_SKIP() << kNoValidator;
  for (const auto& [in, out] : pairs)
    for (const auto& error : errors->at(out)) EXPECT_TRUE(has_code(errors->at(in), error[0])) << in << ": " << error;
}

TEST(convert_corpus, an_independent_validator_finds_no_new_error_in_what_is_written) {
  expect_no_new_errors({}, ".glb");
  expect_no_new_errors({}, ".gltf");
}

TEST(convert_corpus, an_independent_validator_finds_no_new_error_in_clips_of_fewer_keys) {
  expect_no_new_errors({"--budget", "1mm"}, ".glb");
}

/// Two arms on a body, of which the left one turns; its channels name nodes by index and by pointer.
constexpr const char* kOneArm = R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_animation_pointer"],
  "nodes": [{"name": "body", "children": [1, 2, 3]}, {"name": "arm.l", "translation": [1, 1, 0]},
    {"name": "arm.r", "translation": [-1, 1, 0]}, {"name": "hat.l", "translation": [0.5, 2, 0]}],
  "scenes": [{"nodes": [0]}],
  "buffers": [{"byteLength": 56, "uri": "arm.bin"}],
  "bufferViews": [{"buffer": 0, "byteLength": 56}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
    {"bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "VEC4"},
    {"bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "VEC3"}],
  "animations": [{"samplers": [{"input": 0, "output": 1}, {"input": 0, "output": 2}],
    "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}},
      {"sampler": 1, "target": {"path": "pointer",
        "extensions": {"KHR_animation_pointer": {"pointer": "/nodes/1/translation"}}}}]}]})";

void write_one_arm(const ToolModelFile& beside) {
  const float numbers[] = {0, 1, 0.5f, 0.5f, 0.5f, 0.5f, 0, 0.6f, 0, 0.8f, 0, 0, 0, 0};
  std::ofstream(beside.beside("arm.bin"), std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers), sizeof numbers);
  std::ofstream(beside.beside("arm.gltf")) << kOneArm;
}

TEST(convert, mirrors_clips_key_by_key_and_names_joints_without_a_partner) {
  const ToolModelFile model;
  write_one_arm(model);
  const std::string once = model.beside("once.gltf"), twice = model.beside("twice.gltf");
  const CommandOutcome outcome = run_tool({"convert", model.beside("arm.gltf"), once, "--mirror"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("mirrored across (1 0 0) at 0: 2 of 4 joints have partners; without a partner: \"hat.l\""));
  const auto json = nlohmann::json::parse(text_of_file(once));
  EXPECT_EQ(json["animations"][0]["channels"][0]["target"]["node"], 2);
  EXPECT_EQ(json["animations"][0]["channels"][1]["target"]["extensions"]["KHR_animation_pointer"]["pointer"],
            "/nodes/2/translation");
  ASSERT_EQ(run_tool({"convert", once, twice, "--mirror"}).status, 0);
  const auto before = import_gltf(model.beside("arm.gltf")), other = import_gltf(once), after = import_gltf(twice);
  ASSERT_TRUE(before && other && after);
  const BoneAnimation &a = before->scene.animations[0].bones[0], &b = other->scene.animations[0].bones[0],
                      &c = after->scene.animations[0].bones[0];
  EXPECT_EQ(b.joint, other->scene.skeleton.joint_of_node[2]);
  EXPECT_EQ(b.rotation.values[0], quat_xyzw(0.5f, -0.5f, -0.5f, 0.5f));
  EXPECT_EQ(b.translation.values[0], glm::vec3(-0.5f, 0.5f, 0.5f));
  EXPECT_EQ(c.joint, a.joint);
  EXPECT_EQ(c.rotation.values, a.rotation.values);
  EXPECT_EQ(c.translation.values, a.translation.values);
}

TEST(convert, a_joint_without_name_and_partner_is_told_by_its_node) {
  const ToolModelFile model;
  write_one_arm(model);
  auto json = nlohmann::json::parse(kOneArm);
  json["nodes"][3].erase("name");
  json["nodes"].push_back({{"name", "floor"}});  // a root, and so before the arms in the order of joints
  json["scenes"][0]["nodes"].push_back(4);
  std::ofstream(model.beside("arm.gltf")) << json;
  const CommandOutcome outcome = run_tool({"convert", model.beside("arm.gltf"), model.beside("o.glb"), "--mirror"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("; without a partner: node 3\n"));
}

TEST(convert, mirrored_clips_get_fewer_keys_and_are_measured_against_the_mirrored_truth) {
  const ToolModelFile model;
  write_one_arm(model);
  const std::string whole = model.beside("whole.glb"), fewer = model.beside("fewer.glb"),
                    frames = model.beside("frames.glb");
  ASSERT_EQ(run_tool({"convert", model.beside("arm.gltf"), whole, "--mirror"}).status, 0);
  const CommandOutcome budget = run_tool({"convert", model.beside("arm.gltf"), fewer, "--mirror", "--budget", "10mm"});
  ASSERT_EQ(budget.status, 0) << budget.err;
  EXPECT_THAT(budget.err, HasSubstr("2 of 4 joints have partners"));
  const CommandOutcome fps = run_tool({"convert", model.beside("arm.gltf"), frames, "--mirror", "--fps", "4"});
  ASSERT_EQ(fps.status, 0) << fps.err;
  const auto truth = import_gltf(whole), reduced = import_gltf(fewer), resampled = import_gltf(frames);
  ASSERT_TRUE(truth && reduced && resampled);
  for (const auto* file : {&reduced, &resampled}) {
    const BoneAnimation &expected = truth->scene.animations[0].bones[0], &bone = (*file)->scene.animations[0].bones[0];
    EXPECT_EQ(bone.joint, expected.joint) << "the right arm";
    EXPECT_EQ(bone.translation.values.front(), expected.translation.values.front());
    EXPECT_EQ(bone.rotation.values.front(), expected.rotation.values.front());
  }
  EXPECT_EQ(resampled->scene.animations[0].bones[0].rotation.key_count(), 5u);
  // Measured against clips that are not mirrored, the arm would be metres off.
  EXPECT_THAT(budget.out, HasSubstr("10 mm"));
  EXPECT_THAT(budget.out, Not(HasSubstr(" m ")));
}

}  // namespace
}  // namespace sinew::test
