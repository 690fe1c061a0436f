// SPDX-License-Identifier: MIT
// `sinew bake`, and the output of `sinew info` for its files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "importer/geometry_cache/point_cache.h"
#include "importer/import_gltf.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/plan/run_plan.h"
#include "tests/geometry_cache/point_cache_files.h"
#include "tests/importer/tool_model.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;

/// Positions of all vertices of one mesh in one frame of a cache.
std::vector<glm::vec3> positions(const std::string& file, std::uint32_t frame, std::size_t mesh = 0) {
  const std::vector<std::byte> bytes = read_file(file);
  const auto cache = GeometryCache::open(bytes);
  EXPECT_TRUE(cache.has_value());
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, bytes};
  std::vector<glm::vec3> out(cache->meshes()[mesh].vertex_count);
  EXPECT_EQ(decoder.decode(frame, source), GeometryStatus::ok);
  EXPECT_EQ(decoder.write_vertices(mesh, out), GeometryStatus::ok);
  return out;
}

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 3 2 4\n";
const std::vector<glm::vec3> kRest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5f}};

TEST(bake_command, bakes_a_clip_within_the_budget_and_info_tells_about_it) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  const CommandOutcome baked =
      run_tool({"bake", model.path(), "--clip", "0", "--fps", "20", "--budget", "0.3mm", "-o", out});
  ASSERT_EQ(baked.status, 0) << baked.err;
  for (const char* text : {"asked", "measured", "between frames", "0.3 mm", "yes", "20 a second"})
    EXPECT_THAT(baked.out, HasSubstr(text));
  const CommandOutcome info = run_tool({"info", out});
  EXPECT_EQ(info.status, 0);
  EXPECT_THAT(info.out, HasSubstr("geometry cache, version 1"));
  const auto json = nlohmann::json::parse(run_tool({"info", "--json", out}).out);
  EXPECT_LE(json["geometry_cache"]["meshes"][0]["measured_m"].get<double>(), 3e-4);

  const auto file = import_gltf(model.path());
  ASSERT_TRUE(file.has_value());
  const Plan plan = compile_plan(lend(file->scene), Needs{});
  FrameBuffer frame(plan);
  const ClipLayer layers[] = {{.clip = 0, .time_s = 3 / 20.0}};
  FrameInput input;
  input.layers = layers;
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  std::size_t mesh = 0;
  for (const DeformedPrimitive& primitive : frame.result().primitives) {
    const MeshInstance& instance = file->scene.instances[primitive.instance];
    const Primitive& rest = file->scene.meshes[instance.mesh].primitives[primitive.primitive];
    if (rest.topology != Topology::triangles) continue;
    const auto shown = positions(out, 3, mesh++);
    const auto from = primitive.positions.empty() ? std::span(rest.positions) : primitive.positions;
    for (std::size_t v = 0; v < shown.size(); ++v)
      ASSERT_LE(glm::distance(shown[v],
                              transform_point(frame.result().instances[primitive.instance].world_from_mesh, from[v])),
                3.01e-4f);
  }
  EXPECT_GT(mesh, 0u);
}

TEST(bake_command, moves_a_mesh_by_a_point_cache_whose_axes_it_finds_and_tells) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  write_file(obj, kObj);
  std::vector<std::vector<glm::vec3>> frames(3);
  for (int f = 0; f < 3; ++f)  // z up
    for (const glm::vec3& p : kRest) frames[f].emplace_back(p.x, -p.z, p.y + static_cast<float>(f));
  write_file(points, mdd_file(frames, {0.0f, 0.1f, 0.2f}));
  const CommandOutcome baked = run_tool({"bake", obj, "--points", points, "-o", out});
  ASSERT_EQ(baked.status, 0) << baked.err;
  EXPECT_THAT(baked.out, HasSubstr("z is up"));
  const auto last = positions(out, 2);
  for (std::size_t v = 0; v < kRest.size(); ++v)
    EXPECT_LE(glm::distance(last[v], kRest[v] + glm::vec3(0, 2, 0)), 1e-4f);

  ASSERT_EQ(run_tool({"bake", obj, "--points", points, "--up", "y", "-o", out}).status, 0) << "who says it is obeyed";
  EXPECT_LE(glm::distance(positions(out, 2)[3], frames[2][3]), 1e-4f);
  write_file(points, pc2_file(frames, 0.0f, 1.0f));
  EXPECT_EQ(run_tool({"bake", obj, "--points", points, "-o", out}).status, 0);
  frames[0][1].x += 1.0f;
  write_file(points, mdd_file(frames, {0.0f, 0.1f, 0.2f}));
  const CommandOutcome unclear = run_tool({"bake", obj, "--points", points, "-o", out});
  EXPECT_EQ(unclear.status, 1);
  EXPECT_THAT(unclear.err, HasSubstr("points-axes"));
  EXPECT_THAT(unclear.err, HasSubstr("--up"));
}

TEST(bake_command, a_budget_in_parts_of_the_model_is_of_its_longest_side) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  const std::pair<double, glm::vec3> shapes[] = {
      {0.01, {0.5f, 1.0f, 0.25f}}, {30.0, {1.0f, 0.5f, 0.25f}}, {2.0, {0.25f, 0.5f, 2.0f}}};  // kRest is half as deep
  for (const auto& [side, shape] : shapes) {
    std::vector<glm::vec3> rest;
    for (const glm::vec3& p : kRest) rest.push_back(p * shape * static_cast<float>(side));
    std::string text;
    for (const glm::vec3& p : rest)
      text += "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
    write_file(obj, text + kObj.substr(kObj.find('f')));
    std::vector<glm::vec3> stretched = rest;
    for (glm::vec3& p : stretched) p.y *= 3.0f;
    write_file(points, mdd_file({rest, stretched}, {0.0f, 0.1f}));
    ASSERT_EQ(run_tool({"bake", obj, "--points", points, "--up", "y", "--budget", "0.5%", "-o", out}).status, 0);
    const auto json = nlohmann::json::parse(run_tool({"info", "--json", out}).out);
    EXPECT_NEAR(json["geometry_cache"]["meshes"][0]["asked_m"].get<double>(), 0.005 * side, 1e-5 * side);
  }
}

TEST(bake_command, takes_numbered_files_as_long_as_they_follow) {
  const ToolModelFile model;
  for (const char* number : {"08", "09", "10", "12"})
    write_file(model.beside(std::string("cloth_") + number + ".obj"), kObj);
  const std::string first = model.beside("cloth_08.obj"), out = model.beside("out.sgeo");
  const CommandOutcome baked = run_tool({"bake", first, "-o", out});
  ASSERT_EQ(baked.status, 0) << baked.err;
  EXPECT_THAT(baked.out, HasSubstr("cloth_10.obj: 3 frames"));
  write_file(model.beside("cloth_09.obj"), kObj + "v 0 0 0\n");
  const CommandOutcome other = run_tool({"bake", first, "-o", out});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("obj-topology"));
}

TEST(bake_command, says_what_is_wrong_and_writes_nothing) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  write_file(obj, kObj);
  write_file(points, mdd_file({{{0, 0, 0}}}, {0.0f}));
  const auto fails = [&](std::vector<std::string> arguments, int status, const char* text) {
    arguments.insert(arguments.begin(), "bake");
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  fails({obj, "--points", points, "-o", out}, 1, "points-count");
  fails({obj, "-o", out}, 1, "obj-frames");
  fails({obj, "--points", model.beside("none.mdd"), "-o", out}, 1, "file-unreadable");
  fails({model.path(), "--clip", "nobody", "-o", out}, 2, "clip");
  fails({model.path(), "--clip", "0", "--budget", "a bit", "-o", out}, 2, "--budget");
  fails({model.path(), "--clip", "0", "--budget", "0", "-o", out}, 1, "cache-budget");
  fails({model.path(), "-o", out}, 2, "--clip");
  fails({model.path(), "--up", "y", "-o", out}, 2, "--points");
  fails({model.path(), "--clip", "0", "-o", model.path()}, 2, "is read; it is left as it is");
}

TEST(bake_command, info_has_a_row_for_each_stream_of_each_mesh) {
  const std::string file = SINEW_SOURCE_DIR "/tests/golden/cloth.sgeo";
  EXPECT_EQ(run_tool({"info", file}).out,
            file +
                "\n"
                "geometry cache, version 1\n"
                "  #  mesh    stream     vertices  points  triangles  asked  measured  kept\n"
                "  0  \"mesh\"  positions       425     425        768   1 mm  0.999 mm  yes\n"
                "  1  \"mesh\"  positions        70      70          0   1 mm  0.998 mm  yes\n"
                "             colours          70       2              0.01   0.00789  yes\n"
                "10 frames at 30 a second, 7488 bytes, 11.0 % of raw floats, 15.7 kB a second\n"
                "2 segments of up to 6 frames; a seek decodes no more\n");
  const auto meshes = nlohmann::json::parse(run_tool({"info", "--json", file}).out)["geometry_cache"]["meshes"];
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0]["triangles"], 768);
  EXPECT_EQ(meshes[0]["vertices"], 425);
  EXPECT_EQ(meshes[1]["triangles"], 0);
  EXPECT_EQ(meshes[1]["points"], 70);
  ASSERT_EQ(meshes[1]["streams"].size(), 2u);
  EXPECT_EQ(meshes[1]["streams"][1]["kind"], "colours");
  EXPECT_EQ(meshes[1]["streams"][1]["points"], 2);
}

TEST(bake_command, info_refuses_a_damaged_cache) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "0", "-o", out}).status, 0);
  std::vector<std::byte> bytes = read_file(out);
  bytes[60] ^= std::byte(1);
  write_file(out, bytes);
  const CommandOutcome info = run_tool({"info", out});
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(info.err, HasSubstr("cache-checksum"));
}

TEST(bake_command_corpus, point_caches_beside_their_meshes_are_baked_within_the_budget) {
  const ToolModelFile model;
  for (const auto& points : files_for_tests("cache", {".mdd", ".pc2"})) {
    std::filesystem::path obj = points;
    obj.replace_extension(".obj");
    const std::string out = model.beside("out.sgeo");
    CommandOutcome baked = run_tool({"bake", obj.string(), "--points", points.string(), "-o", out});
    const bool told = baked.status == 0;
    if (!told) {
      EXPECT_THAT(baked.err, HasSubstr("points-axes"));
      baked = run_tool({"bake", obj.string(), "--points", points.string(), "--up", "z", "-o", out});
    }
    ASSERT_EQ(baked.status, 0) << points << baked.err;
    EXPECT_THAT(baked.out, HasSubstr("yes"));
    const auto bytes = read_file(points);
    auto truth = read_point_cache(bytes, points.string(), 30.0);
    ASSERT_TRUE(truth.has_value());
    if (!told || baked.out.find("z is up") != std::string::npos) turn_to_y_up(*truth);
    const std::uint32_t last = static_cast<std::uint32_t>(truth->frames.size()) - 1;
    const auto shown = positions(out, last);
    for (std::size_t v = 0; v < shown.size(); ++v)
      ASSERT_LE(glm::distance(shown[v], truth->frames[last][v]), 1.001e-4f) << points << " vertex " << v;
  }
}

}  // namespace
}  // namespace sinew::test
