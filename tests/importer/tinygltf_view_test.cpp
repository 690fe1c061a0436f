// SPDX-License-Identifier: MIT
// Compares two readings of each model: by tinygltf alone, without the checks before it, and by the importer. The
// importer feeds tinygltf slices of the core properties. Both must agree on every model and on the outputs of both
// writers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "importer/export_glb.h"
#include "importer/file/glb_container.h"
#include "importer/file/gltf_shape.h"
#include "importer/file/parse_json.h"
#include "importer/file/read_document.h"
#include "importer/file/tinygltf.h"
#include "tests/importer/rewritten.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

bool leave_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

/// Reads a file by tinygltf without our checks, and without decoding images. std::nullopt if tinygltf refuses it.
std::optional<tinygltf::Model> read_alone(std::span<const std::byte> bytes, const std::string& folder) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(leave_image, nullptr);
  std::string error, warning;
  tinygltf::Model out;
  const auto size = static_cast<unsigned>(bytes.size());
  const bool good =
      looks_like_glb(bytes)
          ? reader.LoadBinaryFromMemory(&out, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                        size, folder)
          : reader.LoadASCIIFromString(&out, &error, &warning, reinterpret_cast<const char*>(bytes.data()), size,
                                       folder);
  return good ? std::optional(std::move(out)) : std::nullopt;
}

gltf::Document read_checked(std::span<const std::byte> bytes) {
  IssueLog log;
  const auto json = parse_json(looks_like_glb(bytes) ? open_glb(bytes, log)->json : bytes, log);
  check_shape(json->root, gltf_shape(), "", log);
  EXPECT_TRUE(log.ok());
  return read_document(json->root);
}

std::uint32_t index_of(int number) { return static_cast<std::uint32_t>(number); }  // -1 becomes kNone

void expect_same(const tinygltf::Primitive& a, const gltf::Primitive& c) {
  EXPECT_EQ(a.attributes, c.attributes);
  EXPECT_EQ(a.indices, c.indices);
  EXPECT_EQ(a.material, c.material);
  EXPECT_EQ(a.mode, c.mode);
  EXPECT_EQ(a.targets, c.targets);
}

void expect_same(const tinygltf::Mesh& a, const gltf::Mesh& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.weights, c.weights);
  ASSERT_EQ(a.primitives.size(), c.primitives.size());
  for (std::size_t p = 0; p < a.primitives.size(); ++p) expect_same(a.primitives[p], c.primitives[p]);
}

void expect_same(const tinygltf::Node& a, const gltf::Node& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.children, c.children);
  EXPECT_EQ(a.mesh, c.mesh);
  EXPECT_EQ(a.skin, c.skin);
  EXPECT_EQ(a.camera, c.camera);
  EXPECT_EQ(a.weights, c.weights);
  EXPECT_EQ(a.matrix, c.matrix);
  EXPECT_EQ(a.translation, c.translation);
  EXPECT_EQ(a.rotation, c.rotation);
  EXPECT_EQ(a.scale, c.scale);
}

void expect_same(const tinygltf::Skin& a, const tinygltf::Skin& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.joints, c.joints);
  EXPECT_EQ(a.inverseBindMatrices, c.inverseBindMatrices);
  EXPECT_EQ(a.skeleton, c.skeleton);
}

void expect_same(const tinygltf::Texture& a, const gltf::Texture& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.source, c.source);
  EXPECT_EQ(a.sampler, c.sampler);
}

void expect_same(const tinygltf::Sampler& a, const tinygltf::Sampler& c) {
  EXPECT_EQ(a.magFilter, c.magFilter);
  EXPECT_EQ(a.minFilter, c.minFilter);
  EXPECT_EQ(a.wrapS, c.wrapS);
  EXPECT_EQ(a.wrapT, c.wrapT);
}

void expect_same(const tinygltf::Camera& a, const tinygltf::Camera& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.type, c.type);
  EXPECT_EQ(a.perspective.yfov, c.perspective.yfov);
  EXPECT_EQ(a.perspective.aspectRatio, c.perspective.aspectRatio);
  EXPECT_EQ(a.perspective.znear, c.perspective.znear);
  EXPECT_EQ(a.perspective.zfar, c.perspective.zfar);
  EXPECT_EQ(a.orthographic.xmag, c.orthographic.xmag);
  EXPECT_EQ(a.orthographic.ymag, c.orthographic.ymag);
  EXPECT_EQ(a.orthographic.znear, c.orthographic.znear);
  EXPECT_EQ(a.orthographic.zfar, c.orthographic.zfar);
}

void expect_same(const tinygltf::Scene& a, const tinygltf::Scene& c) {
  EXPECT_EQ(a.name, c.name);
  EXPECT_EQ(a.nodes, c.nodes);
}

template <class A, class C>
void expect_same(const char* name, const std::vector<A>& alone, const std::vector<C>& checked) {
  ASSERT_EQ(alone.size(), checked.size()) << name;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    SCOPED_TRACE(name + (" " + std::to_string(i)));
    expect_same(alone[i], checked[i]);
  }
}

void expect_same(const std::vector<tinygltf::BufferView>& alone, const std::vector<gltf::BufferView>& checked) {
  ASSERT_EQ(alone.size(), checked.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(index_of(alone[i].buffer), checked[i].buffer) << i;
    EXPECT_EQ(alone[i].byteOffset, checked[i].byte_offset) << i;
    EXPECT_EQ(alone[i].byteLength, checked[i].byte_length) << i;
    EXPECT_EQ(alone[i].byteStride, checked[i].byte_stride) << i;
  }
}

int number_of(gltf::ElementType type) {
  constexpr int kNumbers[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4,
                              TINYGLTF_TYPE_MAT2,   TINYGLTF_TYPE_MAT3, TINYGLTF_TYPE_MAT4};
  return kNumbers[static_cast<std::size_t>(type)];
}

void expect_same(const std::vector<tinygltf::Accessor>& alone, const std::vector<gltf::Accessor>& checked) {
  ASSERT_EQ(alone.size(), checked.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const auto& a = alone[i];
    const auto& c = checked[i];
    EXPECT_EQ(index_of(a.bufferView), c.buffer_view) << i;
    EXPECT_EQ(a.byteOffset, c.byte_offset) << i;
    EXPECT_EQ(a.count, c.count) << i;
    EXPECT_EQ(a.componentType, static_cast<int>(c.component_type)) << i;
    EXPECT_EQ(a.type, number_of(c.type)) << i;
    EXPECT_EQ(a.normalized, c.normalized) << i;
    EXPECT_EQ(a.minValues, c.min) << i;
    EXPECT_EQ(a.maxValues, c.max) << i;
    ASSERT_EQ(a.sparse.isSparse, c.sparse.count > 0) << i;
    if (!a.sparse.isSparse) continue;
    EXPECT_EQ(std::uint64_t(a.sparse.count), c.sparse.count) << i;
    EXPECT_EQ(index_of(a.sparse.indices.bufferView), c.sparse.indices_view) << i;
    EXPECT_EQ(std::uint64_t(a.sparse.indices.byteOffset), c.sparse.indices_offset) << i;
    EXPECT_EQ(a.sparse.indices.componentType, static_cast<int>(c.sparse.index_type)) << i;
    EXPECT_EQ(index_of(a.sparse.values.bufferView), c.sparse.values_view) << i;
    EXPECT_EQ(std::uint64_t(a.sparse.values.byteOffset), c.sparse.values_offset) << i;
  }
}

template <class Texture>
void expect_same_texture(const Texture& alone, const Texture& checked, std::size_t material) {
  EXPECT_EQ(alone.index, checked.index) << material;
  EXPECT_EQ(alone.texCoord, checked.texCoord) << material;
}

void expect_same(const std::vector<tinygltf::Material>& alone, const std::vector<gltf::Material>& checked) {
  ASSERT_EQ(alone.size(), checked.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const auto& a = alone[i];
    const auto& c = checked[i];
    const auto &surface = a.pbrMetallicRoughness, &checked_surface = c.pbrMetallicRoughness;
    EXPECT_EQ(a.name, c.name) << i;
    EXPECT_EQ(surface.baseColorFactor, checked_surface.baseColorFactor) << i;
    EXPECT_EQ(a.emissiveFactor, c.emissiveFactor) << i;
    EXPECT_EQ(surface.metallicFactor, checked_surface.metallicFactor) << i;
    EXPECT_EQ(surface.roughnessFactor, checked_surface.roughnessFactor) << i;
    EXPECT_EQ(a.normalTexture.scale, c.normalTexture.scale) << i;
    EXPECT_EQ(a.occlusionTexture.strength, c.occlusionTexture.strength) << i;
    EXPECT_EQ(a.alphaCutoff, c.alphaCutoff) << i;
    EXPECT_EQ(a.alphaMode, c.alphaMode) << i;
    EXPECT_EQ(a.doubleSided, c.doubleSided) << i;
    expect_same_texture(surface.baseColorTexture, checked_surface.baseColorTexture, i);
    expect_same_texture(surface.metallicRoughnessTexture, checked_surface.metallicRoughnessTexture, i);
    expect_same_texture(a.normalTexture, c.normalTexture, i);
    expect_same_texture(a.occlusionTexture, c.occlusionTexture, i);
    expect_same_texture(a.emissiveTexture, c.emissiveTexture, i);
  }
}

void expect_same(const std::vector<tinygltf::Animation>& alone, const std::vector<gltf::Animation>& checked) {
  ASSERT_EQ(alone.size(), checked.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const auto& a = alone[i];
    auto c = checked[i];
    EXPECT_EQ(a.name, c.name) << i;
    ASSERT_EQ(a.samplers.size(), c.samplers.size()) << i;
    for (std::size_t s = 0; s < a.samplers.size(); ++s) {
      EXPECT_EQ(index_of(a.samplers[s].input), c.samplers[s].input) << i;
      EXPECT_EQ(index_of(a.samplers[s].output), c.samplers[s].output) << i;
      EXPECT_EQ(a.samplers[s].interpolation, c.samplers[s].interpolation) << i;
    }
    std::erase_if(c.channels, [](const auto& channel) { return channel.node == kNone; });  // tinygltf drops them, too
    ASSERT_EQ(a.channels.size(), c.channels.size()) << i;
    for (std::size_t k = 0; k < a.channels.size(); ++k) {
      EXPECT_EQ(index_of(a.channels[k].sampler), c.channels[k].sampler) << i;
      EXPECT_EQ(index_of(a.channels[k].target_node), c.channels[k].node) << i;
      EXPECT_EQ(a.channels[k].target_path, c.channels[k].path) << i;
    }
  }
}

void expect_same(const tinygltf::Model& alone, const gltf::Document& checked) {
  EXPECT_EQ(alone.asset.generator, checked.asset.generator);
  EXPECT_EQ(alone.asset.copyright, checked.asset.copyright);
  EXPECT_EQ(alone.asset.version, checked.asset.version);
  EXPECT_EQ(alone.asset.minVersion, checked.asset.minVersion);
  EXPECT_EQ(alone.extensionsUsed, checked.extensions_used);
  EXPECT_EQ(alone.extensionsRequired, checked.extensions_required);
  EXPECT_EQ(index_of(alone.defaultScene), checked.scene);
  EXPECT_EQ(alone.buffers.size(), checked.buffers.size());
  EXPECT_EQ(alone.images.size(), checked.images.size());
  expect_same("mesh", alone.meshes, checked.meshes);
  expect_same("node", alone.nodes, checked.nodes);
  expect_same("skin", alone.skins, checked.skins);
  expect_same("texture", alone.textures, checked.textures);
  expect_same("sampler", alone.samplers, checked.samplers);
  expect_same("camera", alone.cameras, checked.cameras);
  expect_same("scene", alone.scenes, checked.scenes);
  expect_same(alone.animations, checked.animations);
  expect_same(alone.bufferViews, checked.buffer_views);
  expect_same(alone.accessors, checked.accessors);
  expect_same(alone.materials, checked.materials);
}

std::vector<std::byte> bytes_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto bytes = bytes_of(text);
  return {bytes.begin(), bytes.end()};
}

TEST(tinygltf_view, of_every_model_is_that_of_the_importer) {
  std::size_t compared = 0, refused = 0;
  for (const fs::path& path : files_for_tests("models", {".gltf", ".glb"})) {
    SCOPED_TRACE(path.string());
    const auto bytes = bytes_in(path);
    if (const auto alone = read_alone(bytes, path.parent_path().string())) {
      expect_same(*alone, read_checked(bytes));
      ++compared;
    } else {
      // The importer reads some files that tinygltf refuses: indices without bytes, empty buffers.
      ++refused;
    }
  }
  EXPECT_GT(compared, 4 * refused);
}

TEST(tinygltf_view, of_what_both_writers_write_is_that_of_the_importer) {
  RewriteOptions options;
  options.drop = {"image-missing"};
  std::size_t exported = 0, rewritten = 0;
  for (const fs::path& path : files_for_tests("models", {".gltf", ".glb"})) {
    SCOPED_TRACE(path.string());
    const auto file = import_gltf(path, carrying());
    if (!file) continue;  // import_corpus_test checks refusals
    if (const auto glb = export_glb(file->scene))
      if (const auto alone = read_alone(*glb, "")) {
        expect_same(*alone, read_checked(*glb));
        ++exported;
      }
    const auto again = rewrite_gltf(*file, options);
    ASSERT_TRUE(again);
    if (const auto alone = read_alone(again->file, "")) {
      expect_same(*alone, read_checked(again->file));
      ++rewritten;
    }
  }
  EXPECT_GT(exported, 0u);
  EXPECT_GT(rewritten, 0u);
}

TEST(tinygltf_view, each_part_of_a_sparse_accessor_has_its_own_view_and_offset) {
  const std::string text = R"({"asset": {"version": "2.0"}, "accessors": [{"componentType": 5123, "count": 9,
    "type": "VEC2", "bufferView": 1, "byteOffset": 2, "normalized": true, "sparse": {"count": 3,
      "indices": {"bufferView": 4, "byteOffset": 5, "componentType": 5121},
      "values": {"bufferView": 6, "byteOffset": 7}}}]})";
  const gltf::Accessor accessor = read_checked(bytes_of(text)).accessors.at(0);
  EXPECT_EQ(accessor.buffer_view, 1u);
  EXPECT_EQ(accessor.byte_offset, 2u);
  EXPECT_EQ(accessor.count, 9u);
  EXPECT_TRUE(accessor.normalized);
  EXPECT_EQ(accessor.sparse.count, 3u);
  EXPECT_EQ(accessor.sparse.indices_view, 4u);
  EXPECT_EQ(accessor.sparse.indices_offset, 5u);
  EXPECT_EQ(accessor.sparse.index_type, gltf::ComponentType::u8);
  EXPECT_EQ(accessor.sparse.values_view, 6u);
  EXPECT_EQ(accessor.sparse.values_offset, 7u);
}

/// Cases that tinygltf alone reads differently from the file, and the importer reads correctly.
TEST(tinygltf_view, differs_where_tinygltf_loses_what_the_file_says) {
  const std::string text = R"({"asset": {"version": "2.0"},
    "nodes": [{"name": "first", "name": "last", "mesh": 0.0, "children": [1.0]},
              {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scale": [2, 2, 2],
               "extensions": {"X": {"big": 4294967297, "list": [null, {}]}}}],
    "meshes": [{"primitives": [{"attributes": {"a\u0000b": 1e0}, "mode": 1.0}],
                "extras": {"targetNames": ["a", null, "c"]}}],
    "accessors": [{"componentType": 5126, "count": 1, "type": "VEC3"},
                  {"componentType": 5126, "count": 1, "type": "VEC3"}],
    "animations": [{"samplers": [{"input": 0, "output": 1}],
                    "channels": [{"sampler": 0, "target": {"path": "translation"}},
                                 {"sampler": 0, "target": {"path": "pointer", "extensions":
                                   {"KHR_animation_pointer": {"pointer": "/nodes/0/scale"}}}}]}],
    "cameras": [{"type": "orthographic", "name": "no lens"}]})";
  const gltf::Document document = read_checked(bytes_of(text));
  const gltf::Node& node = document.nodes[0];
  EXPECT_EQ(node.name, "last");
  EXPECT_EQ(node.mesh, 0);
  EXPECT_EQ(node.children, std::vector<int>{1});
  EXPECT_TRUE(!document.nodes[1].matrix.empty() && document.nodes[1].has_trs);
  EXPECT_EQ(document.nodes[1].extensions, Json::parse(R"({"X": {"big": 4294967297, "list": [null, {}]}})"));
  EXPECT_TRUE(document.nodes[0].extensions.is_null());
  EXPECT_EQ(document.meshes[0].primitives[0].mode, TINYGLTF_MODE_LINE);
  EXPECT_TRUE(document.meshes[0].primitives[0].attributes.contains(std::string("a\0b", 3)));
  EXPECT_TRUE(static_cast<const tinygltf::Mesh&>(document.meshes[0]).primitives.empty()) << "they are not kept twice";
  EXPECT_EQ(document.meshes[0].target_names, (std::vector<std::string>{"a", "", "c"}));
  const gltf::Animation& animation = document.animations[0];
  ASSERT_EQ(animation.channels.size(), 2u);
  EXPECT_EQ(animation.channels[0].node, kNone);
  EXPECT_EQ(animation.channels[1].pointer, "/nodes/0/scale");
  EXPECT_EQ(document.cameras[0].name, "no lens");

  EXPECT_FALSE(read_alone(bytes_of(text), ""));
}

}  // namespace
}  // namespace sinew::test
