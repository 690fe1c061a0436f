// SPDX-License-Identifier: MIT
// After an error the import sets aside the faulty entry and everything that uses it, and drops reports that only follow
// from it.
#include "importer/file/quarantine.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

/// For each kind of entry: entry 0 depends on buffer 0, entry 1 on buffer 1. Further entries depend on buffer 0 in
/// other ways.
gltf::Document document() {
  gltf::Document d;
  d.buffers.resize(2);
  d.buffer_views.resize(2);
  d.accessors.resize(5);
  d.images.resize(2);
  d.skins.resize(2);
  for (std::uint32_t i = 0; i < 2; ++i) {
    d.buffers[i].byte_length = 100;
    d.buffer_views[i].buffer = i;
    d.accessors[i].buffer_view = i;
    d.images[i].buffer_view = i;
    d.skins[i].joints = {0, 1};
    d.skins[i].inverseBindMatrices = static_cast<int>(i);
  }
  d.accessors[2].sparse = {1, 0, 1};
  d.accessors[3].sparse = {1, 1, 0};
  d.accessors[4].sparse = {1, 1, 1};
  for (gltf::Accessor& accessor : d.accessors) accessor.count = 3;
  d.meshes.resize(4);
  d.meshes[0].primitives.resize(2);
  d.meshes[0].primitives[0].attributes = {{"POSITION", 1}};
  d.meshes[0].primitives[1].attributes = {{"POSITION", 0}};
  d.meshes[0].primitives[1].targets.resize(2);
  for (std::uint32_t m = 1; m < 4; ++m) {
    d.meshes[m].primitives.resize(1);
    d.meshes[m].primitives[0].attributes = {{"POSITION", 1}};
  }
  d.meshes[1].primitives[0].indices = 1;
  d.meshes[2].primitives[0].indices = 0;
  d.meshes[3].primitives[0].targets = {{{"POSITION", 1}}, {{"POSITION", 0}}};
  d.nodes.resize(4);
  for (std::uint32_t n = 0; n < 2; ++n) {
    d.nodes[n].name = "node";
    d.nodes[n].mesh = d.nodes[n].skin = static_cast<int>(n);
    d.nodes[2 + n].extensions["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = n;
  }
  d.animations.resize(1);
  d.animations[0].samplers = {{0, 1, "LINEAR"}, {1, 0, "LINEAR"}, {1, 1, "LINEAR"}};
  for (const char* pointer : {"", "", "/nodes/0/rotation", "/nodes/1/rotation", "/meshes/0/weights",
                              "/meshes/1/weights", "/materials/0/emissiveFactor", "/materials/1/emissiveFactor"})
    d.animations[0].channels.push_back({2, kNone, "pointer", pointer});
  d.animations[0].channels[0].node = 0;
  d.animations[0].channels[1].node = 1;
  d.materials.resize(2);
  for (gltf::Material& material : d.materials) material.name = "material";
  d.scenes.resize(1);
  d.scene = 0;
  return d;
}

/// The document after an error at `place`.
struct Isolated {
  gltf::Document d = document();
  IssueLog log;
  bool goes_on = false;

  explicit Isolated(const std::string& place) {
    log.report(Rule::reference, place, "broken");
    goes_on = Quarantine().isolate(d, log);
    log.take_error("");
  }

  /// True if a report at this place is dropped, because it only follows from the error.
  bool mutes(const std::string& place) {
    log.report(Rule::reference, place, "follows");
    return log.take_error("").issue.json_pointer.empty();
  }
};

TEST(quarantine, a_broken_buffer_empties_what_lies_in_it_and_nothing_else) {
  Isolated after("/buffers/0/uri");
  ASSERT_TRUE(after.goes_on);
  const gltf::Document& d = after.d;
  EXPECT_TRUE(d.buffers[0].placeholder);
  EXPECT_EQ(d.buffers[0].byte_length, 0u);
  EXPECT_FALSE(d.buffers[1].placeholder);
  EXPECT_EQ(d.buffers[1].byte_length, 100u);
  EXPECT_EQ(d.buffer_views[0].buffer, kNone);
  EXPECT_EQ(d.buffer_views[1].buffer, 1u);
  const std::uint64_t counts[] = {0, 3, 0, 0, 3};
  for (std::size_t a = 0; a < 5; ++a) {
    EXPECT_EQ(d.accessors[a].count, counts[a]) << a;
    EXPECT_EQ(d.accessors[a].sparse.count, a == 4 ? 1u : 0u) << a;
  }
  EXPECT_EQ(d.accessors[0].buffer_view, kNone);
  EXPECT_EQ(d.accessors[1].buffer_view, 1u);
  EXPECT_EQ(d.images[0].buffer_view, kNone);
  EXPECT_EQ(d.images[1].buffer_view, 1u);
  EXPECT_EQ(d.meshes[0].primitives[0].attributes.size(), 1u);
  EXPECT_EQ(d.meshes[0].primitives[1].attributes.size(), 0u);
  EXPECT_EQ(d.meshes[0].primitives[1].targets.size(), 2u) << "others of the mesh are compared with it";
  EXPECT_EQ(d.meshes[1].primitives[0].indices, 1u);
  EXPECT_EQ(d.meshes[2].primitives[0].attributes.size(), 0u);
  EXPECT_EQ(d.meshes[3].primitives[0].attributes.size(), 0u);
  EXPECT_EQ(d.skins[0].inverseBindMatrices, gltf::kAbsent);
  EXPECT_EQ(d.skins[0].joints.size(), 2u);
  EXPECT_EQ(d.skins[1].inverseBindMatrices, 1);
}

TEST(quarantine, a_broken_buffer_mutes_what_only_follows_from_it) {
  Isolated after("/buffers/0/uri");
  for (const char* place :
       {"/buffers/0", "/bufferViews/0/byteLength", "/accessors/0", "/accessors/2", "/accessors/3", "/images/0",
        "/meshes/0/primitives/1/mode", "/meshes/2/primitives/0", "/skins/0/inverseBindMatrices", "/nodes/0/skin",
        "/nodes/0/weights", "/nodes/2/extensions/EXT_mesh_gpu_instancing", "/animations/0/samplers/0",
        "/animations/0/samplers/1", "/animations/0/channels/0/target", "/animations/0/channels/2/target",
        "/animations/0/channels/4/target"})
    EXPECT_TRUE(after.mutes(place)) << place;
  for (const char* place :
       {"/buffers/1", "/bufferViews/1", "/accessors/1", "/accessors/4", "/images/1", "/meshes/0/primitives/0",
        "/meshes/1", "/skins/1/inverseBindMatrices", "/skins/0/joints", "/nodes/1/skin", "/nodes/1/weights",
        "/nodes/0/mesh", "/nodes/3/extensions/EXT_mesh_gpu_instancing", "/animations/0/samplers/2",
        "/animations/0/channels/1/target", "/animations/0/channels/3/target", "/animations/0/channels/5/target",
        "/animations/0/channels/6/target"})
    EXPECT_FALSE(after.mutes(place)) << place;
}

TEST(quarantine, a_broken_skin_is_taken_from_its_nodes_only) {
  Isolated after("/skins/0/joints");
  ASSERT_TRUE(after.goes_on);
  EXPECT_TRUE(after.d.skins[0].joints.empty());
  EXPECT_EQ(after.d.skins[1].joints.size(), 2u);
  EXPECT_EQ(after.d.nodes[0].skin, gltf::kAbsent);
  EXPECT_EQ(after.d.nodes[0].mesh, 0u);
  EXPECT_EQ(after.d.nodes[1].skin, 1);
  EXPECT_FALSE(after.mutes("/skins/1/joints"));
}

TEST(quarantine, a_broken_node_is_cut_from_its_tree) {
  Isolated after("/nodes/1/children/0");
  ASSERT_TRUE(after.goes_on);
  EXPECT_TRUE(after.d.nodes[1].name.empty());
  EXPECT_EQ(after.d.nodes[0].name, "node");
  for (const char* place :
       {"/skins/0/joints", "/skins/1/joints", "/animations/0/channels/1/target", "/animations/0/channels/3/target"})
    EXPECT_TRUE(after.mutes(place)) << place;
  EXPECT_FALSE(after.mutes("/animations/0/channels/0/target"));
}

TEST(quarantine, a_primitive_is_put_aside_alone_and_a_mesh_with_all_its_primitives) {
  Isolated primitive("/meshes/0/primitives/0/mode");
  EXPECT_TRUE(primitive.d.meshes[0].primitives[0].attributes.empty());
  EXPECT_FALSE(primitive.d.meshes[0].primitives[1].attributes.empty());
  EXPECT_TRUE(primitive.mutes("/meshes/0/primitives/0"));
  EXPECT_FALSE(primitive.mutes("/meshes/0/primitives/1"));
  EXPECT_TRUE(primitive.mutes("/nodes/0/weights"));
  EXPECT_FALSE(primitive.mutes("/nodes/1/weights"));
  Isolated mesh("/meshes/0/weights");
  EXPECT_TRUE(mesh.d.meshes[0].primitives[0].attributes.empty());
  EXPECT_TRUE(mesh.d.meshes[0].primitives[1].attributes.empty());
  EXPECT_FALSE(mesh.d.meshes[1].primitives[0].attributes.empty());
  EXPECT_TRUE(mesh.mutes("/meshes/0/name"));
  EXPECT_TRUE(mesh.mutes("/animations/0/channels/4/target"));
  EXPECT_FALSE(mesh.mutes("/animations/0/channels/5/target"));
}

TEST(quarantine, materials_animations_and_the_scene_are_emptied_by_their_number) {
  Isolated material("/materials/0/alphaMode");
  EXPECT_TRUE(material.d.materials[0].name.empty());
  EXPECT_EQ(material.d.materials[1].name, "material");
  EXPECT_TRUE(material.mutes("/animations/0/channels/6/target"));
  EXPECT_FALSE(material.mutes("/animations/0/channels/7/target"));
  EXPECT_TRUE(Isolated("/animations/0/name").d.animations[0].samplers.empty());
  Isolated scene("/scene");
  EXPECT_TRUE(scene.goes_on);
  EXPECT_EQ(scene.d.scene, kNone);
  EXPECT_TRUE(scene.mutes("/scene"));
  EXPECT_EQ(Isolated("/scenes/0/nodes").d.scene, 0u);
}

TEST(quarantine, a_channel_is_put_aside_alone_and_a_sampler_with_its_channels) {
  gltf::Document d = document();
  d.animations[0].channels[3].sampler = 1;
  Isolated channel("/animations/0/channels/2/target/node");
  ASSERT_TRUE(channel.goes_on);
  EXPECT_TRUE(channel.d.animations[0].channels[2].pointer.empty());
  EXPECT_EQ(channel.d.animations[0].channels[2].sampler, kNone);
  EXPECT_EQ(channel.d.animations[0].channels[3].pointer, "/nodes/1/rotation");
  EXPECT_EQ(channel.d.animations[0].samplers[2].input, 1u);
  EXPECT_TRUE(channel.mutes("/animations/0/channels/2/target/path"));
  EXPECT_FALSE(channel.mutes("/animations/0/channels/3/target/path"));
  IssueLog log;
  log.report(Rule::reference, "/animations/0/samplers/1/input", "broken");
  ASSERT_TRUE(Quarantine().isolate(d, log));
  EXPECT_EQ(d.animations[0].samplers[1].input, kNone);
  EXPECT_EQ(d.animations[0].samplers[2].input, 1u);
  EXPECT_EQ(d.animations[0].channels[3].sampler, kNone);
  EXPECT_EQ(d.animations[0].channels[4].sampler, 2u);
}

TEST(quarantine, views_inside_the_bytes_of_a_buffer_that_is_too_short_are_kept) {
  gltf::Document d = document();
  const std::vector<std::byte> bytes(60);
  d.buffers[1].bytes = bytes;
  d.buffer_views.push_back(d.buffer_views[1]);
  d.buffer_views[1].byte_length = 60;
  d.buffer_views[2].byte_offset = 40;
  d.buffer_views[2].byte_length = 21;
  IssueLog log;
  log.report(Rule::buffer_short, "/buffers/1", "broken");
  ASSERT_TRUE(Quarantine().isolate(d, log));
  EXPECT_FALSE(d.buffers[1].placeholder);
  EXPECT_EQ(d.buffer_views[1].buffer, 1u);
  EXPECT_EQ(d.buffer_views[2].buffer, kNone);
  EXPECT_EQ(d.accessors[1].count, 3u);
}

TEST(quarantine, errors_of_the_whole_document_end_the_import) {
  for (const char* place : {"", "/asset", "/asset/version", "/buffers", "/buffers/x", "/buffers/-1", "/other/0"})
    EXPECT_FALSE(Isolated(place).goes_on) << place;
  EXPECT_TRUE(Isolated("/nodes").goes_on) << "a tree too deep to show can still be read";
  EXPECT_EQ(Isolated("/nodes").d.nodes[0].name, "node");
}

}  // namespace
}  // namespace sinew::test
