// SPDX-License-Identifier: MIT
#include "tests/importer/tool_model.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "importer/tool/commands.h"

namespace sinew::test {
namespace {

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return out;
}

/// Collects accessors, each with a buffer view of its own.
class Buffer {
 public:
  int add(const char* type, std::size_t width, const std::vector<float>& values) {
    return add(type, 5126, values.size() / width,
               std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
  }
  int add_bytes(const char* type, std::size_t width, const std::vector<std::uint8_t>& values) {
    return add(type, 5121, values.size() / width, std::string(values.begin(), values.end()));
  }
  std::string json() const {
    return fmt::format(R"("accessors": [{}], "bufferViews": [{}], "buffers": [{{"byteLength": {}, "uri": )"
                       R"("data:application/octet-stream;base64,{}"}}])",
                       accessors_, views_, bytes_.size(), base64(bytes_));
  }

 private:
  int add(const char* type, int component, std::size_t count, const std::string& bytes) {
    const char* comma = count_ ? ", " : "";
    views_ +=
        fmt::format(R"({}{{"buffer": 0, "byteOffset": {}, "byteLength": {}}})", comma, bytes_.size(), bytes.size());
    accessors_ += fmt::format(R"({}{{"bufferView": {}, "componentType": {}, "count": {}, "type": "{}"{}}})", comma,
                              count_, component, count, type, bounds(type, component, bytes));
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    return count_++;
  }
  /// Writes min and max, which glTF demands for positions and key times.
  static std::string bounds(const std::string& type, int component, const std::string& bytes) {
    if (component != 5126 || (type != "VEC3" && type != "SCALAR")) return "";
    const std::size_t width = type == "VEC3" ? 3 : 1;
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    std::vector<float> lower(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), upper = lower;
    for (std::size_t i = 0; i < values.size(); ++i) {
      lower[i % width] = std::min(lower[i % width], values[i]);
      upper[i % width] = std::max(upper[i % width], values[i]);
    }
    return fmt::format(R"(, "min": [{}], "max": [{}])", fmt::join(lower, ", "), fmt::join(upper, ", "));
  }

  std::string accessors_, views_, bytes_;
  int count_ = 0;
};

}  // namespace

std::string tool_model() {
  Buffer buffer;
  const int strip = buffer.add("VEC3", 3, {0, 0, 0, 0, 1, 0, 0, 1.5f, 0, 0, 2, 0});
  const int normals = buffer.add("VEC3", 3, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
  const int joints = buffer.add_bytes("VEC4", 4, {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const int weights = buffer.add("VEC4", 4, {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  const int binds = buffer.add(
      "MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  const int face = buffer.add("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int first = buffer.add("VEC3", 3, {0, 0, 1, 0, 0, 0, 0, 0, 0});
  const int second = buffer.add("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, 4, 0});
  const int one_second = buffer.add("SCALAR", 1, {0, 1});
  const float half = 0.707106781f;
  const int bend = buffer.add("VEC4", 4, {0, 0, 0, 1, 0, 0, half, half});
  const int two_seconds = buffer.add("SCALAR", 1, {0, 2});
  const int talk = buffer.add("SCALAR", 1, {0, 0, 1, 0.5f});
  const std::string meshes = fmt::format(
      R"("meshes": [{{"name": "strip", "primitives": [{{"mode": 0, "attributes":
          {{"POSITION": {}, "NORMAL": {}, "JOINTS_0": {}, "WEIGHTS_0": {}}}}}]}},
          {{"name": "face", "weights": [0.25, 0], "primitives": [{{"attributes": {{"POSITION": {}}},
            "targets": [{{"POSITION": {}}}, {{"POSITION": {}}}]}}]}}],
         "skins": [{{"joints": [1, 2], "inverseBindMatrices": {}}}])",
      strip, normals, joints, weights, face, first, second, binds);
  const std::string animations = fmt::format(
      R"("animations": [{{"name": "bend", "samplers": [{{"input": {}, "output": {}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 2, "path": "rotation"}}}}]}},
          {{"name": "talk", "samplers": [{{"input": {}, "output": {}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 3, "path": "weights"}}}}]}}])",
      one_second, bend, two_seconds, talk);
  return fmt::format(
      R"({{"asset": {{"version": "2.0", "generator": "sinew tests"}}, "scene": 0, "scenes": [{{"nodes": [0, 1, 3]}}],
          "nodes": [{{"name": "strip", "mesh": 0, "skin": 0}}, {{"name": "root", "children": [2]}},
            {{"name": "tip", "translation": [0, 1, 0]}},
            {{"name": "face", "mesh": 1, "translation": [2, 0, 0], "scale": [1, 2, 1]}}],
          {}, {}, {}}})",
      meshes, animations, buffer.json());
}

ToolModelFile::ToolModelFile() {
  std::string pattern = (std::filesystem::temp_directory_path() / "sinew-test-XXXXXX").string();
  folder_ = mkdtemp(pattern.data());
  std::ofstream(path(), std::ios::binary) << tool_model();
}

ToolModelFile::~ToolModelFile() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

CommandOutcome run_tool(const std::vector<std::string>& arguments) {
  setenv("SINEW_CACHE", "none", 0);  // a test computes what it tests
  std::vector<const char*> argv = {"sinew"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  CommandOutcome outcome;
  outcome.status = static_cast<int>(tool::run_command_line(static_cast<int>(argv.size()), argv.data()));
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

}  // namespace sinew::test
