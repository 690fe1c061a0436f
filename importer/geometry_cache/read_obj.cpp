// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/read_obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace sinew {
namespace {

/// Removes and returns the next word of a line; empty at the end.
std::string_view next_word(std::string_view& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  line.remove_prefix(first == std::string_view::npos ? line.size() : first);
  const std::size_t size = std::min(line.find_first_of(" \t\r"), line.size());
  const std::string_view word = line.substr(0, size);
  line.remove_prefix(size);
  return word;
}

template <class T>
std::optional<T> number(std::string_view word) {
  T value{};
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range && std::is_floating_point_v<T>) return T(INFINITY);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name) {}

  /// Reads a line; returns an error if it is invalid.
  std::optional<ImportError> read(std::string_view line) {
    ++line_;
    const std::string_view kind = next_word(line);
    if (kind == "v") return read_vertex(line);
    if (kind == "f") return read_face(line);
    return std::nullopt;
  }
  ObjMesh take() { return std::move(mesh_); }

 private:
  ImportError broken(const char* rule, const char* detail) const {
    return {name_, {Severity::error, rule, "", "line " + std::to_string(line_) + ": " + detail}, {}, {}};
  }

  std::optional<ImportError> read_vertex(std::string_view line) {
    glm::vec3 position;
    for (int axis = 0; axis < 3; ++axis) {
      const auto x = number<float>(next_word(line));
      if (!x) return broken("obj-syntax", "a vertex has no three numbers");
      if (!std::isfinite(*x)) return broken("obj-values", "a position is not finite");
      position[axis] = *x;
    }
    mesh_.positions.push_back(position);
    return std::nullopt;
  }

  std::optional<ImportError> read_face(std::string_view line) {
    std::vector<std::uint32_t> corners;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const auto index = number<std::int64_t>(word.substr(0, word.find('/')));
      if (!index) return broken("obj-syntax", "a corner of a face is no index");
      const auto count = static_cast<std::int64_t>(mesh_.positions.size());
      const std::int64_t vertex = *index < 0 ? count + *index : *index - 1;
      if (*index == 0 || vertex < 0 || vertex >= count)
        return broken("obj-index", "a face names a vertex that is not there before it");
      corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    if (corners.size() < 3) return broken("obj-syntax", "a face has fewer than three corners");
    for (std::size_t c = 2; c < corners.size(); ++c)
      mesh_.triangles.insert(mesh_.triangles.end(), {corners[0], corners[c - 1], corners[c]});
    return std::nullopt;
  }

  const std::string& name_;
  ObjMesh mesh_;
  std::size_t line_ = 0;
};

}  // namespace

ImportResult<ObjMesh> read_obj(std::string_view text, const std::string& name) {
  ObjReader reader(name);
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size());
    if (auto error = reader.read(text.substr(0, size))) return tl::unexpected(std::move(*error));
    text.remove_prefix(std::min(size + 1, text.size()));
  }
  ObjMesh mesh = reader.take();
  if (mesh.positions.empty())
    return tl::unexpected(ImportError{name, {Severity::error, "obj-empty", "", "there is no vertex"}, {}, {}});
  return mesh;
}

}  // namespace sinew
