// SPDX-License-Identifier: MIT
// Files rewritten with `quantize` and `meshopt`: drawn triangles are equal, exactly or within the kept precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "importer/rewrite/streams.h"
#include "tests/importer/recoded.h"
#include "tests/support/corpus.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr std::size_t kSide = 24;

/// A bumpy grid of squares with unshared corners, skinned and coloured. It has three morph targets. One moves a few
/// vertices, one moves none, and one is stored dense and also changes normals and tangents.
TinyGltf grid() {
  TinyGltf gltf;
  FixedRandom random(7);
  std::vector<float> positions, normals, tangents, texcoords, colors, weights, dense, turned;
  std::vector<std::uint16_t> joints;
  const auto add = [&](std::size_t x, std::size_t y) {
    const float u = static_cast<float>(x) / kSide, v = static_cast<float>(y) / kSide;
    positions.insert(positions.end(), {u, v, 0.25f * std::sin(6.0f * u) * std::cos(5.0f * v)});
    const float length = std::sqrt(u * u + v * v + 1.0f);
    normals.insert(normals.end(), {u / length, v / length, 1.0f / length});
    tangents.insert(tangents.end(), {std::cos(u + 2.0f * v), 0.0f, std::sin(u + 2.0f * v), u < v ? 1.0f : -1.0f});
    texcoords.insert(texcoords.end(), {u, 1.0f - v});
    colors.insert(colors.end(), {u, v, 0.5f, 1.0f});
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1.0f - u, u, 0.0f, 0.0f});
    dense.insert(dense.end(), {0.1f * v, 0.0f, 0.1f * u});
    turned.insert(turned.end(), {0.0f, 0.2f * u, 0.1f * v});
  };
  for (std::size_t y = 0; y < kSide; ++y)
    for (std::size_t x = 0; x < kSide; ++x)
      for (const auto& [i, j] :
           std::array<std::array<std::size_t, 2>, 6>{{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}})
        add(x + i, y + j);
  const std::size_t count = positions.size() / 3;
  Json attributes{{"POSITION", gltf.vec3(positions)}, {"NORMAL", gltf.vec3(normals)},
                  {"TANGENT", gltf.vec4(tangents)},   {"TEXCOORD_0", gltf.add(texcoords, "VEC2", 5126, 2)},
                  {"COLOR_0", gltf.vec4(colors)},     {"JOINTS_0", gltf.add(joints, "VEC4", 5123, 4)},
                  {"WEIGHTS_0", gltf.vec4(weights)}};
  Json& accessors = gltf.root["accessors"];
  accessors[0]["min"] = {0, 0, -1};
  accessors[0]["max"] = {1, 1, 1};
  accessors.push_back({{"componentType", 5126}, {"count", count}, {"type", "VEC3"}});
  const std::size_t zeros = accessors.size() - 1;
  accessors.push_back(
      {{"componentType", 5126},
       {"count", count},
       {"type", "VEC3"},
       {"sparse",
        {{"count", 2},
         {"indices", {{"bufferView", gltf.add_view(std::vector<std::uint16_t>{3, 700})}, {"componentType", 5123}}},
         {"values", {{"bufferView", gltf.add_view(std::vector<float>{1, 2, 3, 4, 5, 6})}}}}}});
  const std::size_t sparse = accessors.size() - 1;
  const std::size_t moved = gltf.vec3(dense), bent = gltf.vec3(turned), along = gltf.vec3(dense);
  const Json targets{
      {{"POSITION", zeros}}, {{"POSITION", sparse}}, {{"POSITION", moved}, {"NORMAL", bent}, {"TANGENT", along}}};
  gltf.root["meshes"] =
      Json::array({{{"primitives", Json::array({{{"attributes", attributes}, {"targets", targets}}})}}});
  gltf.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, Json::object()});
  gltf.root["skins"] = Json::array({{{"joints", {1, 2}}}});
  std::vector<float> times, rotations, translations;
  for (int k = 0; k < 40; ++k) {
    const float angle = 0.05f * static_cast<float>(k);
    times.push_back(static_cast<float>(k) / 30.0f);
    rotations.insert(rotations.end(), {0.0f, std::sin(angle), 0.0f, std::cos(angle)});
    translations.insert(translations.end(), {angle, static_cast<float>(random.in(-1.0, 1.0)), 2.0f});
  }
  const std::size_t input = gltf.times(times);
  gltf.animate("rotation", input, gltf.vec4(rotations));
  gltf.root["animations"][0]["samplers"].push_back({{"input", input}, {"output", gltf.vec3(translations)}});
  gltf.root["animations"][0]["channels"].push_back(
      {{"sampler", 1}, {"target", {{"node", 1}, {"path", "translation"}}}});
  gltf.root["animations"][0]["channels"][0]["target"]["node"] = 2;
  return gltf;
}

/// All attributes of one triangle corner as numbers.
using Corner = std::vector<float>;

/// The triangles of a primitive, sorted, so that vertex numbering does not matter.
std::vector<std::array<Corner, 3>> triangles(const Primitive& p) {
  std::vector<Corner> corners(p.vertex_count());
  const auto add = [&](const auto& values) {
    for (std::size_t v = 0; v < values.size(); ++v)
      for (int c = 0; c < values[v].length(); ++c) corners[v].push_back(values[v][c]);
  };
  add(p.positions);
  add(p.normals);
  add(p.tangents);
  for (const auto& set : p.texcoords) add(set);
  add(p.colors);
  for (const MorphTarget& target : p.morphs.targets)
    for (const auto* sparse : {&target.positions, &target.normals, &target.tangents}) {
      std::vector<glm::vec3> deltas(p.vertex_count(), glm::vec3(0.0f));
      for (std::size_t i = 0; i < sparse->vertices.size(); ++i) deltas[sparse->vertices[i]] = sparse->deltas[i];
      add(deltas);
    }
  for (const InfluenceGroup& group : p.influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; ++v) {
      std::array<float, 8> weights{};
      for (std::uint32_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + std::size_t{v} * group.influence_count + i;
        weights.at(p.influences.joints[at]) = p.influences.weights[at];
      }
      corners[group.first_vertex + v].insert(corners[group.first_vertex + v].end(), weights.begin(), weights.end());
    }
  std::vector<std::array<Corner, 3>> out;
  for (std::size_t i = 0; i + 2 < p.indices.size(); i += 3) {
    std::array<Corner, 3> t{corners[p.indices[i]], corners[p.indices[i + 1]], corners[p.indices[i + 2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    out.push_back(std::move(t));
  }
  std::sort(out.begin(), out.end());
  return out;
}

TEST(rewrite_streams, meshopt_alone_draws_the_same_bits_from_fewer_vertices) {
  const Both out = recoded(grid(), how(false, true));
  EXPECT_TRUE(triangles(first(out.before)) == triangles(first(out.after)));
  EXPECT_LE(first(out.after).vertex_count(), (kSide + 1) * (kSide + 1) + 2) << "two are moved by the sparse target";
  const Animation &a = out.before.scene.animations[0], &b = out.after.scene.animations[0];
  EXPECT_EQ(a.bones[1].rotation.values, b.bones[1].rotation.values);
  EXPECT_EQ(a.bones[0].translation.values, b.bones[0].translation.values);
  EXPECT_EQ(out.parts.json["extensionsRequired"], Json::array({"EXT_meshopt_compression"}));
  EXPECT_EQ(out.parts.json["buffers"].size(), 2u);
  EXPECT_LT(out.bytes, rewrite(grid())->file.size() / 4);
}

float angle(const glm::vec3& a, const glm::vec3& b) { return glm::length(glm::normalize(a) - glm::normalize(b)); }

/// Compares two primitives vertex by vertex. `position` is the tolerance of positions.
void expect_close(const Primitive& a, const Primitive& b, float position) {
  ASSERT_EQ(a.indices.size(), b.indices.size());
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < b.vertex_count(); ++k)
      if (glm::distance(b.positions[k], a.positions[i]) < glm::distance(b.positions[nearest], a.positions[i]))
        nearest = k;
    EXPECT_LE(glm::distance(b.positions[nearest], a.positions[i]), position);
    EXPECT_LE(angle(a.normals[i], b.normals[nearest]), 0.02f);
    EXPECT_LE(angle(glm::vec3(a.tangents[i]), glm::vec3(b.tangents[nearest])), 0.02f);
    EXPECT_EQ(a.tangents[i].w, b.tangents[nearest].w);
    EXPECT_LE(glm::distance(a.texcoords[0][i], b.texcoords[0][nearest]), 1.6f / 8190.0f);
    EXPECT_LE(glm::distance(a.colors[i], b.colors[nearest]), 1.0f / 255.0f);
  }
}

TEST(rewrite_streams, G17_quantised_numbers_stay_within_half_a_step) {
  for (const bool meshopt : {false, true}) {
    SCOPED_TRACE(meshopt);
    const Both out = recoded(grid(), how(true, meshopt));
    expect_close(first(out.before), first(out.after), meshopt ? 1e-4f : 0.0f);
    for (const ImportIssue& warning : out.after.warnings) EXPECT_NE(warning.rule, "weights-sum") << warning.detail;
    const auto& a = out.before.scene.animations[0].bones[1].rotation.values;
    const auto& b = out.after.scene.animations[0].bones[1].rotation.values;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_GT(std::abs(glm::dot(a[k], b[k])), 1.0f - 1e-6f);
    EXPECT_LT(out.bytes, rewrite(grid())->file.size());
  }
}

/// The grid without its sparse target. A sparse target would prevent merging of vertices.
TinyGltf grid_without_sparse() {
  TinyGltf gltf = grid();
  gltf.root["meshes"][0]["primitives"][0]["targets"].erase(1);
  return gltf;
}

/// The grid with min and max also where glTF does not demand them.
TinyGltf bounded_grid() {
  TinyGltf gltf = grid();
  const Json& attributes = gltf.root["meshes"][0]["primitives"][0]["attributes"];
  Json& normals = gltf.root["accessors"][attributes["NORMAL"].get<std::size_t>()];
  normals["min"] = {-1, -1, -1};
  normals["max"] = {1, 1, 1};
  return gltf;
}

TEST(rewrite_streams, each_stream_takes_the_small_integers_and_the_filter_that_are_made_for_it) {
  const std::map<std::string, std::string> plain = {
      {"POSITION", "5126 bounds"},       {"NORMAL", "5120 normalized bounds"}, {"TANGENT", "5120 normalized"},
      {"TEXCOORD_0", "5123 normalized"}, {"COLOR_0", "5121 normalized"},       {"JOINTS_0", "5121"},
      {"WEIGHTS_0", "5123 normalized"},  {"rotation", "5122 normalized"},      {"translation", "5126"}};
  const std::map<std::string, std::string> compressed = {
      {"POSITION", "5126 bounds EXPONENTIAL"},   {"NORMAL", "5120 normalized OCTAHEDRAL"},
      {"TANGENT", "5120 normalized OCTAHEDRAL"}, {"TEXCOORD_0", "5123 normalized NONE"},
      {"COLOR_0", "5121 normalized NONE"},       {"JOINTS_0", "5121 NONE"},
      {"WEIGHTS_0", "5123 normalized NONE"},     {"rotation", "5122 normalized QUATERNION"},
      {"translation", "5126 EXPONENTIAL"}};
  for (const bool meshopt : {false, true}) {
    const Both out = recoded(bounded_grid(), how(true, meshopt));
    const Json& json = out.parts.json;
    std::map<std::string, std::string> stored;
    for (const auto& [name, accessor] : json["meshes"][0]["primitives"][0]["attributes"].items())
      stored[name] = stored_as(json, accessor);
    for (const Json& channel : json["animations"][0]["channels"])
      stored[channel["target"]["path"]] =
          stored_as(json, json["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()]["output"]);
    EXPECT_EQ(stored, meshopt ? compressed : plain);
  }
}

TEST(rewrite_streams, rotations_that_are_colours_too_stay_floats) {
  TinyGltf gltf = grid();
  gltf.root["materials"] = Json::array({Json::object()});
  gltf.root["animations"][0]["channels"].push_back(
      {{"sampler", 0},
       {"target",
        {{"path", "pointer"},
         {"extensions",
          {{"KHR_animation_pointer", {{"pointer", "/materials/0/pbrMetallicRoughness/baseColorFactor"}}}}}}}});
  for (const bool meshopt : {false, true}) {
    const Json json = recoded(gltf, how(true, meshopt)).parts.json;
    EXPECT_EQ(stored_as(json, json["animations"][0]["samplers"][0]["output"]).substr(0, 4), "5126") << meshopt;
  }
}

TEST(rewrite_streams, quantised_vertices_that_are_equal_become_one_and_triangles_keep_their_order) {
  const Both out = recoded(grid_without_sparse(), how(true, false));
  const Primitive &a = first(out.before), &b = first(out.after);
  EXPECT_EQ(b.vertex_count(), (kSide + 1) * (kSide + 1));
  ASSERT_EQ(a.indices.size(), b.indices.size());
  for (std::size_t i = 0; i < a.indices.size(); ++i) EXPECT_EQ(a.positions[a.indices[i]], b.positions[b.indices[i]]);
  expect_close(a, b, 0.0f);
  EXPECT_EQ(out.parts.json["extensionsRequired"], Json::array({"KHR_mesh_quantization"}));
}

TEST(rewrite_streams, vertices_that_only_a_target_or_a_weight_tells_apart_stay) {
  TinyGltf gltf = grid_without_sparse();
  std::vector<float> dense(3 * (6 * kSide * kSide), 0.0f);
  dense[3 * 700] = 1.0f;  // moves one of the copies at this corner, so that they cannot be merged
  gltf.root["meshes"][0]["primitives"][0]["targets"][1]["POSITION"] = gltf.vec3(dense);
  EXPECT_EQ(first(recoded(gltf, how(true, false)).after).vertex_count(), (kSide + 1) * (kSide + 1) + 1);
}

TEST(rewrite_streams, vertices_that_no_triangle_uses_go) {
  TinyGltf gltf = grid_without_sparse();
  gltf.root["meshes"][0]["primitives"][0]["indices"] = gltf.add(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR", 5123, 1);
  const Both out = recoded(gltf, how(true, false));
  EXPECT_EQ(first(out.after).vertex_count(), 3u);
  const Primitive &a = first(out.before), &b = first(out.after);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(a.positions[a.indices[i]], b.positions[b.indices[i]]);
}

TEST(rewrite_streams, indices_that_would_take_more_than_they_save_are_not_made) {
  TinyGltf gltf;
  gltf.add_triangle();
  const Both out = recoded(gltf, how(true, false));
  EXPECT_FALSE(out.parts.json["meshes"][0]["primitives"][0].contains("indices"));
  EXPECT_EQ(first(out.before).positions, first(out.after).positions);
}

TEST(rewrite_streams, G15_bounds_are_those_of_the_rounded_positions) {
  const Both out = recoded(grid(), how(true, true));
  ImportOptions careful;
  careful.thorough = true;
  const auto again = import_gltf(rewrite(grid(), how(true, true))->file, "again.glb", careful);
  ASSERT_TRUE(again);
  for (const ImportIssue& warning : again->warnings) EXPECT_NE(warning.rule, "accessor-bounds") << warning.detail;
  TinyGltf with_max_alone = grid();
  with_max_alone.root["accessors"][0]["max"] = {9, 9, 9};
  with_max_alone.root["accessors"][0].erase("min");
  const Both other = recoded(with_max_alone, how(true, true));
  for (const char* bound : {"min", "max"})
    EXPECT_EQ(other.parts.json["accessors"][0][bound], out.parts.json["accessors"][0][bound]) << bound;
}

TEST(rewrite_streams, bounds_of_numbers_of_every_type_are_those_of_the_vertices_that_are_left) {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  const std::size_t position = gltf.vec3({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0}),
                    ids = gltf.add<std::uint32_t>({4000000000u, 7, 3000000000u, 9}, "SCALAR", 5125, 1);
  primitive["attributes"] = {{"POSITION", position}, {"_ID", ids}};
  primitive["indices"] = gltf.add(std::vector<std::uint16_t>{1, 2, 3}, "SCALAR", 5123, 1);
  for (const char* missing : {"neither", "min", "max"}) {
    gltf.root["accessors"][ids]["min"] = {7};
    gltf.root["accessors"][ids]["max"] = {4000000000u};
    gltf.root["accessors"][ids].erase(missing);
    const Json json = recoded(gltf, how(false, true)).parts.json;
    const Json& written = json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["_ID"].get<std::size_t>()];
    EXPECT_EQ(written["count"], 3);
    EXPECT_EQ(written["componentType"], 5125);
    EXPECT_EQ(written["min"][0].get<double>(), 7.0) << missing;
    EXPECT_EQ(written["max"][0].get<double>(), 3e9) << missing;
  }
}

TEST(rewrite_streams, accessors_have_a_stream_where_their_view_holds_all_elements) {
  const std::vector<std::byte> bytes(24);
  const auto has_stream = [&](std::size_t view_bytes, std::size_t offset, std::size_t count) {
    rewrite::Draft draft;
    draft.json = {
        {"accessors",
         {{{"bufferView", 0}, {"byteOffset", offset}, {"componentType", 5126}, {"count", count}, {"type", "SCALAR"}},
          {{"componentType", 5126}, {"count", count}, {"type", "SCALAR"}}}},
        {"bufferViews", {{{"buffer", 0}}}},
        {"animations", {{{"samplers", {{{"input", 0}, {"output", 1}}}}}}}};
    draft.blocks = {bytes};
    draft.parts = {{0, 0, view_bytes}};
    return rewrite::take_streams({}, draft, false).contains(0);
  };
  EXPECT_TRUE(has_stream(8, 0, 2));
  EXPECT_TRUE(has_stream(24, 8, 4));
  EXPECT_FALSE(has_stream(7, 0, 2));
  EXPECT_FALSE(has_stream(23, 8, 4));
  EXPECT_FALSE(has_stream(0, 0, 1));
  EXPECT_FALSE(has_stream(8, 0, 0));
}

TEST(rewrite_streams, streams_too_short_to_compress_are_plain_floats) {
  TinyGltf gltf;
  gltf.add_triangle();
  const Both out = recoded(gltf, how(true, true));
  EXPECT_FALSE(out.parts.json.contains("extensionsRequired"));
  ASSERT_EQ(first(out.after).vertex_count(), 3u);
  for (const glm::vec3& p : first(out.after).positions) EXPECT_LE(glm::length(p), 1.001f);
  EXPECT_EQ(first(out.after).bounds.upper, glm::vec3(1, 1, 0));
}

TEST(rewrite_streams, vertices_that_an_extension_may_name_keep_their_order) {
  TinyGltf gltf = grid();
  gltf.root["meshes"][0]["primitives"][0]["extensions"]["NOT_A_selection"] = {{"share", 0.5}};
  const Both out = recoded(gltf, how(false, true));
  EXPECT_EQ(first(out.before).positions, first(out.after).positions);
  EXPECT_EQ(first(out.before).source_vertex, first(out.after).source_vertex);
}

TEST(rewrite_streams, primitives_that_share_a_part_of_their_vertices_keep_the_order) {
  TinyGltf gltf = grid();
  Json second = gltf.root["meshes"][0]["primitives"][0];
  second["attributes"].erase("COLOR_0");
  gltf.root["meshes"][0]["primitives"].push_back(second);
  const Both out = recoded(gltf, how(false, true));
  for (std::size_t p = 0; p < 2; ++p)
    EXPECT_EQ(out.before.scene.meshes[0].primitives[p].positions, out.after.scene.meshes[0].primitives[p].positions);
}

TEST(rewrite_streams, G37_two_sets_of_weights_stay_floats_and_far_joints_stay_wide) {
  TinyGltf gltf = grid();
  Json& attributes = gltf.root["meshes"][0]["primitives"][0]["attributes"];
  const std::size_t count = gltf.root["accessors"][0]["count"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = gltf.vec4(std::vector<float>(4 * count, 0.0f));
  std::vector<float> times{0, 1};
  const Both out = recoded(gltf, how(true, false));
  const Json& json = out.parts.json;
  const Json& written = json["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(json["accessors"][written["WEIGHTS_0"].get<std::size_t>()]["componentType"], 5126);
  EXPECT_EQ(first(out.before).influences.weights, first(out.after).influences.weights);
}

TEST(rewrite_streams, quantised_vertices_keep_order_and_number_unless_they_are_to_be_merged) {
  RewriteOptions options = how(true, false);
  options.merge_vertices = false;
  const Both out = recoded(grid_without_sparse(), options);
  const Primitive &a = first(out.before), &b = first(out.after);
  ASSERT_EQ(a.vertex_count(), 6 * kSide * kSide);
  ASSERT_EQ(b.vertex_count(), a.vertex_count());
  const auto in_file_order = [](const Primitive& p) {
    std::vector<glm::vec3> positions(p.vertex_count());
    for (std::size_t v = 0; v < p.vertex_count(); ++v)
      positions[p.source_vertex.empty() ? v : p.source_vertex[v]] = p.positions[v];
    return positions;
  };
  EXPECT_EQ(in_file_order(a), in_file_order(b));
}

TEST(rewrite_streams, rotations_above_a_camera_keep_16_bits) {
  const auto worst_dot = [](bool camera) {
    TinyGltf gltf = grid();
    if (camera) {
      gltf.root["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
      gltf.root["nodes"][2]["camera"] = 0;
    }
    RewriteOptions options = how(true, true);
    const Both out = recoded(gltf, options);
    const auto& a = out.before.scene.animations[0].bones[1].rotation.values;
    const auto& b = out.after.scene.animations[0].bones[1].rotation.values;
    double worst = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const glm::quat d(b[k].w - a[k].w, b[k].x - a[k].x, b[k].y - a[k].y, b[k].z - a[k].z);
      worst = std::max(worst, 2.0 * std::sqrt(static_cast<double>(glm::dot(d, d))));
    }
    return worst;
  };
  EXPECT_GT(worst_dot(false), 1e-4);
  EXPECT_LT(worst_dot(true), 5e-5);
}

TEST(rewrite_streams_corpus, every_model_takes_less_room_and_keeps_its_parts) {
  for (const bool meshopt : {false, true}) {
    RewriteOptions options = how(true, meshopt);
    options.drop = {"image-missing"};
    for (const auto& path : files_for_tests("models", {".gltf", ".glb"})) {
      SCOPED_TRACE(path.string() + (meshopt ? " compressed" : ""));
      const auto file = import_gltf(path, carrying());
      if (!file) continue;
      RewriteOptions plain;
      plain.drop = options.drop;
      const auto out = rewrite_gltf(*file, options), whole = rewrite_gltf(*file, plain);
      ASSERT_TRUE(out && whole) << (out ? "" : out.error().issue.detail);
      const auto after = import_gltf(out->file, "recoded.glb", carrying());
      ASSERT_TRUE(after) << describe("recoded.glb", after.error().issue);
      ASSERT_EQ(after->scene.meshes.size(), file->scene.meshes.size());
      for (std::size_t m = 0; m < file->scene.meshes.size(); ++m)
        for (std::size_t p = 0; p < file->scene.meshes[m].primitives.size(); ++p)
          EXPECT_EQ(after->scene.meshes[m].primitives[p].indices.size(),
                    file->scene.meshes[m].primitives[p].indices.size());
      EXPECT_EQ(after->scene.skeleton.rest, file->scene.skeleton.rest);
      if (whole->file.size() > 20'000) {
        EXPECT_LT(out->file.size(), whole->file.size());
      }
      const auto decoded = rewrite_gltf(*after, plain);
      ASSERT_TRUE(decoded) << decoded.error().issue.detail;
    }
  }
}

}  // namespace
}  // namespace sinew::test
