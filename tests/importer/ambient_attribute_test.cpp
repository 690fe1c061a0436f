// SPDX-License-Identifier: MIT
#include "importer/ambient/ambient_attribute.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/importer/rewritten.h"

namespace sinew::test {
namespace {

/// A square of two triangles without normals. The importer makes flat normals and so splits vertices 0 and 2.
TinyGltf bent_square() {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  primitive["attributes"]["POSITION"] = gltf.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1});
  primitive["indices"] = gltf.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  return gltf;
}

/// The bent square with two clips that move it, of two and of three seconds.
TinyGltf bent_square_with_clips() {
  TinyGltf gltf = bent_square();
  Json clips = Json::array();
  for (const float duration : {2.0f, 3.0f}) {
    gltf.animate("translation", gltf.times({0, duration}), gltf.vec3({0, 0, 0, 1, 0, 0}));
    clips.push_back(gltf.root["animations"][0]);
  }
  gltf.root["animations"] = clips;
  return gltf;
}

const Primitive& primitive_of(const ImportedFile& file) { return file.scene.meshes[0].primitives[0]; }

TEST(ambient_attribute, values_of_vertices_that_were_split_become_their_mean) {
  const auto file = bent_square().import(carrying());
  ASSERT_TRUE(file);
  ASSERT_EQ(primitive_of(*file).vertex_count(), 6u);
  std::vector<float> visibility;
  for (std::size_t v = 0; v < 6; ++v) visibility.push_back(0.125f * static_cast<float>(v));
  VertexVisibility baked;
  baked.values = {{visibility}};
  const auto attributes = ambient_attributes(file->scene, baked);
  ASSERT_EQ(attributes.size(), 1u);
  EXPECT_EQ(attributes[0].name, "_AMBIENT_ACCESS");
  ASSERT_EQ(attributes[0].values.size(), 4u);
  std::vector<float> sums(4), counts(4);
  for (std::size_t v = 0; v < 6; ++v) {
    sums[primitive_of(*file).source_vertex[v]] += visibility[v];
    counts[primitive_of(*file).source_vertex[v]] += 1.0f;
  }
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(attributes[0].values[v], sums[v] / counts[v]) << v;
  EXPECT_EQ(counts[0], 2.0f);
  baked.values = {{{}}};
  EXPECT_TRUE(ambient_attributes(file->scene, baked).empty());
}

TEST(ambient_attribute, is_written_beside_the_others_and_read_again) {
  const TinyGltf gltf = bent_square();
  const auto file = gltf.import(carrying());
  ASSERT_TRUE(file);
  const std::vector<AddedAttribute> added = {{0, 0, kAmbientVisibilityAttribute, {0.0f, 0.25f, 0.7f, 1.0f}}};
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
  const VertexVisibility visibility = read_ambient_visibility(*again, issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(visibility.times_s, std::vector<double>{0.0});
  EXPECT_EQ(visibility.clip, kNone);
  const Primitive& primitive = primitive_of(*again);
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v)
    EXPECT_EQ(visibility.values[0][0][v], added[0].values[primitive.source_vertex[v]]) << v;
}

TEST(ambient_attribute, an_older_one_is_replaced_and_leaves_nothing_behind) {
  const auto file = bent_square().import(carrying());
  const std::vector<AddedAttribute> first = {{0, 0, kAmbientVisibilityAttribute, {0.0f, 0.0f, 0.0f, 0.0f}}},
                                    second = {{0, 0, kAmbientVisibilityAttribute, {0.5f, 0.5f, 0.5f, 0.5f}}};
  const auto once = rewrite_gltf(*file, {.added_attributes = first});
  const auto twice = rewrite_gltf(*import_gltf(once->file, "once.glb", carrying()), {.added_attributes = second});
  const auto direct = rewrite_gltf(*file, {.added_attributes = second});
  ASSERT_TRUE(twice && direct);
  EXPECT_EQ(twice->file.size(), direct->file.size());
  std::vector<ImportIssue> issues;
  const auto read = read_ambient_visibility(*import_gltf(twice->file, "twice.glb", carrying()), issues);
  EXPECT_EQ(read.values[0][0], std::vector<float>(6, 0.5f));
}

TEST(ambient_attribute, attributes_other_than_a_fraction_per_vertex_are_ignored_with_a_warning) {
  const auto issue_of = [](const auto& add) {
    TinyGltf gltf = bent_square();
    Json& attribute = gltf.root["meshes"][0]["primitives"][0]["attributes"]["_AMBIENT_ACCESS"];
    attribute = add(gltf);
    const auto file = gltf.import(carrying());
    std::vector<ImportIssue> issues;
    EXPECT_TRUE(read_ambient_visibility(*file, issues).values[0][0].empty());
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
  const auto visibility = read_ambient_visibility(*file, issues);
  EXPECT_TRUE(issues.empty());
  const std::vector<float> values = {0.0f, 1.0f, 0.2f, 1.0f};
  for (std::size_t v = 0; v < 6; ++v)
    EXPECT_EQ(visibility.values[0][0][v], values[primitive_of(*file).source_vertex[v]]);
}

TEST(ambient_attribute, key_poses_have_an_attribute_each_and_come_back_in_their_order) {
  const auto file = bent_square_with_clips().import(carrying());
  ASSERT_TRUE(file);
  VertexVisibility baked;
  baked.clip = 1;
  baked.times_s = {0.0, 1.5, 3.0};
  std::vector<float> values;
  for (const float pose : {0.0f, 0.25f, 0.5f})
    for (std::size_t v = 0; v < 6; ++v) values.push_back(pose + 0.05f * float(primitive_of(*file).source_vertex[v]));
  baked.values = {{values}};
  const auto attributes = ambient_attributes(file->scene, baked);
  ASSERT_EQ(attributes.size(), 3u);
  EXPECT_EQ(attributes[2].name, "_AMBIENT_ACCESS_1_2");
  const auto out = rewrite_gltf(*file, {.added_attributes = attributes});
  ASSERT_TRUE(out);
  std::vector<ImportIssue> issues;
  const auto again = import_gltf(out->file, "out.glb", carrying());
  const VertexVisibility visibility = read_ambient_visibility(*again, issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(visibility.clip, 1u);
  EXPECT_EQ(visibility.times_s, baked.times_s) << "spread over the clip";
  EXPECT_EQ(visibility.values, baked.values);
  EXPECT_EQ(ambient_attribute_names(*again),
            (std::vector<std::string>{"_AMBIENT_ACCESS_1_0", "_AMBIENT_ACCESS_1_1", "_AMBIENT_ACCESS_1_2"}));
  const auto without = rewrite_gltf(*again, {.left_out_attributes = ambient_attribute_names(*again)});
  ASSERT_TRUE(without);
  EXPECT_EQ(without->file, rewrite_gltf(*file)->file) << "nothing stays behind";
}

TEST(ambient_attribute, names_of_key_poses_are_read_only_as_they_are_written) {
  for (const KeyPoseName key : {KeyPoseName{0, 0}, {2, 5}, {12, 63}, {4294967294u, 10}}) {
    const auto read = key_pose_named(name_of_key_pose(key));
    ASSERT_TRUE(read) << name_of_key_pose(key);
    EXPECT_EQ(read->clip, key.clip);
    EXPECT_EQ(read->pose, key.pose);
  }
  for (const char* other :
       {"_AMBIENT_ACCESS", "_AMBIENT_ACCESS_", "_AMBIENT_ACCESS_1", "_AMBIENT_ACCESS_1_", "_AMBIENT_ACCESS_01_2",
        "_AMBIENT_ACCESS_1_02", "_AMBIENT_ACCESS_1_64", "_AMBIENT_ACCESS_1_2_3", "_AMBIENT_ACCESS_1x2",
        "_AMBIENT_ACCESS_-1_2", "_AMBIENT_ACCESS_1_ 2", "_AMBIENT_ACCESS__2", "_AMBIENT_ACCESS_4294967296_0",
        "_AMBIENT_ACCESX_1_2", "COLOR_1_2"})
    EXPECT_FALSE(key_pose_named(other)) << other;
}

/// Visibility that the importer reads from the bent square with these vertex attributes. Each attribute has one value
/// at all four vertices.
VertexVisibility visibility_with(const std::vector<std::pair<std::string, float>>& attributes,
                                 std::vector<ImportIssue>* issues_out = nullptr) {
  TinyGltf gltf = bent_square_with_clips();
  for (const auto& [name, value] : attributes)
    gltf.root["meshes"][0]["primitives"][0]["attributes"][name] = gltf.scalars({value, value, value, value});
  const auto file = gltf.import(carrying());
  std::vector<ImportIssue> issues;
  VertexVisibility visibility = read_ambient_visibility(file.value(), issues);
  EXPECT_EQ(issues.empty(), issues_out == nullptr);
  if (issues_out) *issues_out = std::move(issues);
  return visibility;
}

TEST(ambient_attribute, of_several_clips_the_first_has_its_key_poses) {
  const VertexVisibility visibility = visibility_with({{"_AMBIENT_ACCESS", 0.9f},
                                                       {"_AMBIENT_ACCESS_0_0", 0.1f},
                                                       {"_AMBIENT_ACCESS_0_1", 0.2f},
                                                       {"_AMBIENT_ACCESS_1_0", 0.3f},
                                                       {"_AMBIENT_ACCESS_1_1", 0.4f},
                                                       {"_AMBIENT_ACCESS_1_2", 0.5f}});
  EXPECT_EQ(visibility.clip, 0u);
  EXPECT_EQ(visibility.times_s, (std::vector<double>{0.0, 2.0}));
  std::vector<float> values(6, 0.1f);
  values.insert(values.end(), 6, 0.2f);
  EXPECT_EQ(visibility.values[0][0], values);
}

TEST(ambient_attribute, a_primitive_without_key_poses_keeps_its_one_pose_beside_them) {
  TinyGltf gltf = bent_square_with_clips();
  Json& primitives = gltf.root["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[0]["attributes"]["_AMBIENT_ACCESS"] = gltf.scalars({0.5f, 0.5f, 0.5f, 0.5f});
  for (const char* name : {"_AMBIENT_ACCESS_1_0", "_AMBIENT_ACCESS_1_1"})
    primitives[1]["attributes"][name] = gltf.scalars({0.25f, 0.25f, 0.25f, 0.25f});
  std::vector<ImportIssue> issues;
  const auto file = gltf.import(carrying());
  const VertexVisibility visibility = read_ambient_visibility(*file, issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(visibility.values[0][0], std::vector<float>(12, 0.5f));
  EXPECT_EQ(visibility.values[0][1], std::vector<float>(12, 0.25f));
}

TEST(ambient_attribute, key_poses_that_are_missing_or_of_no_clip_are_warnings) {
  std::vector<ImportIssue> issues;
  const VertexVisibility gap = visibility_with({{"_AMBIENT_ACCESS_1_0", 0.1f}, {"_AMBIENT_ACCESS_1_2", 0.3f}}, &issues);
  EXPECT_EQ(gap.times_s.size(), 3u);
  EXPECT_TRUE(gap.values[0][0].empty());
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].rule, "mesh-attribute-count");
  EXPECT_EQ(issues[0].json_pointer, "/meshes/0/primitives/0/attributes");
  EXPECT_EQ(issues[0].detail, "key poses of ambient visibility without _AMBIENT_ACCESS_1_1; ignored");

  const VertexVisibility strange = visibility_with(
      {{"_AMBIENT_ACCESS", 0.5f}, {"_AMBIENT_ACCESS_2_0", 0.1f}, {"_AMBIENT_ACCESS_2_1", 0.3f}}, &issues);
  EXPECT_EQ(strange.clip, kNone);
  EXPECT_EQ(strange.times_s, std::vector<double>{0.0});
  EXPECT_EQ(strange.values[0][0], std::vector<float>(6, 0.5f));
  ASSERT_EQ(issues.size(), 1u) << "one for the animation";
  EXPECT_EQ(issues[0].rule, "mesh-attribute-format");
  EXPECT_EQ(issues[0].json_pointer, "/meshes/0/primitives/0/attributes/_AMBIENT_ACCESS_2_0");
  EXPECT_EQ(issues[0].detail, "ambient visibility of animation 2, and there are 2; ignored");
}

TEST(ambient_attribute, a_clip_that_lasts_no_time_has_its_first_pose) {
  TinyGltf gltf = bent_square();
  gltf.animate("translation", gltf.times({0}), gltf.vec3({1, 0, 0}));
  for (const char* name : {"_AMBIENT_ACCESS_0_0", "_AMBIENT_ACCESS_0_1"})
    gltf.root["meshes"][0]["primitives"][0]["attributes"][name] = gltf.scalars({0.5f, 0.5f, 0.5f, 0.5f});
  const auto file = gltf.import(carrying());
  ASSERT_TRUE(file);
  std::vector<ImportIssue> issues;
  const VertexVisibility visibility = read_ambient_visibility(*file, issues);
  EXPECT_EQ(visibility.times_s, std::vector<double>{0.0});
  EXPECT_EQ(visibility.values[0][0], std::vector<float>(6, 0.5f));
}

}  // namespace
}  // namespace sinew::test
