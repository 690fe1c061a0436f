// SPDX-License-Identifier: MIT
#include "importer/ambient/ambient_attribute.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/importer/rewritten.h"

namespace sinew::test {
namespace {

/// A square of two triangles without normals: the importer makes them flat and splits vertices 0 and 2.
TinyGltf bent_square() {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  primitive["attributes"]["POSITION"] = gltf.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1});
  primitive["indices"] = gltf.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  return gltf;
}

const Primitive& primitive_of(const ImportedFile& file) { return file.scene.meshes[0].primitives[0]; }

TEST(ambient_attribute, values_of_vertices_that_were_split_become_their_mean) {
  const auto file = bent_square().import(carrying());
  ASSERT_TRUE(file);
  ASSERT_EQ(primitive_of(*file).vertex_count(), 6u);
  std::vector<float> access;
  for (std::size_t v = 0; v < 6; ++v) access.push_back(0.125f * static_cast<float>(v));
  const auto attributes = ambient_attributes(file->scene, {{access}});
  ASSERT_EQ(attributes.size(), 1u);
  EXPECT_EQ(attributes[0].name, "_AMBIENT_ACCESS");
  ASSERT_EQ(attributes[0].values.size(), 4u);
  std::vector<float> sums(4), counts(4);
  for (std::size_t v = 0; v < 6; ++v) {
    sums[primitive_of(*file).source_vertex[v]] += access[v];
    counts[primitive_of(*file).source_vertex[v]] += 1.0f;
  }
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(attributes[0].values[v], sums[v] / counts[v]) << v;
  EXPECT_EQ(counts[0], 2.0f);
  EXPECT_TRUE(ambient_attributes(file->scene, {{{}}}).empty());
}

TEST(ambient_attribute, is_written_beside_the_others_and_read_again) {
  const TinyGltf gltf = bent_square();
  const auto file = gltf.import(carrying());
  ASSERT_TRUE(file);
  const std::vector<AddedAttribute> added = {{0, 0, kAmbientAccessAttribute, {0.0f, 0.25f, 0.7f, 1.0f}}};
  const auto out = rewrite_gltf(*file, {.added_attributes = added});
  ASSERT_TRUE(out);
  const GlbParts parts = split_glb(out->file);
  const Json& attributes = parts.json["meshes"][0]["primitives"][0]["attributes"];
  const Json& accessor = parts.json["accessors"][attributes["_AMBIENT_ACCESS"].get<std::size_t>()];
  EXPECT_EQ(attributes["POSITION"], gltf.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"]);
  EXPECT_EQ(accessor["type"], "SCALAR");
  EXPECT_EQ(accessor["componentType"], 5126);
  EXPECT_EQ(parts.json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["target"], 34962);
  const auto again = import_gltf(out->file, "out.glb", carrying());
  ASSERT_TRUE(again);
  std::vector<ImportIssue> issues;
  const MeshAccess access = read_ambient_access(*again, issues);
  EXPECT_TRUE(issues.empty());
  const Primitive& primitive = primitive_of(*again);
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v)
    EXPECT_EQ(access[0][0][v], added[0].values[primitive.source_vertex[v]]) << v;
}

TEST(ambient_attribute, an_older_one_is_replaced_and_leaves_nothing_behind) {
  const auto file = bent_square().import(carrying());
  const std::vector<AddedAttribute> first = {{0, 0, kAmbientAccessAttribute, {0.0f, 0.0f, 0.0f, 0.0f}}},
                                    second = {{0, 0, kAmbientAccessAttribute, {0.5f, 0.5f, 0.5f, 0.5f}}};
  const auto once = rewrite_gltf(*file, {.added_attributes = first});
  const auto twice = rewrite_gltf(*import_gltf(once->file, "once.glb", carrying()), {.added_attributes = second});
  const auto direct = rewrite_gltf(*file, {.added_attributes = second});
  ASSERT_TRUE(twice && direct);
  EXPECT_EQ(twice->file.size(), direct->file.size());
  std::vector<ImportIssue> issues;
  const auto read = read_ambient_access(*import_gltf(twice->file, "twice.glb", carrying()), issues);
  EXPECT_EQ(read[0][0], std::vector<float>(6, 0.5f));
}

TEST(ambient_attribute, what_is_no_fraction_for_each_vertex_is_a_warning_and_taken_as_absent) {
  const auto issue_of = [](const auto& add) {
    TinyGltf gltf = bent_square();
    Json& attribute = gltf.root["meshes"][0]["primitives"][0]["attributes"]["_AMBIENT_ACCESS"];
    attribute = add(gltf);
    const auto file = gltf.import(carrying());
    std::vector<ImportIssue> issues;
    EXPECT_TRUE(read_ambient_access(*file, issues)[0][0].empty());
    EXPECT_EQ(issues.size(), 1u);
    EXPECT_EQ(issues.at(0).json_pointer, "/meshes/0/primitives/0/attributes/_AMBIENT_ACCESS");
    EXPECT_EQ(issues.at(0).severity, Severity::warning);
    return issues.at(0).rule;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(issue_of([](TinyGltf& g) {
              return g.vec3({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
            }),
            "mesh-attribute-format");
  EXPECT_EQ(issue_of([](TinyGltf& g) { return g.scalars({1, 1, 1}); }), "mesh-attribute-count");
  EXPECT_EQ(issue_of([](TinyGltf& g) { return g.scalars({1, 1, 1, 1.5f}); }), "mesh-attribute-format");
  EXPECT_EQ(issue_of([](TinyGltf& g) { return g.scalars({1, 1, kNan, 1}); }), "mesh-attribute-format");
}

TEST(ambient_attribute, normalised_integers_of_other_programs_are_read) {
  TinyGltf gltf = bent_square();
  gltf.root["meshes"][0]["primitives"][0]["attributes"]["_AMBIENT_ACCESS"] =
      gltf.add<std::uint8_t>({0, 255, 51, 255}, "SCALAR", 5121, 1, true);
  std::vector<ImportIssue> issues;
  const auto file = gltf.import(carrying());
  const auto access = read_ambient_access(*file, issues);
  EXPECT_TRUE(issues.empty());
  const std::vector<float> values = {0.0f, 1.0f, 0.2f, 1.0f};
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(access[0][0][v], values[primitive_of(*file).source_vertex[v]]);
}

}  // namespace
}  // namespace sinew::test
