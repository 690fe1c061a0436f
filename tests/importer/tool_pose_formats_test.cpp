// SPDX-License-Identifier: MIT
// `sinew sample` writes tables, and arrays for NumPy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "importer/tool/poses/npy.h"
#include "importer/tool/poses/pose_csv.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T number{};
  std::memcpy(&number, bytes.substr(at, sizeof number).data(), sizeof number);
  return number;
}

/// A .npy file taken apart by the rules of numpy.lib.format.
struct Npy {
  std::string header;
  std::string_view data;

  explicit Npy(std::string_view file) {
    EXPECT_EQ(file.substr(0, 8), std::string_view("\x93NUMPY\x01\x00", 8));
    const auto length = number_at<std::uint16_t>(file, 8);
    EXPECT_EQ((10 + length) % 64, 0) << "the data are aligned";
    header = file.substr(10, length);
    EXPECT_EQ(header.back(), '\n');
    data = file.substr(10 + length);
  }
  template <class T>
  std::vector<T> numbers() const {
    std::vector<T> out;
    for (std::size_t at = 0; at < data.size(); at += sizeof(T)) out.push_back(number_at<T>(data, at));
    return out;
  }
};

/// The stored files of a zip, found by its directory at the end.
std::map<std::string, std::string_view> files_of_zip(std::string_view zip) {
  const std::size_t end = zip.size() - 22;
  EXPECT_EQ(number_at<std::uint32_t>(zip, end), 0x06054b50u);
  const auto count = number_at<std::uint16_t>(zip, end + 10);
  std::size_t at = number_at<std::uint32_t>(zip, end + 16);
  std::map<std::string, std::string_view> files;
  for (int i = 0; i < count; ++i) {
    EXPECT_EQ(number_at<std::uint32_t>(zip, at), 0x02014b50u);
    const auto size = number_at<std::uint32_t>(zip, at + 24), local = number_at<std::uint32_t>(zip, at + 42);
    const auto name_size = number_at<std::uint16_t>(zip, at + 28);
    const std::string name(zip.substr(at + 46, name_size));
    EXPECT_EQ(number_at<std::uint32_t>(zip, local), 0x04034b50u);
    EXPECT_EQ(zip.substr(local + 30, name_size), name);
    files[name] = zip.substr(local + 30 + name_size, size);
    at += 46 + name_size;
  }
  EXPECT_EQ(at, end);
  return files;
}

struct Sampled {
  json poses;
  std::string written;
};

/// The same samples as JSON and in another format.
Sampled sampled(const ToolModelFile& model, const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"sample", model.path()};
  Sampled both{json::parse(run_tool({"sample", model.path(), "--vertices", "all"}).out), {}};
  arguments.insert(arguments.end(), {"-o", model.beside(out)});
  arguments.insert(arguments.end(), more.begin(), more.end());
  const CommandOutcome outcome = run_tool(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  both.written = text_of_file(model.beside(out));
  return both;
}

TEST(pose_formats, csv_has_a_row_for_each_node_and_time) {
  const ToolModelFile model;
  const auto [poses, csv] = sampled(model, "poses.csv");
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "clip,clip_name,time_s,node,node_name,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23");
  for (const json& clip : poses["clips"])
    for (const json& sample : clip["samples"])
      for (const json& node : sample["nodes"]) {
        ASSERT_TRUE(std::getline(lines, line));
        const char* const names[] = {"strip", "root", "tip", "face"};
        std::string expected = clip["clip"].is_null() ? ","
                                                      : std::to_string(clip["clip"].get<int>()) + ",\"" +
                                                            clip["name"].get<std::string>() + '"';
        expected += fmt::format(",{},{},\"{}\"", sample["time"].get<double>(), node["node"].get<int>(),
                                names[node["node"].get<int>()]);
        for (std::size_t row = 0; row < 3; ++row)
          for (std::size_t column = 0; column < 4; ++column)
            expected += fmt::format(",{:.9g}", node["world"][4 * column + row].get<double>());
        EXPECT_EQ(line, expected);
      }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(pose_formats, csv_fields_are_quoted_and_plain) {
  EXPECT_EQ(tool::csv_field("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(tool::csv_field("\x1b[2J\n"), R"("\x1b[2J\x0a")");
}

TEST(pose_formats, npy_is_one_array_of_world_matrices_by_rows) {
  const ToolModelFile model;
  const auto [poses, file] = sampled(model, "poses.npy");
  const Npy array(file);
  std::size_t samples = 0;
  std::vector<float> expected;
  for (const json& clip : poses["clips"])
    for (const json& sample : clip["samples"]) {
      ++samples;
      for (const json& node : sample["nodes"])
        for (std::size_t i = 0; i < 16; ++i) expected.push_back(node["world"][i % 4 * 4 + i / 4].get<float>());
    }
  EXPECT_THAT(array.header, HasSubstr("{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(samples) +
                                      ", 4, 4, 4), }"));
  EXPECT_EQ(array.numbers<float>(), expected);
}

TEST(pose_formats, npz_has_everything_that_json_has) {
  const ToolModelFile model;
  const auto [poses, zip] = sampled(model, "poses.npz", {"--vertices", "all"});
  const auto files = files_of_zip(zip);
  std::vector<double> times;
  std::vector<int> clips;
  std::map<std::string, std::vector<float>> expected;
  for (const json& clip : poses["clips"])
    for (const json& sample : clip["samples"]) {
      times.push_back(sample["time"].get<double>());
      clips.push_back(clip["clip"].is_null() ? -1 : clip["clip"].get<int>());
      for (const json& node : sample["weights"])
        for (const json& weight : node["weights"])
          expected["weights_" + node["node"].dump() + ".npy"].push_back(weight.get<float>());
      for (const json& p : sample["skinned"])
        for (const char* kind : {"positions", "normals", "dqs", "dqsNormals"})
          if (p.contains(kind))
            for (const json& vector : p[kind])
              for (const json& component : vector)
                expected["node" + p["node"].dump() + "_primitive" + p["primitive"].dump() + "_" + kind + ".npy"]
                    .push_back(component.get<float>());
    }
  EXPECT_EQ(Npy(files.at("time_s.npy")).numbers<double>(), times);
  EXPECT_EQ(Npy(files.at("clip.npy")).numbers<std::int32_t>(), clips);
  ASSERT_GE(expected.size(), 6u);
  for (const auto& [name, numbers] : expected) {
    ASSERT_TRUE(files.contains(name)) << name;
    EXPECT_EQ(Npy(files.at(name)).numbers<float>(), numbers) << name;
  }
  EXPECT_THAT(Npy(files.at("node0_primitive0_vertices.npy")).numbers<std::int32_t>(), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(Npy(files.at("node0_primitive0_positions.npy")).header,
              HasSubstr("'shape': (" + std::to_string(times.size()) + ", 4, 3)"));
  EXPECT_EQ(files.size(), expected.size() + 7)
      << "besides: world, time_s, clip, both names, vertices of two primitives";
}

TEST(pose_formats, texts_are_arrays_of_code_points) {
  const std::vector<std::string> names{"arm", "", "\xc3\xa9\xf0\x9f\xa6\xb4", "\xff"};
  EXPECT_EQ(tool::text_width(names), 3u);
  EXPECT_EQ(tool::text_width({}), 1u);
  EXPECT_EQ(tool::text_type(3), "<U3");
  std::vector<std::uint32_t> points;
  for (const std::string& name : names)
    for (std::size_t i = 0; i < 3; ++i) points.push_back(number_at<std::uint32_t>(tool::text_entry(name, 3), 4 * i));
  EXPECT_THAT(points, ElementsAre('a', 'r', 'm', 0, 0, 0, 0xe9, 0x1f9b4, 0, 0xfffd, 0, 0));
}

TEST(pose_formats, npz_names_clips_and_nodes_whole) {
  const ToolModelFile model;
  const auto [poses, zip] = sampled(model, "poses.npz");
  const auto files = files_of_zip(zip);
  const auto texts = [&](const char* array, std::size_t width) {
    std::vector<std::string> out;
    const std::vector<std::uint32_t> points = Npy(files.at(array)).numbers<std::uint32_t>();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % width == 0) out.emplace_back();
      if (points[i] != 0) out.back() += static_cast<char>(points[i]);
    }
    return out;
  };
  std::vector<std::string> clips;
  for (const json& clip : poses["clips"])
    clips.insert(clips.end(), clip["samples"].size(), clip["clip"].is_null() ? "" : clip["name"].get<std::string>());
  EXPECT_EQ(texts("clip_name.npy", 4), clips) << "bend and talk have four letters";
  EXPECT_THAT(texts("node_name.npy", 5), ElementsAre("strip", "root", "tip", "face"));
}

TEST(pose_formats, headers_of_any_length_end_where_the_data_are_aligned) {
  for (std::size_t length = 1; length < 300; ++length) {
    const std::string type(length, 'x'), file = tool::npy_head({"", type, {3}}) + "data";
    const Npy array(file);
    EXPECT_EQ(array.data, "data");
    EXPECT_THAT(array.header, HasSubstr("'shape': (3,), }")) << length;
  }
}

TEST(pose_formats, the_name_of_the_output_says_the_format_unless_an_option_does) {
  const ToolModelFile model;
  EXPECT_TRUE(json::accept(sampled(model, "poses.csv", {"--format", "json"}).written));
  EXPECT_TRUE(sampled(model, "poses", {"--format", "csv"}).written.starts_with("clip,"));
  EXPECT_TRUE(sampled(model, "poses.txt", {"--format", "npz"}).written.starts_with("PK"));
  EXPECT_TRUE(run_tool({"sample", model.path(), "--format", "csv"}).out.starts_with("clip,")) << "to stdout";
  EXPECT_EQ(run_tool({"sample", model.path(), "--format", "xml"}).status, 2);
  for (const auto& wrong : std::vector<std::vector<std::string>>{{"--vertices", "all"}, {"--skinning", "linear"}}) {
    std::vector<std::string> arguments{"sample", model.path(), "--format", "csv"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("hold nodes only"));
  }
}

}  // namespace
}  // namespace sinew::test
