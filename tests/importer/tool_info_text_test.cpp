// SPDX-License-Identifier: MIT
// Output of `sinew info`, word for word, for a document with an entry in every table.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "importer/import_gltf.h"
#include "importer/tool/info/info_text.h"
#include "importer/tool/info/skin_statistics.h"
#include "runtime/memory/memory_of.h"
#include "tests/importer/tool_json.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {

constexpr const char* kInfo = R"({
"file": "robot.glb", "version": "2.0", "bytes": 9999, "generator": "a program", "copyright": "nobody",
"nodes": {"count": 7, "roots": 2, "depth": 3}, "scenes": 1, "bounds": {"lower": [-1, 0, -2.5], "upper": [1, 1.75, 2]},
"hidden_nodes": [4, 5], "memory": {"total": 12600000, "clip_keys": 20000, "vertices": 12580000},
"extensions": [{"name": "KHR_one", "required": true, "handling": "read"}, {"name": "KHR_two", "required": false, "handling": "ignored"}],
"mesh_instances": [{"copies": 1}, {"copies": 12}],
"meshes": [{"name": "plain", "vertices": 8, "triangles": 12, "primitives": [{}, {}]},
  {"name": "", "vertices": 3, "triangles": 1, "primitives": [{}],
   "morph_targets": [{"name": "smile", "non_zero_deltas": 2, "default_weight": 0.25}]}],
"skins": [{"name": "body", "joints": 5, "joint_names": ["hip", "knee", "ankle", "", "toe"], "joints_with_weight": 4, "vertices_by_influences": {"1": 20, "2": 10}}],
"clips": [{"name": "walk", "duration_s": 1.5, "animated_nodes": [1, 2, 3], "channels": 6, "keys": 60, "most_keys_of_a_channel": 11, "constant_tracks": 2,
  "bytes_of_keys": 10000, "bytes_compiled": 9999999, "modes": {"linear": 5, "step": 1}, "channels_by_property": {"rotation": 6},
  "events": [{"time_s": 0.25, "name": "left foot"}, {"time_s": 1, "name": "right foot"}], "curves": [{"name": "trail", "type": "float", "keys": 2}]}],
"variants": ["red", "blue"],
"materials": [{"name": "skin", "alpha": "mask", "double_sided": true, "unlit": false, "metallic": 0.5, "roughness": 0.75,
   "texture_images": {"base_color": 1, "metallic_roughness": null}},
  {"name": "sign", "alpha": "opaque", "double_sided": false, "unlit": true, "metallic": 0, "roughness": 1, "texture_images": {}}],
"images": [{"name": "a", "missing": null, "format": "image/png", "width": 4, "height": 2, "bytes": 100, "bytes_decoded": 10000000},
  {"name": "b", "missing": "no such file"}, {"name": "c", "missing": null, "format": null, "width": 1, "height": 1, "bytes": 1, "bytes_decoded": 4}],
"cameras": [{"name": "eye", "node": 3, "kind": "perspective", "fov_y_rad": 0.7853981633974483, "half_height": null, "near_m": 0.1, "far_m": null},
  {"name": "plan", "node": null, "kind": "orthographic", "fov_y_rad": null, "half_height": 2.5, "near_m": 0, "far_m": 100}],
"lights": [{"name": "sun", "node": 1, "kind": "directional", "intensity": 3.5, "range_m": null},
  {"name": "lamp", "node": 2, "kind": "point", "intensity": 40, "range_m": 8}],
"warnings": [{"pointer": "/nodes/3", "rule": "node-empty", "message": "is empty", "cases": 1},
  {"pointer": "/meshes/0", "rule": "mesh-odd", "message": "is odd", "cases": 1},
  {"pointer": "/nodes/4", "rule": "node-empty", "message": "is empty", "cases": 7}],
"lost_by_convert": [{"pointer": "/images/1", "rule": "not-carried", "message": "image-missing: no such file", "cases": 1}]})";

constexpr const char* kText = R"(robot.glb
glTF 2.0, 9999 B with all that it refers to
made with: a program
copyright: nobody
nodes: 7, 2 roots, 3 levels deep; scenes: 1
bounds at rest: (-1, 0, -2.5) to (1, 1.75, 2), 2 x 1.75 x 4.5 m
hidden nodes: 2
memory: 12.6 MB (clip keys 20.0 kB, vertices 12.6 MB)
extensions: 2
  #  name       required  handling
  0  "KHR_one"  required  read
  1  "KHR_two"            ignored
mesh instances: 2, shown 13 times
meshes: 2
  #  name     vertices  triangles  primitives  morph targets
  0  "plain"         8         12           2
  1                  3          1           1              1
morph targets of mesh 1: 1
  #  name     non-zero deltas  default weight
  0  "smile"                2            0.25
skins: 1
  #  name    joints  with weight  vertices by number of influences
  0  "body"       5            4  1: 20, 2: 10
joints of skin 0: "hip", "knee", "ankle", "", "toe"
clips: 1
  #  name    seconds  nodes  channels  keys  most keys  constant  size of keys  size compiled  modes               properties
  0  "walk"      1.5      3         6    60         11         2       10.0 kB     10000.0 kB  linear: 5, step: 1  rotation: 6
events of "walk": "left foot" at 0.25 s, "right foot" at 1 s
curves of "walk": "trail" (float, 2 keys)
material variants: "red", "blue"
materials: 2
  #  name    alpha   sides  lighting  metallic  roughness  textures
  0  "skin"  mask    both                  0.5       0.75  base color: image 1, metallic roughness: no image
  1  "sign"  opaque         unlit            0          1
images: 3
  #  name  format     width  height  in the file  decoded  missing because
  0  "a"   image/png      4       2        100 B  10.0 MB
  1  "b"                                                   no such file
  2  "c"                  1       1          1 B      4 B
cameras: 2
  #  name    node  kind          field of view  half height  near  far
  0  "eye"      3  perspective          45 deg                0.1
  1  "plan"        orthographic                         2.5     0  100
lights: 2
  #  name    node  kind         intensity  range
  0  "sun"      1  directional        3.5
  1  "lamp"     2  point               40      8
warnings: 9
  /nodes/3: node-empty x8: is empty
  /meshes/0: mesh-odd: is odd
lost by convert: 1
  /images/1: not-carried: image-missing: no such file
)";

TEST(tool_info_text, names_everything_that_the_document_holds) {
  EXPECT_EQ(tool::info_text(tool_json(nlohmann::ordered_json::parse(kInfo)), false), kText);
}

/// The least that a document holds.
nlohmann::ordered_json empty_info() {
  return nlohmann::ordered_json::parse(
      R"({"file": "a.gltf", "version": "2.0", "bytes": 10, "generator": "", "copyright": "",
    "nodes": {"count": 0, "roots": 0, "depth": 0}, "scenes": 0, "bounds": null, "hidden_nodes": [], "memory": {"total": 0}, "extensions": [], "mesh_instances": [], "meshes": [],
    "skins": [], "clips": [], "variants": [], "materials": [], "images": [], "cameras": [], "lights": [], "warnings": [], "lost_by_convert": []})");
}

TEST(tool_info_text, leaves_out_what_is_not_there) {
  EXPECT_EQ(
      tool::info_text(tool_json(empty_info()), false),
      "a.gltf\nglTF 2.0, 10 B with all that it refers to\nnodes: 0, 0 roots, 0 levels deep; scenes: 0\nmemory: 0 "
      "B\nextensions: 0\n"
      "mesh instances: 0, shown 0 times\nmeshes: 0\nskins: 0\nclips: 0\nmaterials: 0\nimages: 0\ncameras: 0\nlights: "
      "0\n"
      "warnings: 0\nlost by convert: 0\n");
}

TEST(tool_info_text, lists_everything_when_asked) {
  const std::string text = tool::info_text(tool_json(nlohmann::ordered_json::parse(kInfo)), true);
  EXPECT_NE(
      text.find(
          "\nwarnings: 9\n  /nodes/3: node-empty: is empty\n  /meshes/0: mesh-odd: is odd\n  /nodes/4: node-empty: "),
      std::string::npos);
}

TEST(tool_info_text, copies_of_a_vertex_count_once) {
  Scene scene;
  Primitive primitive;
  primitive.positions.resize(5);
  primitive.source_vertex = {0, 0, 1, 2, 1};
  primitive.influences.groups = {{0, 3, 1, 0}, {3, 2, 2, 3}};
  primitive.influences.joints = {4, 4, 5, 4, 6, 4, 6};
  EXPECT_EQ(tool::file_vertex_count(primitive), 3u);
  scene.meshes.push_back({"", {primitive}, {}, {}});
  scene.instances = {{.joint = 0, .mesh = 0, .skin = 0}, {.joint = 0, .mesh = 0, .skin = 0}};
  const tool::SkinStatistics statistics = tool::skin_statistics(scene, 0);
  EXPECT_EQ(statistics.vertices_by_influences, (std::map<std::uint32_t, std::uint64_t>{{1, 2}, {2, 1}}));
  EXPECT_EQ(statistics.joints_with_weight, 3u);
}

TEST(tool_info_text, a_skin_counts_each_of_its_meshes_once) {
  Primitive primitive;
  primitive.positions.resize(2);
  primitive.influences = {{{0, 2, 1, 0}}, {4, 4}, {1.0f, 1.0f}};
  Scene scene;
  for (const std::uint16_t joint : std::initializer_list<std::uint16_t>{4, 5, 6}) {
    primitive.influences.joints[1] = joint;
    scene.meshes.push_back({"", {primitive, primitive}, {}, {}});
  }
  scene.instances = {{.joint = 0, .mesh = 0, .skin = 1},
                     {.joint = 0, .mesh = 1, .skin = 1},
                     {.joint = 0, .mesh = 1, .skin = 1},
                     {.joint = 0, .mesh = 2, .skin = 0}};
  const tool::SkinStatistics statistics = tool::skin_statistics(scene, 1);
  EXPECT_EQ(statistics.vertices_by_influences, (std::map<std::uint32_t, std::uint64_t>{{1, 8}}));
  EXPECT_EQ(statistics.joints_with_weight, 2u);
}

TEST(tool_info_text, shows_the_first_joints_of_a_large_skin_in_lines_that_fit) {
  auto info = nlohmann::ordered_json::parse(kInfo);
  info["skins"][0]["joint_names"] = std::vector<std::string>(60, "a joint");
  std::istringstream text(tool::info_text(tool_json(info), false));
  std::string words;
  for (std::string word; text >> word;) words += word + ' ';
  EXPECT_NE(words.find("\"a joint\" and 36 more (--all lists them) clips: "), std::string::npos) << words;
  const std::string all = tool::info_text(tool_json(info), true);
  EXPECT_EQ(all.find("more (--all"), std::string::npos);
  const std::size_t begin = all.find("joints of skin 0"), end = all.find("\nclips");
  std::istringstream lines(all.substr(begin, end - begin));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(tool_info_text, one_line_has_the_counts) {
  EXPECT_EQ(tool::info_line(tool_json(nlohmann::ordered_json::parse(kInfo))),
            "robot.glb: 9999 B, 7 nodes, 2 meshes, 11 vertices, 13 triangles, 1 skin, 1 clip, 9 warnings\n");
}

TEST(tool_info_text, the_tree_of_nodes_shows_what_hangs_on_each) {
  const ToolModelFile model;
  const std::string text = run_tool({"info", model.path(), "--tree"}).out;
  EXPECT_NE(text.find("node tree:\n"
                      "  0 \"strip\": mesh 0, skin 0\n"
                      "  1 \"root\": joint of skin 0\n"
                      "    2 \"tip\": joint of skin 0, animated by clip 0\n"
                      "  3 \"face\": mesh 1, animated by clip 1\n"),
            std::string::npos)
      << text;
}

TEST(tool_info_text, a_chain_of_nodes_takes_no_more_text_than_nodes) {
  constexpr std::size_t kNodes = 20'000;
  const ToolModelFile model;
  nlohmann::json nodes = nlohmann::json::array();
  for (std::size_t n = 0; n + 1 < kNodes; ++n) nodes.push_back({{"children", {n + 1}}});
  nodes.push_back(nlohmann::json::object());
  std::ofstream(model.beside("chain.gltf")) << nlohmann::json{{"asset", {{"version", "2.0"}}}, {"nodes", nodes}};
  const CommandOutcome outcome = run_tool({"info", model.beside("chain.gltf"), "--tree"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_LT(outcome.out.size(), kNodes * 100);
  EXPECT_NE(outcome.out.find("(depth 19999) 19999\n"), std::string::npos);
}

TEST(tool_info_text, the_document_counts_memory_by_kind_with_decoded_images) {
  const ToolModelFile model;
  const auto scene = import_gltf(model.path(), {.decode_images = false})->scene;
  const MemoryBytes bytes = memory_of(scene);
  const auto memory = nlohmann::json::parse(run_tool({"info", model.path(), "--json"}).out)["memory"];
  EXPECT_EQ(memory["vertices"], bytes.vertices);
  EXPECT_EQ(memory["clip_keys"], bytes.clip_keys);
  EXPECT_EQ(memory["skeletons"], bytes.skeletons);
  EXPECT_FALSE(memory.contains("frames"));
  std::size_t sum = 0;
  for (const auto& [kind, size] : memory.items()) sum += kind == "total" ? 0 : size.get<std::size_t>();
  EXPECT_EQ(memory["total"], sum);
}

TEST(tool_info_text, images_count_with_the_pixels_that_they_decode_to) {
  const ToolModelFile model;
  std::ofstream(model.beside("dot.gltf"))
      << R"({"asset": {"version": "2.0"}, "images": [{"uri": "data:image/png;base64,)"
         "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQA"
         R"(AAABJRU5ErkJggg=="}]})";
  const auto info = nlohmann::json::parse(run_tool({"info", model.beside("dot.gltf"), "--json"}).out);
  EXPECT_EQ(info["images"][0]["bytes_decoded"], 4);
  const auto scene = import_gltf(model.beside("dot.gltf"), {.decode_images = false})->scene;
  EXPECT_EQ(info["memory"]["images"], 4 + memory_of(scene).images);
}

TEST(tool_info_text, the_document_tells_bounds_joints_images_and_what_is_lost) {
  const ToolModelFile model;
  const auto info = nlohmann::json::parse(run_tool({"info", model.path(), "--json"}).out);
  EXPECT_EQ(info["bounds"]["lower"], (nlohmann::json{0, 0, 0}));
  EXPECT_EQ(info["bounds"]["upper"], (nlohmann::json{3, 2, 0.25}));
  EXPECT_EQ(info["meshes"][1]["bounds"]["upper"], (nlohmann::json{1, 1, 0}));
  EXPECT_EQ(info["skins"][0]["joint_names"], (nlohmann::json{"root", "tip"}));
  EXPECT_EQ(info["clips"][1]["animated_nodes"], nlohmann::json{3});
  EXPECT_TRUE(info["lost_by_convert"].empty());
  EXPECT_FALSE(info.contains("node_list"));
  std::ofstream(model.beside("picture.gltf")) << R"({"asset": {"version": "2.0"}, "images": [{"uri": "none.png"}, {}],
    "textures": [{"source": 1}, {"source": 0}],
    "materials": [{"normalTexture": {"index": 1}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]})";
  const auto picture = nlohmann::json::parse(run_tool({"info", model.beside("picture.gltf"), "--json"}).out);
  EXPECT_EQ(picture["materials"][0]["texture_images"], (nlohmann::json{{"base_color", 1}, {"normal", 0}}));
  EXPECT_EQ(picture["bounds"], nullptr);
  ASSERT_FALSE(picture["lost_by_convert"].empty());
  EXPECT_EQ(picture["lost_by_convert"][0]["pointer"], "/images/0");
}

}  // namespace
}  // namespace sinew::test
