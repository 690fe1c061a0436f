// SPDX-License-Identifier: MIT
// What `sinew info` says of a document that has something in every table, word for word.
#include <gtest/gtest.h>

#include "importer/tool/info/info_text.h"

namespace sinew::test {
namespace {

constexpr const char* kInfo = R"({
"file": "robot.glb", "version": "2.0", "bytes": 9999, "generator": "a program", "copyright": "nobody",
"nodes": {"count": 7, "roots": 2, "depth": 3}, "scenes": 1, "hidden_nodes": [4, 5],
"extensions": [{"name": "KHR_one", "required": true, "handling": "read"}, {"name": "KHR_two", "required": false, "handling": "ignored"}],
"mesh_instances": [{"copies": 1}, {"copies": 12}],
"meshes": [{"name": "plain", "vertices": 8, "triangles": 12, "primitives": [{}, {}]},
  {"name": "", "vertices": 3, "triangles": 1, "primitives": [{}],
   "morph_targets": [{"name": "smile", "non_zero_deltas": 2, "default_weight": 0.25}]}],
"skins": [{"name": "body", "joints": 5, "joints_with_weight": 4, "vertices_by_influences": {"1": 20, "2": 10}}],
"clips": [{"name": "walk", "duration_s": 1.5, "channels": 6, "keys": 60, "most_keys_of_a_channel": 11, "constant_tracks": 2,
  "bytes_of_keys": 10000, "bytes_compiled": 9999999, "modes": {"linear": 5, "step": 1}, "channels_by_property": {"rotation": 6}}],
"variants": ["red", "blue"],
"materials": [{"name": "skin", "alpha": "mask", "double_sided": true, "unlit": false, "metallic": 0.5, "roughness": 0.75,
   "textures": {"base_color": true, "normal": false, "metallic_roughness": true}},
  {"name": "sign", "alpha": "opaque", "double_sided": false, "unlit": true, "metallic": 0, "roughness": 1, "textures": {"normal": false}}],
"images": [{"name": "a", "missing": null, "format": "image/png", "width": 4, "height": 2, "bytes": 100, "bytes_decoded": 10000000},
  {"name": "b", "missing": "no such file"}, {"name": "c", "missing": null, "format": null, "width": 1, "height": 1, "bytes": 1, "bytes_decoded": 4}],
"cameras": [{"name": "eye", "node": 3, "kind": "perspective", "fov_y_rad": 0.7853981633974483, "half_height": null, "near_m": 0.1, "far_m": null},
  {"name": "plan", "node": null, "kind": "orthographic", "fov_y_rad": null, "half_height": 2.5, "near_m": 0, "far_m": 100}],
"lights": [{"name": "sun", "node": 1, "kind": "directional", "intensity": 3.5, "range_m": null},
  {"name": "lamp", "node": 2, "kind": "point", "intensity": 40, "range_m": 8}],
"warnings": [{"pointer": "/nodes/3", "rule": "node-empty", "message": "is empty"}]})";

constexpr const char* kText = R"(robot.glb
glTF 2.0, 9999 B with all that it refers to
made with: a program
copyright: nobody
nodes: 7, 2 roots, 3 levels deep; scenes: 1
hidden nodes: 2
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
clips: 1
  #  name    seconds  channels  keys  most keys  constant  size of keys  size compiled  modes               properties
  0  "walk"      1.5         6    60         11         2       10.0 kB     10000.0 kB  linear: 5, step: 1  rotation: 6
material variants: "red", "blue"
materials: 2
  #  name    alpha   sides  lighting  metallic  roughness  textures
  0  "skin"  mask    both                  0.5       0.75  base color, metallic roughness
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
warnings: 1
  /nodes/3: node-empty: is empty
)";

TEST(tool_info_text, names_everything_that_the_document_holds) {
  EXPECT_EQ(tool::info_text(nlohmann::ordered_json::parse(kInfo)), kText);
}

/// The least that a document holds.
nlohmann::ordered_json empty_info() {
  return nlohmann::ordered_json::parse(
      R"({"file": "a.gltf", "version": "2.0", "bytes": 10, "generator": "", "copyright": "",
    "nodes": {"count": 0, "roots": 0, "depth": 0}, "scenes": 0, "hidden_nodes": [], "extensions": [], "mesh_instances": [], "meshes": [],
    "skins": [], "clips": [], "variants": [], "materials": [], "images": [], "cameras": [], "lights": [], "warnings": []})");
}

TEST(tool_info_text, leaves_out_what_is_not_there) {
  EXPECT_EQ(
      tool::info_text(empty_info()),
      "a.gltf\nglTF 2.0, 10 B with all that it refers to\nnodes: 0, 0 roots, 0 levels deep; scenes: 0\nextensions: 0\n"
      "mesh instances: 0, shown 0 times\nmeshes: 0\nskins: 0\nclips: 0\nmaterials: 0\nimages: 0\ncameras: 0\nlights: "
      "0\n"
      "warnings: 0\n");
}

}  // namespace
}  // namespace sinew::test
