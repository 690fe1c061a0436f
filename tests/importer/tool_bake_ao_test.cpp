// SPDX-License-Identifier: MIT
// `sinew bake-ao` from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "importer/ambient/ambient_attribute.h"
#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"
#include "tests/importer/gltf_validator.h"
#include "tests/importer/rewritten.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

VertexVisibility visibility_in(const std::string& path) {
  const auto file = import_gltf(path, carrying());
  std::vector<ImportIssue> issues;
  VertexVisibility visibility = file ? read_ambient_visibility(*file, issues) : VertexVisibility();
  EXPECT_TRUE(issues.empty());
  return visibility;
}

/// A square of ground, and a flap beside it that a clip folds from flat to upright: node 1 turns about z.
/// in   repeated   the square is there once more, far away
std::string write_flap(const ToolModelFile& beside, bool repeated = false) {
  TinyGltf gltf;
  const std::size_t square = gltf.vec3({0, 0, 1, 2, 0, 1, 2, 0, -1, 0, 0, -1});
  const std::size_t flap = gltf.vec3({-2, 0, 1, 0, 0, 1, 0, 0, -1, -2, 0, -1});
  const std::size_t up = gltf.vec3({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
  const std::size_t faces = gltf.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  gltf.root["accessors"][square].update({{"min", {0, 0, -1}}, {"max", {2, 0, 1}}});
  gltf.root["accessors"][flap].update({{"min", {-2, 0, -1}}, {"max", {0, 0, 1}}});
  gltf.root["meshes"] = Json::array();
  for (const std::size_t positions : {square, flap})
    gltf.root["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", positions}, {"NORMAL", up}}}, {"indices", faces}}}}});
  gltf.root["nodes"] = Json::array(
      {{{"mesh", 0}}, {{"mesh", 1}, {"translation", {0, 0, 0}}}, {{"name", "spare"}, {"extras", {{"a", 1}}}}});
  if (repeated) gltf.root["nodes"].push_back({{"mesh", 0}, {"translation", {100, 0, 0}}});
  gltf.root["scenes"] = Json::array({{{"nodes", repeated ? Json{0, 1, 2, 3} : Json{0, 1, 2}}}});
  const float half = 0.70710678f;
  gltf.animate("rotation", gltf.times({0, 1}), gltf.vec4({0, 0, 0, 1, 0, 0, -half, half}));
  gltf.root["animations"][0]["channels"][0]["target"]["node"] = 1;
  gltf.root["animations"][0]["name"] = "fold";
  const std::string path = beside.beside(repeated ? "flaps.gltf" : "flap.gltf");
  std::ofstream(path) << gltf.text();
  return path;
}

TEST(bake_ao, writes_the_visibility_of_the_pose_that_is_asked_for) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder), out = folder.beside("out.glb");
  // At the end of the clip the flap stands on the edge x = 0 of the square, its front towards it.
  const auto run = [&](const std::vector<std::string>& more, const std::string& distance = "none") {
    std::vector<std::string> command{"bake-ao", in, "-o", out, "--rays", "1024", "--distance", distance};
    command.insert(command.end(), more.begin(), more.end());
    const CommandOutcome outcome = run_tool(command);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return visibility_in(out).values[0][0];
  };
  const std::vector<float> flat = run({"--pose", "fold@0"}), folded = run({"--pose", "fold@1"});
  EXPECT_THAT(flat, testing::Each(1.0f));
  // At the end of a wall of infinite height, seen from d beside it and e inside of its end, 1/4 + atan(e / d) / (2 pi)
  // is hidden. Of the two faces at that vertex, rays start at e / d = 2 and 1/2, whose angles add up to 90 degrees.
  EXPECT_NEAR(folded[0], 1.0f - (0.25f + 0.125f), 0.01f);
  EXPECT_GT(folded[1], 0.85f) << "far from the wall";
  EXPECT_EQ(run({"--pose", "0@1"}), folded) << "by number";
  EXPECT_EQ(run({"--pose", "fold@1"}, "1mm")[0], 1.0f) << "too far to count";
  EXPECT_NE(run({"--pose", "fold@1", "--seed", "9"}), folded);
}

TEST(bake_ao, key_poses_are_those_of_single_poses_one_attribute_each) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder), out = folder.beside("out.glb"), single = folder.beside("single.glb");
  const CommandOutcome outcome = run_tool({"bake-ao", in, "-o", out, "--key-poses", "3", "--distance", "none"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("8 vertices of 2 primitives in 3 key poses: mean visibility 0.9"));
  const VertexVisibility visibility = visibility_in(out);
  EXPECT_EQ(visibility.clip, 0u);
  EXPECT_EQ(visibility.times_s, (std::vector<double>{0.0, 0.5, 1.0}));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string pose = "fold@" + std::to_string(visibility.times_s[k]);
    ASSERT_EQ(run_tool({"bake-ao", in, "-o", single, "--pose", pose, "--distance", "none"}).status, 0);
    for (std::size_t m = 0; m < 2; ++m) {
      const auto first = visibility.values[m][0].begin() + static_cast<std::ptrdiff_t>(4 * k);
      EXPECT_EQ(std::vector<float>(first, first + 4), visibility_in(single).values[m][0]) << pose << ", mesh " << m;
    }
  }
  EXPECT_LT(visibility.values[0][0][8], visibility.values[0][0][4]) << "the more it stands upright, the more it hides";

  ASSERT_EQ(run_tool({"bake-ao", in, "-o", single, "--rays", "16"}).status, 0);
  const std::string again = folder.beside("again.glb");
  ASSERT_EQ(run_tool({"bake-ao", out, "-o", again, "--rays", "16"}).status, 0);
  EXPECT_EQ(text_of_file(again).size(), text_of_file(single).size()) << "older key poses leave nothing behind";
  EXPECT_EQ(visibility_in(again).values, visibility_in(single).values);
}

TEST(bake_ao, the_distance_of_key_poses_is_that_of_the_first) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder), out = folder.beside("out.glb"), same = folder.beside("same.glb");
  // Flat it is four metres long, upright two.
  ASSERT_EQ(run_tool({"bake-ao", in, "-o", out, "--key-poses", "2", "--clip", "fold"}).status, 0);
  ASSERT_EQ(run_tool({"bake-ao", in, "-o", same, "--key-poses", "2", "--distance", "1m"}).status, 0);
  EXPECT_EQ(visibility_in(out).values, visibility_in(same).values);
}

TEST(bake_ao, carries_all_else_and_gives_the_same_bytes_twice) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder), out = folder.beside("out.glb"), plain = folder.beside("plain.glb");
  const CommandOutcome outcome = run_tool({"bake-ao", in, "-o", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("8 vertices of 2 primitives: mean visibility 1.000, darkest 1.000"));
  const std::string first = text_of_file(out);
  ASSERT_EQ(run_tool({"bake-ao", in, "-o", out}).status, 0);
  EXPECT_EQ(text_of_file(out), first);
  ASSERT_EQ(run_tool({"bake-ao", out, "-o", folder.beside("again.glb")}).status, 0);
  EXPECT_EQ(text_of_file(folder.beside("again.glb")).size(), first.size()) << "the old values are gone";
  ASSERT_EQ(run_tool({"convert", in, plain}).status, 0);
  const auto json_in = [](const std::string& path) {
    const std::string bytes = text_of_file(path);
    const auto all = std::as_bytes(std::span(bytes));
    return split_glb({all.begin(), all.end()}).json;
  };
  Json before = json_in(plain), after = json_in(out);
  for (std::size_t m = 0; m < 2; ++m)
    EXPECT_EQ(after["meshes"][m]["primitives"][0]["attributes"].erase("_AMBIENT_ACCESS"), 1u);
  for (const char* part : {"meshes", "nodes", "animations", "scenes"}) EXPECT_EQ(after[part], before[part]) << part;
}

TEST(bake_ao, a_mesh_at_several_places_gets_the_mean_and_a_warning) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder, true), out = folder.beside("out.gltf");
  const CommandOutcome outcome =
      run_tool({"bake-ao", in, "-o", out, "--rays", "1024", "--distance", "none", "--pose", "fold@1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(in + ": /meshes/0: warning: is at 2 places; its vertices get the mean of them"));
  EXPECT_NEAR(visibility_in(out).values[0][0][0], 0.5f * (0.625f + 1.0f), 0.01f) << "here and far away";
}

TEST(bake_ao, copies_of_a_mesh_are_places_too) {
  const ToolModelFile folder;
  const std::string in = folder.beside("copies.gltf");
  Json gltf = Json::parse(std::ifstream(write_flap(folder)));
  const Json four_places = gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  gltf["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = four_places;
  gltf["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  std::ofstream(in) << gltf.dump();
  const CommandOutcome outcome = run_tool({"bake-ao", in, "-o", folder.beside("out.glb"), "--rays", "4"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(in + ": /meshes/0: warning: is at 4 places; its vertices get the mean of them"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("/meshes/1")));
}

TEST(bake_ao, says_what_is_wrong_with_its_options_and_files) {
  const ToolModelFile folder;
  const std::string in = write_flap(folder), out = folder.beside("out.glb");
  const auto says = [&](const std::vector<std::string>& more, int status, const std::string& text) {
    std::vector<std::string> command{"bake-ao", in, "-o", out};
    command.insert(command.end(), more.begin(), more.end());
    const CommandOutcome outcome = run_tool(command);
    EXPECT_EQ(outcome.status, status) << text;
    EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_FALSE(fs::exists(out));
  };
  says({"--pose", "fold"}, 2, "--pose: \"fold\" is not CLIP@SECONDS");
  says({"--pose", "fold@-1"}, 2, "is not CLIP@SECONDS");
  says({"--pose", "fold@nan"}, 2, "is not CLIP@SECONDS");
  says({"--pose", "bend@1"}, 2, "--pose bend@1: no such clip; the file has 1 clip: 0 \"fold\"");
  says({"--distance", "0"}, 2, "--distance: \"0\" is not above 0");
  says({"--distance", "far"}, 2, "--distance: ");
  says({"--rays", "0"}, 2, "--rays");
  says({"--rays", "1048577"}, 2, "--rays");
  says({in}, 2, "");
  says({"--key-poses", "1"}, 2, "--key-poses");
  says({"--key-poses", "65"}, 2, "--key-poses");
  says({"--key-poses", "4", "--pose", "fold@0"}, 2, "--pose excludes --key-poses");
  says({"--clip", "fold"}, 2, "--clip requires --key-poses");
  says({"--key-poses", "4", "--clip", "bend"}, 2,
       "--key-poses: there is no clip \"bend\"; the file has 1 clip: 0 \"fold\"");
  says({"--key-poses", "4", "--clip", "none"}, 2, "--key-poses: there is no clip \"none\"");
  std::ofstream(folder.beside("empty.gltf")) << R"({"asset": {"version": "2.0"}, "nodes": [{}]})";
  const CommandOutcome empty = run_tool({"bake-ao", folder.beside("empty.gltf"), "-o", out});
  EXPECT_EQ(empty.status, 1);
  EXPECT_THAT(empty.err, HasSubstr("empty.gltf: no node shows triangles, so nothing is baked"));
  EXPECT_EQ(run_tool({"bake-ao", in, "-o", folder.beside("out.png")}).status, 2);
  EXPECT_EQ(run_tool({"bake-ao", folder.beside("none.glb"), "-o", out}).status, 1);
}

TEST(bake_ao, a_clip_that_lasts_no_time_has_no_key_poses) {
  const ToolModelFile folder;
  const std::string in = folder.beside("still.gltf");
  Json gltf = Json::parse(std::ifstream(write_flap(folder)));
  const Json sampler = gltf["animations"][0]["samplers"][0];
  for (const char* side : {"input", "output"}) gltf["accessors"][sampler[side].get<std::size_t>()]["count"] = 1;
  gltf["accessors"][sampler["input"].get<std::size_t>()]["max"] = {0};
  std::ofstream(in) << gltf.dump();
  const CommandOutcome outcome = run_tool({"bake-ao", in, "-o", folder.beside("out.glb"), "--key-poses", "4"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--key-poses: clip \"fold\" lasts no time: --pose bakes its one pose, --clip "
                                     "names another"));
}

TEST(bake_ao, images_are_not_looked_at_and_what_may_be_lost_has_to_be_named) {
  const ToolModelFile folder;
  const std::string in = folder.beside("images.gltf"), out = folder.beside("out.glb");
  const auto with_image = [&](const char* image) {
    Json gltf = Json::parse(std::ifstream(write_flap(folder)));
    gltf["images"] = Json::array({Json::parse(image)});
    std::ofstream(in) << gltf.dump();
  };
  with_image(R"({"uri": "data:image/png;base64,AAAA"})");
  const CommandOutcome damaged = run_tool({"bake-ao", in, "-o", out, "--rays", "1"});
  EXPECT_EQ(damaged.status, 0) << "one ray is enough";
  EXPECT_EQ(damaged.err, "") << "the image is carried as it is";
  fs::remove(out);
  with_image(R"({"uri": "nowhere.png"})");
  EXPECT_EQ(run_tool({"bake-ao", in, "-o", out}).status, 1);
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(run_tool({"bake-ao", in, "-o", out, "--drop", "image-missing"}).status, 0);
  EXPECT_TRUE(fs::exists(out));
}

TEST(bake_ao, an_independent_validator_is_as_silent_as_before) {
  const ToolModelFile folder;
  std::vector<std::string> files;
  const auto add = [&](const std::string& in, std::vector<std::string> more = {}) {
    const std::string number = std::to_string(files.size()), plain = folder.beside("plain" + number + ".glb"),
                      out = folder.beside("out" + number + ".glb");
    ASSERT_EQ(run_tool({"convert", in, plain}).status, 0);
    more.insert(more.begin(), {"bake-ao", in, "-o", out, "--rays", "8"});
    ASSERT_EQ(run_tool(more).status, 0);
    files.insert(files.end(), {plain, out});
  };
  add(write_flap(folder));
  add(write_flap(folder), {"--key-poses", "3"});
  for (const auto& sample : showcase::showcase()) {
    const std::string in = folder.beside("in" + std::to_string(files.size()) + ".glb");
    ASSERT_TRUE(export_glb(sample.scene, fs::path(in)));
    add(in);
  }
  const auto issues = issues_by_validator(folder, files, 3);
  if (!issues) GTEST_SKIP() << kNoValidator;
  for (std::size_t i = 0; i < files.size(); i += 2) EXPECT_EQ(issues->at(files[i + 1]), issues->at(files[i]));
  EXPECT_THAT(issues->dump(), testing::Not(HasSubstr("_AMBIENT_ACCESS")));
}

}  // namespace
}  // namespace sinew::test
