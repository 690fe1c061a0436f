// SPDX-License-Identifier: MIT
// Why commands refuse what they are asked for: exit status, and the sentence word for word.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

using Words = std::vector<std::string>;

/// The text on stderr, without the model's folder in file names.
std::string without_folder(const ToolModelFile& model, std::string text) {
  const std::string folder = model.beside("");
  for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
  return text;
}

class ToolRefusals : public testing::Test {
 protected:
  void expect(int status, const Words& arguments, const std::string& sentence) {
    Words all;
    for (const std::string& word : arguments)
      all.push_back(word.starts_with("@") ? model_.beside(word.substr(1)) : word);
    const CommandOutcome outcome = run_tool(all);
    EXPECT_EQ(outcome.status, status) << testing::PrintToString(arguments);
    EXPECT_EQ(without_folder(model_, outcome.err), sentence) << testing::PrintToString(arguments);
  }

  void write(const char* name, const std::string& text) { std::ofstream(model_.beside(name)) << text; }

  const ToolModelFile model_;
};

TEST_F(ToolRefusals, of_bake) {
  const Words bake = {"bake", "@model.gltf", "-o", "@out.sgeo"};
  const auto with = [&](const Words& more) {
    Words all = bake;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect(2, with({"--normals", "46deg"}), "sinew: --normals: \"46deg\" is no angle up to 45deg, such as 0.5deg\n");
  expect(2, with({"--colors", "0"}), "sinew: --colors: \"0\" is no difference above 0, such as 0.004\n");
  expect(1, with({"--clip", "talk", "--fps", "1000000"}),
         "sinew: model.gltf: --fps 1000000: more than 1000000 frames\n");
  expect(2, bake, "sinew: the file has 2 clips: 0 \"bend\", 1 \"talk\"; choose one with --clip\n");
  expect(0, with({"--clip", "talk"}), "sinew: model.gltf: left out: points or lines of mesh \"strip\"\n");
  write("cloth.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("flag_1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("flag_2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
  write("sail_1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("sail_2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\n");
  expect(1, {"bake", "@cloth.obj", "-o", "@out.sgeo"},
         "sinew: cloth.obj: obj-frames: its name ends in no number, and there is no point cache: give --points\n");
  expect(1, {"bake", "@flag_1.obj", "-o", "@out.sgeo"},
         "sinew: flag_2.obj: obj-topology: it has other faces or another number of vertices than flag_1.obj\n");
  expect(1, {"bake", "@sail_1.obj", "-o", "@out.sgeo"},
         "sinew: sail_2.obj: obj-topology: it has other faces or another number of vertices than sail_1.obj\n");
  expect(2, {"bake", "@flag_1.obj", "--clip", "0", "-o", "@out.sgeo"}, "sinew: --clip: an .obj file has no clips\n");
  expect(2, {"bake", "@flag_1.obj", "--colors", "-o", "@out.sgeo"},
         "sinew: --normals, --colors: point caches and .obj files hold positions over time, and nothing else\n");
}

/// Triangles with colours: those of the second are not opaque; the third has copies, the fourth has neither.
TEST_F(ToolRefusals, of_bake_name_what_a_cache_cannot_hold) {
  TinyGltf file;
  file.add_triangle()["attributes"]["COLOR_0"] = file.vec4(std::vector<float>(12, 1.0f));
  const Json opaque = file.root["meshes"][0];
  Json glass = opaque, plain = opaque;
  glass["name"] = "glass";
  glass["primitives"][0]["attributes"]["COLOR_0"] = file.vec4({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0.5f});
  plain["name"] = "plain";
  plain["primitives"][0]["attributes"].erase("COLOR_0");
  file.root["meshes"] = {opaque, glass, plain};
  const Json places = {{"TRANSLATION", file.vec3({0, 0, 0, 1, 0, 0})}};
  file.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  file.root["nodes"] =
      Json::array({{{"mesh", 0}},
                   {{"mesh", 1}},
                   {{"mesh", 2}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", places}}}}}},
                   {{"mesh", 2}}});
  write("colors.gltf", file.text());
  const std::string copies = "sinew: colors.gltf: left out: copies of mesh \"plain\": only the mesh itself is baked\n";
  const auto last_lines = [&](const Words& more) {
    Words all = {"bake", model_.beside("colors.gltf"), "-o", model_.beside("out.sgeo")};
    all.insert(all.end(), more.begin(), more.end());
    const CommandOutcome outcome = run_tool(all);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string said = without_folder(model_, outcome.err);
    return said.substr(std::min(said.find("sinew: colors.gltf: left out"), said.size()));
  };
  EXPECT_EQ(last_lines({}), copies);
  EXPECT_EQ(last_lines({"--colors"}),
            "sinew: colors.gltf: left out: alpha of the colours of mesh \"glass\"\n" + copies);
}

TEST_F(ToolRefusals, of_convert) {
  expect(2, {"convert", "@model.gltf", "-", "--format", "gltf"}, "sinew: -: a .gltf needs a place for its .bin\n");
  for (const char* option : {"--fps=30", "--budget=1mm"})
    expect(2, {"convert", "@model.gltf", "-", option},
           "sinew: -: cannot be read again and measured, as --budget and --fps do\n");
  expect(2, {"convert", "@model.gltf", "@out.gltf", "--format", "glb"},
         "sinew: out.gltf: --format glb writes a file that ends in .glb\n");
  expect(2, {"convert", "@model.gltf", "@out.glb", "--format", "gltf"},
         "sinew: out.glb: --format gltf writes a file that ends in .gltf\n");
  expect(2, {"convert", "@model.gltf", "@out.txt"},
         "sinew: out.txt: OUT must end in .glb or .gltf, which says what is written\n");
  expect(0, {"convert", "@model.gltf", "@out.gltf", "--format", "gltf"}, "");
}

TEST_F(ToolRefusals, of_clips_name_those_that_are_there) {
  expect(2, {"compile", "@model.gltf", "-o", "@out.sinew", "--clip", "none"},
         "sinew: --clip none: the rest pose has no keys to compile\n");
  expect(2, {"sample", "@model.gltf", "--clip", "2"},
         "sinew: --clip 2: no such clip; the file has 2 clips: 0 \"bend\", 1 \"talk\"\n");
  write("still.gltf", R"({"asset": {"version": "2.0"}})");
  expect(2, {"plan", "@still.gltf", "--clip", "0"}, "sinew: --clip 0: no such clip; the file has no clips\n");
  for (const std::size_t count : {12u, 13u}) {
    TinyGltf file;
    file.add_triangle();
    file.animate("translation", file.times({0, 1}), file.vec3({0, 0, 0, 1, 0, 0}));
    Json& list = file.root["animations"];
    while (list.size() < count) list.push_back(list[0]);
    write("many.gltf", file.text());
    std::string sentence = "--clip x: no such clip; the file has " + std::to_string(count) + " clips: 0 \"\"";
    for (int i = 1; i < 12; ++i) sentence += ", " + std::to_string(i) + " \"\"";
    const std::string said = run_tool({"plan", model_.beside("many.gltf"), "--clip", "x"}).err;
    EXPECT_TRUE(said.ends_with(sentence + (count > 12 ? ", ...\n" : "\n"))) << said;
  }
}

TEST_F(ToolRefusals, of_sample_and_plan) {
  const std::string nodes_only = "sinew: --vertices, --skinning: csv and npy hold nodes only; json and npz hold both\n";
  expect(2, {"sample", "@model.gltf", "--format", "csv", "--vertices", "3"}, nodes_only);
  expect(2, {"sample", "@model.gltf", "--format", "npy", "--skinning", "linear"}, nodes_only);
  expect(2, {"sample", "@model.gltf", "--times", "1,x"}, "sinew: --times 1,x: 'x' is not a number of seconds\n");
  expect(2, {"plan", "@model.gltf", "--skinning", "linear,linear,linear"},
         "sinew: --skinning: 3 methods for 2 mesh instances\n");
  expect(
      2, {"plan", "@model.gltf", "--joint-tolerance", "1 yard"},
      "sinew: --joint-tolerance: \"1 yard\" has a unit that is not m, cm, mm, um or %; lengths look like 0.1mm, 1cm, "
      "0.001m, 50um, 1e-4 (metres) or 0.01% (of the model)\n");
  expect(2, {"verify", "@model.gltf", "@model.gltf", "--tolerance", "-1m"},
         "sinew: --tolerance: \"-1m\" is negative; lengths look like 0.1mm, 1cm, 0.001m, 50um, 1e-4 (metres) or 0.01% "
         "(of the model)\n");
}

/// The model's "strip" has points, which a cache cannot hold; its face is all that is drawn here.
TEST_F(ToolRefusals, are_all_that_stands_on_stderr) {
  nlohmann::json face = nlohmann::json::parse(tool_model());
  for (auto& primitive : face["meshes"][0]["primitives"]) primitive["mode"] = 4;
  face["meshes"][0]["primitives"][0]["indices"] = face["accessors"].size();
  face["accessors"].push_back(
      {{"bufferView", face["bufferViews"].size()}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
  face["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 3}});  // the first bytes are those of zeros
  write("face.gltf", face.dump());
  for (const Words& command :
       std::vector<Words>{{"info", "@face.gltf"},
                          {"check", "@face.gltf"},
                          {"plan", "@face.gltf", "--clip", "0"},
                          {"sample", "@face.gltf", "-o", "@poses.json"},
                          {"verify", "@face.gltf", "@poses.json", "--exact"},
                          {"convert", "@face.gltf", "@again.glb"},
                          {"convert", "@face.gltf", "@fewer.glb", "--budget", "1mm"},
                          {"convert", "@face.gltf", "@small.glb", "--quantize", "--meshopt"},
                          {"compile", "@face.gltf", "-o", "@face.sinew"},
                          {"info", "@face.sinew"},
                          {"check", "@face.sinew"},
                          {"bake", "@face.gltf", "--clip", "1", "-o", "@face.sgeo"},
                          {"info", "@face.sgeo"},
                          {"verify", "@face.sgeo"},
                          {"verify", "@face.sgeo", "--against", "@face.gltf", "--clip", "1"},
                          {"retarget", "@face.gltf", "--onto", "@face.gltf", "-o", "@moved.glb"}})
    expect(0, command, "");
}

}  // namespace
}  // namespace sinew::test
