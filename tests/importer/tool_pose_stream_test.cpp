// SPDX-License-Identifier: MIT
// Pose files are read one pose at a time: what is taken, what is refused, and how much memory it needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "importer/tool/poses/pose_input.h"
#include "tests/importer/tool_model.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tool::parse_poses;
using tool::Pose;

constexpr const char* kEmptyPose = R"({"time": 0, "nodes": [], "weights": [], "skinned": []})";

std::string with_samples(const std::string& samples) {
  return R"({"clips": [{"clip": 0, "samples": [)" + samples + "]}]}";
}

TEST(pose_stream, hands_out_poses_in_the_order_of_the_file_and_summarizes_all) {
  const std::string text = fmt::format(
      R"({{"clips": [{{"samples": [{0}], "clip": null}}, {{"clip": 7, "samples": [{0}, {0}]}}], "extent": 2.5}})",
      kEmptyPose);
  std::vector<std::size_t> entries;
  const auto summary = parse_poses(text, [&](std::size_t entry, const Pose&) {
    entries.push_back(entry);
    return true;
  });
  ASSERT_TRUE(summary) << summary.error().json_pointer;
  EXPECT_THAT(entries, ElementsAre(0, 1, 1));
  EXPECT_THAT(summary->clips, ElementsAre(kNone, 7u)) << "an entry may name its clip after its poses";
  EXPECT_EQ(summary->poses, 3u);
  EXPECT_EQ(summary->extent, 2.5);
}

TEST(pose_stream, ends_where_the_sink_wants_no_more) {
  std::size_t got = 0;
  const std::string two = fmt::format("{0}, {0}", kEmptyPose);
  const auto summary = parse_poses(with_samples(two), [&](std::size_t, const Pose&) { return ++got < 1; });
  ASSERT_TRUE(summary);
  EXPECT_EQ(got, 1u);
  EXPECT_EQ(summary->poses, 1u);
}

TEST(pose_stream, skips_what_the_format_does_not_know) {
  const std::string odd = R"({"nodes": [{"time": 5}], "clips": {"a": [[1, {"b": null}]]}})";
  const std::string text = fmt::format(
      R"({{"before": {0}, "clips": [{{"x": {0}, "clip": 0, "samples": [{{"y": [{0}, true, "z"], "time": 1, "nodes":
         [{{"extra": {0}, "node": 3, "world": [1,0,0,0,0,1,0,0,0,0,1,0,4,5,6,1]}}], "weights": [], "skinned": []}}]}}],
         "after": [{0}]}})",
      odd);
  std::vector<Pose> poses;
  const auto summary = parse_poses(text, [&](std::size_t, const Pose& pose) {
    poses.push_back(pose);
    return true;
  });
  ASSERT_TRUE(summary) << summary.error().json_pointer << summary.error().detail;
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].time_s, 1.0);
  ASSERT_EQ(poses[0].nodes.size(), 1u);
  EXPECT_EQ(poses[0].nodes[0].world[13], 5.0);
}

TEST(pose_stream, of_two_values_of_one_key_the_last_one_counts) {
  const std::string world = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
  std::vector<Pose> poses;
  const auto summary =
      parse_poses(with_samples(fmt::format(R"({{"time": 1, "time": 2, "nodes": [{{"node": 1, "world": {0}}}], "nodes":
                   [{{"node": 2, "world": [9, 9], "world": {0}}}], "weights": [{{"node": 1, "weights": [1, 2],
                   "weights": [3]}}], "skinned": []}})",
                                           world)),
                  [&](std::size_t, const Pose& pose) {
                    poses.push_back(pose);
                    return true;
                  });
  EXPECT_FALSE(summary) << "a matrix of two numbers is wrong, whatever follows";
  EXPECT_EQ(summary.error().json_pointer, "/clips/0/samples/0/nodes/0/world");
  EXPECT_TRUE(poses.empty());
  const std::string twice =
      R"({"time": 1, "time": 2, "nodes": [], "nodes": [], "weights": [{"node": 4, "weights": [1, 2], "weights": [3]}],
          "skinned": []})";
  ASSERT_TRUE(parse_poses(with_samples(twice), [&](std::size_t, const Pose& pose) {
    poses.push_back(pose);
    return true;
  }));
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].time_s, 2.0);
  EXPECT_THAT(poses[0].weights[0].weights, ElementsAre(3.0));
}

TEST(pose_stream, a_text_that_is_no_json_is_told_from_one_with_a_wrong_value) {
  const std::string wrong = R"({"clips": [{"clip": 0, "samples": 5}]})";
  ASSERT_FALSE(parse_poses(wrong));
  EXPECT_EQ(parse_poses(wrong).error().rule, "pose-format");
  for (const std::string& text :
       {wrong + "}", wrong.substr(0, wrong.size() - 1), std::string("\0{}", 3), std::string("{\"clips\": []}\0", 14),
        std::string("{\"clips\": [1e999]}"), std::string("{\"clips\": [], \"\xff\": 1}"), std::string()}) {
    const auto read = parse_poses(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().rule, "pose-file") << text;
  }
  EXPECT_TRUE(parse_poses("\xEF\xBB\xBF{\"clips\": []}")) << "a byte order mark";
}

TEST(pose_stream, values_of_another_type_are_refused_where_they_are) {
  const auto complaint = [](const std::string& text) {
    const auto read = parse_poses(text);
    return read ? std::string("taken") : read.error().json_pointer + ": " + read.error().detail;
  };
  const auto sample = [&](const std::string& text) { return complaint(with_samples(text)); };
  EXPECT_EQ(complaint("5"), ": a pose file is an object");
  EXPECT_EQ(complaint(R"({"clips": {}})"), "/clips: an array is missing here");
  EXPECT_EQ(complaint(R"({"clips": [7]})"), "/clips/0/clip: an index or null is missing here");
  EXPECT_EQ(complaint(R"({"clips": [{"clip": [], "samples": []}]})"), "/clips/0/clip: is not an index");
  EXPECT_EQ(complaint(R"({"extent": {}, "clips": []})"), "/extent: is not a finite number of single precision");
  EXPECT_EQ(sample("[]"), "/clips/0/samples/0/time: a time is missing here");
  EXPECT_EQ(sample(R"({"time": 0, "bits": []})"), "/clips/0/samples/0/bits: is not an object of hashes");
  EXPECT_EQ(sample(R"({"time": 0, "bits": {"pose": 5}})"), "/clips/0/samples/0/bits/pose: is not a hash");
  EXPECT_EQ(sample(R"({"time": 0, "nodes": [{"node": 1.5}]})"), "/clips/0/samples/0/nodes/0/node: is not an index");
  EXPECT_EQ(sample(R"({"time": 0, "nodes": [{"node": 4294967295}]})"),
            "/clips/0/samples/0/nodes/0/node: is not an index");
  EXPECT_EQ(sample(R"({"time": 0, "nodes": [{"node": 1, "world": [1, [2]]}]})"),
            "/clips/0/samples/0/nodes/0/world/1: is not a finite number of single precision");
  const std::string head = R"({"time": 0, "nodes": [], "weights": [], "skinned": [{"node": 0, "primitive": 0, )";
  EXPECT_EQ(sample(head + R"("vertices": [0], "normals": ["x"]}]})"),
            "/clips/0/samples/0/skinned/0/normals/0: is not a vector of 3 numbers");
  EXPECT_EQ(sample(head + R"("vertices": [0], "tangents": [[1, 2, true, 4]]}]})"),
            "/clips/0/samples/0/skinned/0/tangents/0: is not a finite number of single precision");
  EXPECT_EQ(sample(head + R"("vertices": [0], "dqs": []}]})"),
            "/clips/0/samples/0/skinned/0/dqs: does not have one entry for each of the 1 vertices");
}

TEST(pose_stream, what_is_missing_is_named_for_each_kind_of_entry) {
  const auto missing = [](const std::string& text) {
    const auto read = parse_poses(with_samples(text));
    return read ? std::string("taken") : read.error().json_pointer + ": " + read.error().detail;
  };
  const std::string world = R"("world": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])", place = "/clips/0/samples/0/";
  const auto of = [](const std::string& nodes, const std::string& weights, const std::string& skinned) {
    return fmt::format(R"({{"time": 0, "nodes": [{}], "weights": [{}], "skinned": [{}]}})", nodes, weights, skinned);
  };
  const std::string primitive = R"({"node": 0, "primitive": 0, "vertices": []})";
  EXPECT_EQ(missing(of("{\"node\": 0, " + world + "}", R"({"node": 0, "weights": []})", primitive)), "taken");
  EXPECT_EQ(missing(of("5", "", "")), place + "nodes/0/node: an index is missing here");
  EXPECT_EQ(missing(of("", "5", "")), place + "weights/0/node: an index is missing here");
  EXPECT_EQ(missing(of("", "", "5")), place + "skinned/0/node: an index is missing here");
  EXPECT_EQ(missing(of("{" + world + "}", "", "")), place + "nodes/0/node: an index is missing here");
  EXPECT_EQ(missing(of(R"({"node": 0})", "", "")), place + "nodes/0/world: an array is missing here");
  EXPECT_EQ(missing(of("", R"({"weights": []})", "")), place + "weights/0/node: an index is missing here");
  EXPECT_EQ(missing(of("", R"({"node": 0})", "")), place + "weights/0/weights: an array is missing here");
  EXPECT_EQ(missing(of("", "", R"({"node": 0, "vertices": []})")),
            place + "skinned/0/primitive: an index is missing here");
  EXPECT_EQ(missing(of("", "", R"({"node": 0, "primitive": 0})")),
            place + "skinned/0/vertices: an array is missing here");
  EXPECT_EQ(missing(R"({"nodes": [], "weights": [], "skinned": []})"), place + "time: a time is missing here");
  EXPECT_EQ(missing(R"({"time": 0, "weights": [], "skinned": []})"), place + "nodes: an array is missing here");
  EXPECT_EQ(missing(R"({"time": 0, "nodes": [], "skinned": []})"), place + "weights: an array is missing here");
  EXPECT_EQ(missing(R"({"time": 0, "nodes": [], "weights": []})"), place + "skinned: an array is missing here");
  const auto no_samples = parse_poses(R"({"clips": [{"clip": 0}]})");
  ASSERT_FALSE(no_samples);
  EXPECT_EQ(no_samples.error().json_pointer, "/clips/0/samples");
}

TEST(pose_stream, of_several_faults_the_first_one_is_told) {
  const auto read = parse_poses(R"({"clips": [7, [[[[{"clip": []}]]]]], "extent": "far"})");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().json_pointer, "/clips/0/clip");
  EXPECT_EQ(read.error().rule, "pose-format");
}

TEST(pose_stream, nesting_takes_no_memory_of_its_own_and_is_bounded) {
  const std::string deep(100'000, '[');
  const auto read = parse_poses(R"({"x": )" + deep + std::string(deep.size(), ']') + R"(, "clips": []})");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().detail, HasSubstr("deep"));
  EXPECT_TRUE(parse_poses(R"({"x": )" + std::string(900, '[') + std::string(900, ']') + R"(, "clips": []})"));
}

/// Writes a pose file of the tests' model with so many samples of clip 1.
std::string pose_file(const ToolModelFile& model, int samples) {
  const std::string file = model.beside(std::to_string(samples) + ".json");
  const CommandOutcome outcome = run_tool(
      {"sample", model.path(), "--clip", "1", "--vertices", "all", "--fps", std::to_string(samples / 2), "-o", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return file;
}

TEST(pose_stream, verify_holds_one_pose_at_a_time_however_many_there_are) {
  const ToolModelFile model;
  const std::string few = pose_file(model, 20), many = pose_file(model, 2000);
  const auto peak = [&](const std::string& golden) {
    run_tool({"verify", model.path(), golden});  // what is allocated once
    const PeakMemory memory;
    EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0);
    return memory.bytes();
  };
  const std::size_t of_few = peak(few), of_many = peak(many);
  EXPECT_LE(of_many, of_few + 16 * 1024) << "with " << std::filesystem::file_size(many) << " bytes of poses";
}

TEST(pose_stream, verify_tells_a_clip_that_the_model_lacks) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  std::ofstream(golden) << R"({"clips": [{"clip": 9, "samples": []}, {"clip": 0, "samples": []}]})";
  const CommandOutcome outcome = run_tool({"verify", model.path(), golden});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("clip 9 (the file has 2): missing"));
}

}  // namespace
}  // namespace sinew::test
