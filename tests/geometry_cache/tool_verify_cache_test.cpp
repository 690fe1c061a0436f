// SPDX-License-Identifier: MIT
// `sinew verify` of geometry caches, and files that `sinew bake` refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/geometry_cache/point_cache_files.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 3 2 4\n";

std::vector<std::vector<glm::vec3>> rising_frames(std::size_t count) {
  std::vector<std::vector<glm::vec3>> frames;
  for (std::size_t f = 0; f < count; ++f) {
    const auto up = 0.1f * static_cast<float>(f);
    frames.push_back({{0, up, 0}, {1, up, 0}, {0, 1 + up, 0}, {1, 1 + up, 0.5f}});
  }
  return frames;
}

TEST(verify_cache_command, decodes_every_frame_and_sees_a_byte_that_changed) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "0", "-o", out}).status, 0);
  const CommandOutcome sound = run_tool({"verify", out});
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("31 frames decoded"));
  std::vector<std::byte> bytes = read_file(out);
  const std::size_t at = GeometryCache::open(bytes)->frames()[30].offset + 5;
  bytes[at] ^= std::byte(1);
  write_file(out, bytes);
  const CommandOutcome damaged = run_tool({"verify", out});
  EXPECT_EQ(damaged.status, 1);
  EXPECT_THAT(damaged.err, HasSubstr("cache-frame: frame 30"));
  EXPECT_EQ(run_tool({"info", out}).status, 0) << "it reads no frames";
  bytes.resize(bytes.size() - 1);
  write_file(out, bytes);
  EXPECT_EQ(run_tool({"verify", out}).status, 4) << "no frame was looked at";
}

TEST(verify_cache_command, measures_anew_against_the_clip_it_was_baked_from) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "bend", "--fps", "20", "--normals", "2deg", "-o", out}).status,
            0);
  const CommandOutcome same = run_tool({"verify", out, "--against", model.path(), "--clip", "bend"});
  EXPECT_EQ(same.status, 0) << same.err;
  for (const char* text : {"positions of", "normals of", "measured anew", "2 deg asked"})
    EXPECT_THAT(same.out, HasSubstr(text));
  const CommandOutcome other = run_tool({"verify", out, "--against", model.path(), "--clip", "talk"});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("verify-shape"));
}

TEST(verify_cache_command, takes_many_caches_and_folders_of_them) {
  const ToolModelFile model;
  const std::string folder = model.beside("caches"), a = folder + "/a.sgeo", b = folder + "/b.SGEO";
  std::filesystem::create_directory(folder);
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "0", "-o", a}).status, 0);
  std::filesystem::copy_file(a, b);
  const std::string lines = a + ": 31 frames decoded, every checksum is right\n" + b +
                            ": 31 frames decoded, every checksum is right\n2 files: 2 done, 0 failed\n";
  EXPECT_EQ(run_tool({"verify", a, b}).out, lines);
  EXPECT_EQ(run_tool({"verify", folder}).out, lines);
  const CommandOutcome against = run_tool({"verify", folder, "--against", model.path(), "--clip", "0"});
  EXPECT_EQ(against.status, 0) << against.err;
  EXPECT_EQ(against.out, lines) << "errors are told one file at a time";
  std::vector<std::byte> bytes = read_file(b);
  bytes.resize(bytes.size() - 1);
  write_file(b, bytes);
  EXPECT_EQ(run_tool({"verify", folder}).status, 4);
}

TEST(verify_cache_command, a_source_that_moved_farther_than_was_asked_is_told) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  write_file(obj, kObj);
  auto frames = rising_frames(3);
  const std::vector<float> times_s = {0.0f, 0.1f, 0.2f};
  write_file(points, mdd_file(frames, times_s));
  ASSERT_EQ(run_tool({"bake", obj, "--points", points, "--up", "y", "-o", out}).status, 0);
  const std::vector<std::string> verify = {"verify", out, "--against", obj, "--points", points, "--up", "y"};
  EXPECT_EQ(run_tool(verify).status, 0);
  frames[2][1].x += 0.01f;
  write_file(points, mdd_file(frames, times_s));
  const CommandOutcome moved = run_tool(verify);
  EXPECT_EQ(moved.status, 1);
  EXPECT_THAT(moved.out, HasSubstr("NOT kept"));
}

TEST(verify_cache_command, a_thousandth_more_than_was_asked_is_rounding_and_two_are_not) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  write_file(obj, kObj);
  const std::vector<float> times_s = {0.0f, 0.1f, 0.2f};
  write_file(points, mdd_file(rising_frames(3), times_s));
  ASSERT_EQ(run_tool({"bake", obj, "--points", points, "--up", "y", "--budget", "1mm", "-o", out}).status, 0);
  const std::vector<std::byte> bytes = read_file(out);
  const auto cache = GeometryCache::open(bytes);
  ASSERT_TRUE(cache);
  MappedFrames frames{*cache, bytes};
  GeometryDecoder decoder(*cache);
  std::vector<std::vector<glm::vec3>> decoded(3, std::vector<glm::vec3>(4));
  for (std::uint32_t f = 0; f < 3; ++f) {
    ASSERT_EQ(decoder.decode(f, frames), GeometryStatus::ok);
    ASSERT_EQ(decoder.write_vertices(0, decoded[f]), GeometryStatus::ok);
  }
  for (const auto& [times, status] : {std::pair{1.0005f, 0}, {1.0015f, 1}}) {
    auto moved = decoded;
    moved[2][0].x += 0.001f * times;
    write_file(points, mdd_file(moved, times_s));
    EXPECT_EQ(run_tool({"verify", out, "--against", obj, "--points", points, "--up", "y"}).status, status) << times;
  }
}

/// A file without motion. Each number is a mesh: a strip with that many corners. Each triangle gets its own vertices,
/// and so its own normal.
std::string still_file(const std::vector<std::size_t>& strips) {
  TinyGltf gltf;
  for (const std::size_t count : strips) {
    std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    corners.resize(3 * count);
    gltf.root["nodes"].push_back({{"mesh", gltf.root["nodes"].size()}});
    gltf.root["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", gltf.vec3(corners)}}}, {"mode", 5}}}}});
  }
  return gltf.text();
}

TEST(verify_cache_command, a_source_of_another_shape_is_refused_with_the_first_difference) {
  const ToolModelFile model;
  const std::string source = model.beside("still.gltf"), out = model.beside("out.sgeo");
  std::ofstream(source) << still_file({3, 4});
  ASSERT_EQ(run_tool({"bake", source, "-o", out}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, "--against", source}).status, 0);
  const auto expect_refusal = [&](const std::vector<std::size_t>& strips, const std::string& why) {
    std::ofstream(source) << still_file(strips);
    const CommandOutcome outcome = run_tool({"verify", out, "--against", source});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "sinew: " + source + ": verify-shape: " + why + "\n");
  };
  expect_refusal({3}, "it has 1 mesh, and the cache 2");
  expect_refusal({3, 4, 4}, "it has 3 meshes, and the cache 2");
  expect_refusal({3, 3}, "mesh 1 has 3 vertices and 1 stream, and in the cache 6 and 1");
  expect_refusal({4, 4}, "mesh 0 has 6 vertices and 1 stream, and in the cache 3 and 1");
}

TEST(verify_cache_command, arguments_that_make_no_sense) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "0", "-o", out}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, "--clip", "0"}).status, 2) << "of which source";
  EXPECT_EQ(run_tool({"verify", out, "poses.json", "--against", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"verify", model.path(), "--against", model.path()}).status, 2) << "FILE is no cache";
  EXPECT_EQ(run_tool({"verify", model.path()}).status, 2) << "no golden poses";
}

TEST(verify_cache_command, info_tells_segments_and_bytes_a_second) {
  const ToolModelFile model;
  const std::string out = model.beside("out.sgeo");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "0", "--segment", "8", "-o", out}).status, 0);
  const CommandOutcome info = run_tool({"info", out});
  EXPECT_THAT(info.out, HasSubstr("4 segments of up to 8 frames"));
  EXPECT_THAT(info.out, HasSubstr("kB a second"));
}

/// Expects one sentence on stderr with the file and the rule, and no output file.
void expect_refused(const std::vector<std::string>& arguments, const std::string& rule, const std::string& file) {
  const CommandOutcome outcome = run_tool(arguments);
  EXPECT_EQ(outcome.status, 1) << rule;
  EXPECT_THAT(outcome.err, HasSubstr(file));
  EXPECT_THAT(outcome.err, HasSubstr(rule));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(bake_command_hostile, point_caches_are_refused_in_one_sentence_with_file_and_rule) {
  const ToolModelFile model;
  const std::string obj = model.beside("mesh.obj"), points = model.beside("points.mdd"), out = model.beside("out.sgeo");
  write_file(obj, kObj);
  const auto refused = [&](std::vector<std::byte> bytes, const std::string& rule) {
    write_file(points, bytes);
    expect_refused({"bake", obj, "--points", points, "--up", "y", "-o", out}, rule, points);
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  const auto frames = rising_frames(3);
  for (auto good : {mdd_file(frames, {0, 0.1f, 0.2f}), pc2_file(frames, 0, 1)}) {
    good.pop_back();
    refused(good, "points-size");
    good.resize(7);
    refused(good, "points-size");
    refused({}, "points-size");
  }
  auto broken = frames;
  broken[1][2].z = std::numeric_limits<float>::quiet_NaN();
  refused(mdd_file(broken, {0, 0.1f, 0.2f}), "points-values");
  broken[1][2].z = std::numeric_limits<float>::infinity();
  refused(pc2_file(broken, 0, 1), "points-values");
  refused(mdd_file(frames, {0, 0.1f, 0.5f}), "points-times");
  refused(pc2_file(frames, 0, -1), "points-header");
  refused(mdd_file({{{0, 0, 0}}}, {0}), "points-count");
}

TEST(bake_command_hostile, numbered_files_are_refused_in_one_sentence_with_file_and_rule) {
  const ToolModelFile model;
  const std::string first = model.beside("f_1.obj"), second = model.beside("f_2.obj"), out = model.beside("out.sgeo");
  write_file(first, kObj);
  const auto refused = [&](const std::string& text, const std::string& rule) {
    write_file(second, text);
    expect_refused({"bake", first, "-o", out}, rule, second);
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  refused(kObj.substr(0, 30), "obj-syntax");    // cut in a line
  refused(kObj.substr(0, 24), "obj-topology");  // cut between lines
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 nan\nf 1 2 3\nf 3 2 4\n", "obj-values");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 3 2 5\n", "obj-index");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 3 4 2\n", "obj-topology");  // other faces
  refused("", "obj-empty");
  write_file(first, "");
  std::filesystem::remove(second);
  expect_refused({"bake", first, "-o", out}, "obj-empty", first);
}

}  // namespace
}  // namespace sinew::test
