// SPDX-License-Identifier: MIT
// A skinned, animated model under Draco, whose encoder reorders vertices. Every vertex must move as in the same model
// without compression.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/plan/run_plan.h"
#include "tests/importer/tiny_draco.h"

namespace sinew::test {
namespace {

constexpr std::uint32_t kRows = 9;  // of two vertices each, 0.1 apart

/// A ribbon along y whose weights change from the first joint to the second. TEXCOORD_0 identifies vertices.
TriangleValues ribbon() {
  TriangleValues values;
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (const float side : {-1.0f, 1.0f}) {
      const auto add = [&](const char* name, std::initializer_list<float> numbers) {
        values[name].insert(values[name].end(), numbers);
      };
      const float y = 0.1f * static_cast<float>(row), share = std::clamp(2.5f * y - 0.5f, 0.0f, 1.0f);
      add("POSITION", {side * (0.5f + 0.03f * y), y, 0.01f * side * y});
      add("NORMAL", {0, 0.6f * side, 0.8f});
      add("TEXCOORD_0", {static_cast<float>(row), side});
      add("JOINTS_0", {0, 1, 0, 0});
      add("WEIGHTS_0", {1.0f - share, share, 0, 0});
    }
  return values;
}

std::vector<std::uint32_t> ribbon_corners() {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t v = 0; v + 3 < 2 * kRows; v += 2)
    corners.insert(corners.end(), {v, v + 1, v + 2, v + 2, v + 1, v + 3});
  return corners;
}

/// The ribbon as plain accessors.
TinyGltf plain_document(const TriangleValues& values, const std::vector<std::uint32_t>& corners) {
  TinyGltf file;
  Json attributes;
  for (const auto& [name, list] : values) {
    const std::size_t width = list.size() / (2 * kRows);
    if (name == "JOINTS_0")
      attributes[name] = file.add(std::vector<std::uint8_t>(list.begin(), list.end()), "VEC4", 5121, 4);
    else
      attributes[name] = file.add(list, width == 2 ? "VEC2" : width == 3 ? "VEC3" : "VEC4", 5126, width);
  }
  const Json primitive{{"attributes", attributes}, {"indices", file.add(corners, "SCALAR", 5125, 1)}};
  file.root["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
  return file;
}

/// Adds two joints, a skin, and a clip that turns both and moves the root along a curve.
void animate(TinyGltf& file) {
  file.root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"translation", {0, 0.4, 0}}}});
  const std::size_t binds = file.add(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1,
                                                        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.4f, 0, 1},
                                     "MAT4", 5126, 16);
  file.root["skins"] = Json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}});
  const std::size_t times = file.times({0, 0.5f, 1});
  const std::size_t turns = file.vec4({0, 0, 0, 1, 0, 0.6f, 0, 0.8f, 0.8f, 0, 0, 0.6f});
  const std::size_t moves =
      file.vec3({0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 1, 1, 0, 0, 1, 0, 1, 2, 3, 0, 0, 0});
  Json& animation = file.root["animations"][0];
  animation["samplers"] = {{{"input", times}, {"output", turns}},
                           {{"input", times}, {"output", moves}, {"interpolation", "CUBICSPLINE"}}};
  const auto channel = [](int sampler, int node, const char* path) {
    return Json{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
  };
  animation["channels"] = {channel(0, 1, "rotation"), channel(0, 2, "rotation"), channel(1, 1, "translation")};
}

Scene scene_of(TinyGltf file) {
  animate(file);
  auto result = file.import();
  EXPECT_EQ(outcome(result), "ok");
  return result ? std::move(result->scene) : Scene{};
}

struct Vertex {
  glm::vec3 position, normal;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};
using VertexByName = std::map<std::pair<float, float>, Vertex>;  // the key is the texture coordinate

VertexByName vertices_at(const Scene& scene, double time_s) {
  const Plan plan = compile_plan(lend(scene), Needs{});
  FrameBuffer frame(plan);
  const ClipLayer layers[] = {{.clip = 0, .time_s = time_s}};
  FrameInput input;
  input.layers = layers;
  EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  const DeformedPrimitive& moved = frame.result().primitives[0];
  const auto& names = scene.meshes[0].primitives[0].texcoords[0];
  VertexByName out;
  for (std::size_t v = 0; v < moved.positions.size(); ++v)
    out[{names[v].x, names[v].y}] = {moved.positions[v], moved.normals[v]};
  return out;
}

TEST(animated_draco, T10_every_vertex_moves_as_in_the_same_model_without_compression) {
  const TriangleValues values = ribbon();
  const Scene plain = scene_of(plain_document(values, ribbon_corners())),
              packed = scene_of(draco_document(values, ribbon_corners()));
  const auto &mine = plain.meshes.at(0).primitives.at(0), &theirs = packed.meshes.at(0).primitives.at(0);
  ASSERT_EQ(theirs.vertex_count(), 2u * kRows);
  EXPECT_NE(theirs.texcoords[0], mine.texcoords[0]) << "the encoder has an order of its own";
  ASSERT_EQ(packed.clips.size(), 1u);
  for (const double time_s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const VertexByName expected = vertices_at(plain, time_s), found = vertices_at(packed, time_s);
    EXPECT_EQ(expected.size(), 2u * kRows);
    EXPECT_TRUE(found == expected) << "at " << time_s << " s";
  }
  EXPECT_FALSE(vertices_at(plain, 0.2) == vertices_at(plain, 0.9)) << "something moves";
}

}  // namespace
}  // namespace sinew::test
