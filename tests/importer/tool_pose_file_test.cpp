// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

#include "importer/tool/poses/pose_input.h"
#include "importer/tool/poses/pose_json.h"
#include "tests/support/fixed_random.h"
#include "tests/support/full_disk.h"

namespace sinew::tool {
namespace {

std::string temporary(const char* name) {
  return (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name)).string();
}

Pose pose_with_odd_numbers() {
  Pose pose;
  pose.time_s = 0.10339999943971634;  // a float32, with all its digits
  pose.nodes = {
      {7, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, static_cast<double>(0.1f), -0.0, static_cast<double>(1e-30f), 1}}};
  pose.weights = {{7, {static_cast<double>(1.0f / 3.0f), -2.5}}};
  PrimitivePose primitive{.node = 7, .mesh = 1, .primitive = 2, .vertices = {0, 5}, .values = {}};
  primitive.of(VertexKind::positions) = {static_cast<double>(16777217.0f), 0, 0, 1, 2, 3};
  primitive.of(VertexKind::dqs) = {NAN, NAN, NAN, 4, 5, 6};
  primitive.of(VertexKind::tangents) = {1, 0, 0, -1, 0, 1, 0, 1};
  pose.primitives = {primitive};
  pose.bits = {{"linear", "00000000000000ff"}, {"pose", "fedcba9876543210"}};
  return pose;
}

void write(const std::string& file, const Pose& pose) {
  StreamedFile stream(file);
  ASSERT_TRUE(stream.opened());
  PoseJson out(stream);
  out.begin("models/a \"quoted\" name.glb", 2.5);
  out.begin_clip(kNone, "");
  out.begin_sample(pose);
  out.end_sample();
  out.end_clip();
  out.begin_clip(3, "wa\tlk");
  out.begin_sample(pose);
  out.end_sample();
  out.begin_sample(pose);
  out.end_sample();
  out.end_clip();
  out.end();
  ASSERT_TRUE(stream.finish());
}

struct ClipPoses {
  std::uint32_t clip = kNone;
  std::vector<Pose> samples;
};
struct PoseFile {
  std::optional<double> extent;
  std::vector<ClipPoses> clips;
};

/// All poses of a file at once.
tl::expected<PoseFile, ImportIssue> all_poses(const std::string& file) {
  PoseFile out;
  const auto read = read_poses(file, [&](std::size_t entry, const Pose& pose) {
    out.clips.resize(std::max(out.clips.size(), entry + 1));
    out.clips[entry].samples.push_back(pose);
    return true;
  });
  if (!read) return tl::unexpected(read.error());
  out.extent = read->extent;
  for (std::size_t i = 0; i < out.clips.size(); ++i) out.clips[i].clip = read->clips[i];
  return out;
}

class pose_file : public testing::TestWithParam<const char*> {};

TEST_P(pose_file, what_was_written_is_read_back_bit_for_bit) {
  const std::string file = temporary(GetParam());
  const Pose pose = pose_with_odd_numbers();
  write(file, pose);
  const auto read = all_poses(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(read) << read.error().json_pointer << read.error().detail;
  EXPECT_EQ(read->extent, 2.5);
  ASSERT_EQ(read->clips.size(), 2u);
  EXPECT_EQ(read->clips[0].clip, kNone);
  EXPECT_EQ(read->clips[1].clip, 3u);
  ASSERT_EQ(read->clips[1].samples.size(), 2u);
  const Pose& back = read->clips[1].samples[1];
  EXPECT_EQ(back.time_s, pose.time_s);
  EXPECT_EQ(back.nodes[0].node, 7u);
  EXPECT_EQ(back.nodes[0].world, pose.nodes[0].world);
  EXPECT_EQ(back.weights[0].weights, pose.weights[0].weights);
  EXPECT_EQ(back.bits, pose.bits);
  EXPECT_EQ(back.primitives[0].vertices, pose.primitives[0].vertices);
  EXPECT_EQ(back.primitives[0].primitive, 2u);
  EXPECT_EQ(back.primitives[0].of(VertexKind::positions), pose.primitives[0].of(VertexKind::positions));
  EXPECT_EQ(back.primitives[0].of(VertexKind::tangents), pose.primitives[0].of(VertexKind::tangents));
  EXPECT_TRUE(back.primitives[0].of(VertexKind::normals).empty());
  EXPECT_TRUE(std::isnan(back.primitives[0].of(VertexKind::dqs)[0]));
  EXPECT_EQ(back.primitives[0].of(VertexKind::dqs)[3], 4.0);
}

INSTANTIATE_TEST_SUITE_P(plain_and_compressed, pose_file, testing::Values("poses.json", "poses.json.gz"),
                         [](const auto& parameter) {
                           return std::string(parameter.param).ends_with("gz") ? "compressed" : "plain";
                         });

TEST(pose_json, numbers_that_json_has_no_word_for_become_null) {
  const std::string file = temporary("nan.json");
  Pose pose = pose_with_odd_numbers();
  pose.primitives[0].of(VertexKind::positions)[4] = std::numeric_limits<double>::infinity();
  write(file, pose);
  const auto read = all_poses(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(read);
  const auto& positions = read->clips[0].samples[0].primitives[0].of(VertexKind::positions);
  EXPECT_EQ(positions[0], 16777216.0);
  EXPECT_TRUE(std::isnan(positions[3]) && std::isnan(positions[5]));
}

TEST(streamed_file, a_folder_that_is_not_there_cannot_be_written) {
  EXPECT_FALSE(StreamedFile("/no such folder/poses.json").opened());
}

struct Refused {
  const char* text;
  const char* rule;
  const char* pointer;
  const char* detail;
};

TEST(pose_input, names_the_place_of_what_it_refuses_and_says_why) {
  const std::string head = R"({"clips": [{"clip": 0, "samples": [{"time": 0, "weights": [], )";
  const Refused cases[] = {
      {"{", "pose-file", "", "is not JSON"},
      {"[]", "pose-format", "", "a pose file is an object"},
      {"{}", "pose-format", "/clips", "an array is missing here"},
      {R"({"extent": "big", "clips": []})", "pose-format", "/extent", "is not a finite number of single precision"},
      {R"({"clips": [{}]})", "pose-format", "/clips/0/clip", "an index or null is missing here"},
      {R"({"clips": [{"clip": -1, "samples": []}]})", "pose-format", "/clips/0/clip", "is not an index"},
      {R"({"clips": [{"clip": null}]})", "pose-format", "/clips/0/samples", "an array is missing here"},
      {R"({"clips": [{"clip": null, "samples": [{"nodes": []}]}]})", "pose-format", "/clips/0/samples/0/time",
       "a time is missing here"},
      {R"("nodes": [{"node": 0, "world": [1, 2]}], "skinned": []}]}]})", "pose-format",
       "/clips/0/samples/0/nodes/0/world", "is not a matrix of 16 numbers"},
      {R"("nodes": [], "skinned": [{"node": 0, "primitive": 0, "vertices": [0], "positions": [[1, 2]]}]}]}]})",
       "pose-format", "/clips/0/samples/0/skinned/0/positions/0", "is not a vector of 3 numbers"},
      {R"("nodes": [], "skinned": [{"node": 0, "primitive": 0, "vertices": [0, 1], "normals": [[1, 2, 3]]}]}]}]})",
       "pose-format", "/clips/0/samples/0/skinned/0/normals", "does not have one entry for each of the 2 vertices"},
  };
  for (const auto& [text, rule, pointer, detail] : cases) {
    const auto read = parse_poses(*text == '"' ? head + text : text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().rule, rule) << text;
    EXPECT_EQ(read.error().json_pointer, pointer) << text;
    EXPECT_EQ(read.error().detail, detail) << text;
  }
}

TEST(pose_input, numbers_too_small_for_a_double_are_zero_and_those_too_large_are_refused) {
  const auto time_of = [](const std::string& number) -> std::optional<double> {
    std::optional<double> time;
    const auto read = parse_poses(R"({"clips": [{"clip": 0, "samples": [{"time": )" + number +
                                      R"(, "nodes": [], "weights": [], "skinned": []}]}]})",
                                  [&](std::size_t, const Pose& pose) {
                                    time = pose.time_s;
                                    return true;
                                  });
    return read ? time : std::nullopt;
  };
  EXPECT_EQ(time_of("0.25"), 0.25);
  EXPECT_EQ(time_of("1e-999"), 0.0);
  EXPECT_EQ(time_of("4.9e-324"), 4.9e-324);
  EXPECT_EQ(time_of("1e999"), std::nullopt);
}

TEST(pose_input, a_byte_order_mark_before_the_text_is_read_past) {
  const std::string file = temporary("mark.json"), poses = R"({"clips": []})";
  const auto error_of = [&](const std::string& text) -> std::string {
    std::ofstream(file, std::ios::binary) << text;
    const auto from_file = read_poses(file), from_text = parse_poses(text);
    EXPECT_EQ(from_file.has_value(), from_text.has_value()) << text;
    return from_file ? "" : from_file.error().detail;
  };
  EXPECT_EQ(error_of(poses), "");
  EXPECT_EQ(error_of("\xef\xbb\xbf" + poses), "");
  EXPECT_EQ(error_of("\xef\xbb" + poses), "is not JSON");
  EXPECT_EQ(error_of("\xef"), "is not JSON");
  std::filesystem::remove(file);
}

/// Whole JSON does not make up for what follows it: only the end of a compressed file says that its text is right.
TEST(pose_input, refuses_a_compressed_file_whose_checksum_is_cut_off_or_wrong) {
  const std::string file = temporary("sum.json.gz");
  for (const bool is_cut : {true, false}) {
    write(file, pose_with_odd_numbers());
    ASSERT_TRUE(read_poses(file));
    const auto size = std::filesystem::file_size(file);
    if (is_cut) {
      std::filesystem::resize_file(file, size - 6);
    } else {
      std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(static_cast<std::streamoff>(size) - 8);
      stream.write("none", 4);
    }
    const auto read = read_poses(file);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().rule, "pose-file");
    EXPECT_EQ(read.error().detail, "is damaged or cut short");
  }
  std::filesystem::remove(file);
}

/// Writes a pose file without poses and with many spaces, which take a thousandth of their room.
void write_spaces(const std::string& file, std::size_t spaces) {
  StreamedFile stream(file);
  stream.write("{\"clips\": []" + std::string(spaces, ' ') + "}");
  ASSERT_TRUE(stream.finish());
}

TEST(pose_input, a_compressed_file_may_unpack_to_a_megabyte_and_256_times_its_size) {
  const std::string file = temporary("spaces.json.gz");
  write_spaces(file, 900'000);
  ASSERT_GT(900'000u, 256 * std::filesystem::file_size(file)) << "the megabyte is needed";
  EXPECT_TRUE(read_poses(file));
  write_spaces(file, 4'000'000);
  const auto read = read_poses(file);
  std::filesystem::remove(file);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().rule, "pose-file");
  EXPECT_EQ(read.error().detail, "unpacks to more than 256 times its size");
}

TEST(pose_input, refuses_a_compressed_file_that_is_cut_short_or_missing) {
  const std::string file = temporary("cut.json.gz");
  write(file, pose_with_odd_numbers());
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 20);
  const auto cut = read_poses(file);
  std::filesystem::remove(file);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().rule, "pose-file");
  ASSERT_FALSE(read_poses(file));
}

/// Bytes that no compression makes fewer.
std::string noise(std::size_t count) {
  test::FixedRandom random(1);
  std::string bytes(count, ' ');
  for (char& byte : bytes) byte = static_cast<char>(random.below(256));
  return bytes;
}

TEST(streamed_file, whatever_is_lost_on_a_full_disk_is_told_at_the_end_and_leaves_nothing) {
  const std::string bytes = noise(100'000);
  for (const char* name : {"full.json", "full.json.gz"})
    for (const bool at_places : {false, true}) {
      const std::string file = temporary(name);
      {
        const test::FullDisk disk(1000);
        StreamedFile stream(file);
        ASSERT_TRUE(stream.opened());
        at_places ? stream.write_at(0, bytes) : stream.write(bytes);
        at_places ? stream.write_at(500, "end") : stream.write("end");
        EXPECT_FALSE(stream.finish()) << file << at_places;
      }
      EXPECT_FALSE(std::filesystem::exists(file)) << file << at_places;
    }
}

TEST(pose_text, values_that_leave_open_what_holds_are_refused) {
  const auto complaint = [](const std::string& sample) {
    const auto read = parse_poses(R"({"clips": [{"clip": 0, "samples": [)" + sample + "]}]}");
    return read ? "taken" : read.error().json_pointer + ": " + read.error().detail;
  };
  const std::string node = R"({"node": 1, "weights": [0.5]})", none = R"("nodes": [], "weights": [], "skinned": [])";
  const auto skinned = [](const std::string& vertices) {
    return R"({"time": 0, "nodes": [], "weights": [], "skinned": [{"node": 0, "primitive": 0, "vertices": )" +
           vertices + "}]}";
  };
  EXPECT_EQ(complaint(R"({"time": 0, "nonUnit": 0.1, )" + none + "}"), "taken");
  EXPECT_EQ(complaint(R"({"time": 0, "nonUnit": -0.1, )" + none + "}"), "/clips/0/samples/0/nonUnit: is negative");
  EXPECT_EQ(complaint(R"({"time": 1e39, )" + none + "}"),
            "/clips/0/samples/0/time: is not a finite number of single precision");
  EXPECT_EQ(complaint(R"({"time": 0, "nodes": [], "weights": [)" + node + "," + node + R"(], "skinned": []})"),
            "/clips/0/samples/0/weights/1: repeats what an earlier entry names");
  EXPECT_EQ(complaint(skinned("[0, 2, 5]")), "taken");
  EXPECT_EQ(complaint(skinned("[0, 5, 2]")), "/clips/0/samples/0/skinned/0/vertices: do not increase");
  EXPECT_EQ(complaint(skinned("[0, 0]")), "/clips/0/samples/0/skinned/0/vertices: do not increase");
}

TEST(pose_text, what_nobody_reads_may_be_nested_a_thousand_levels_deep) {
  const auto nested = [](std::size_t levels) {
    return parse_poses(R"({"clips": [], "more": )" + std::string(levels, '[') + std::string(levels, ']') + "}");
  };
  EXPECT_TRUE(nested(1000));
  const auto deeper = nested(1001);
  ASSERT_FALSE(deeper);
  EXPECT_EQ(deeper.error().json_pointer, "/more");
  EXPECT_EQ(deeper.error().detail, "is nested more than 1000 deep");
}

}  // namespace
}  // namespace sinew::tool
