// SPDX-License-Identifier: MIT
// Point caches as other programs write them, and files of tests.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/vec3.hpp>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace sinew::test {

inline void add_word(std::vector<std::byte>& out, std::uint32_t word, bool big_endian) {
  for (unsigned k = 0; k < 4; ++k) out.push_back(std::byte(word >> (8 * (big_endian ? 3 - k : k)) & 0xff));
}
inline void add_number(std::vector<std::byte>& out, float number, bool big_endian) {
  add_word(out, std::bit_cast<std::uint32_t>(number), big_endian);
}
inline void add_points(std::vector<std::byte>& out, const std::vector<std::vector<glm::vec3>>& frames,
                       bool big_endian) {
  for (const auto& frame : frames)
    for (const glm::vec3& p : frame)
      for (int axis = 0; axis < 3; ++axis) add_number(out, p[axis], big_endian);
}

/// NewTek MDD.
inline std::vector<std::byte> mdd_file(const std::vector<std::vector<glm::vec3>>& frames,
                                       const std::vector<float>& times_s) {
  std::vector<std::byte> out;
  add_word(out, static_cast<std::uint32_t>(frames.size()), true);
  add_word(out, frames.empty() ? 0 : static_cast<std::uint32_t>(frames[0].size()), true);
  for (const float time_s : times_s) add_number(out, time_s, true);
  add_points(out, frames, true);
  return out;
}

/// 3ds Max PC2.
inline std::vector<std::byte> pc2_file(const std::vector<std::vector<glm::vec3>>& frames, float start, float step) {
  std::vector<std::byte> out;
  for (const char c : {'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', '\0'}) out.push_back(std::byte(c));
  add_word(out, 1, false);
  add_word(out, static_cast<std::uint32_t>(frames[0].size()), false);
  add_number(out, start, false);
  add_number(out, step, false);
  add_word(out, static_cast<std::uint32_t>(frames.size()), false);
  add_points(out, frames, false);
  return out;
}

inline std::vector<std::byte> read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  const auto view = std::as_bytes(std::span(bytes));
  return {view.begin(), view.end()};
}

inline void write_file(const std::string& path, std::span<const std::byte> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}
inline void write_file(const std::string& path, const std::string& text) {
  write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace sinew::test
