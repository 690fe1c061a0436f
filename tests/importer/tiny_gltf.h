// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "tests/support/json.h"

namespace sinew::test {

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

std::string base64(const std::vector<std::byte>& bytes);

/// Builds a document: JSON that tests may change, and one buffer, which is written as a data URI.
class TinyGltf {
 public:
  Json root{{"asset", {{"version", "2.0"}}}};

  /// Appends values as a new view with an accessor; returns the accessor's index.
  template <class T>
  std::size_t add(const std::vector<T>& values, const char* type, int component_type, std::size_t components,
                  bool normalized = false) {
    return add_accessor(add_view(values), type, component_type, values.size() / components, normalized);
  }

  template <class T>
  std::size_t add_view(const std::vector<T>& values) {
    return add_bytes(std::as_bytes(std::span(values)));
  }

  std::size_t scalars(const std::vector<float>& v) { return add(v, "SCALAR", 5126, 1); }
  std::size_t vec3(const std::vector<float>& v) { return add(v, "VEC3", 5126, 3); }
  std::size_t vec4(const std::vector<float>& v) { return add(v, "VEC4", 5126, 4); }

  /// Key times with min and max, which glTF demands.
  std::size_t times(const std::vector<float>& v);

  /// Adds an animation with one channel on node 0.
  void animate(const char* path, std::size_t input, std::size_t output, const char* interpolation = "LINEAR");

  /// Adds node 0 with a mesh of one triangle.
  Json& add_triangle();

  /// Adds a triangle with a skin of two joints (nodes 1 and 2); `joints` and `weights` have four entries a vertex.
  Json& add_skinned_triangle(const std::vector<std::uint8_t>& joints, const std::vector<float>& weights);

  std::string text() const;

  ImportResult<ImportedFile> import(const ImportOptions& options = {}) const;

 private:
  std::size_t add_accessor(std::size_t view, const char* type, int component_type, std::size_t count, bool normalized);
  std::size_t add_bytes(std::span<const std::byte> bytes);

  std::vector<std::byte> bytes_;
};

/// "rule at /pointer" of an error, or "ok".
std::string outcome(const ImportResult<ImportedFile>& result);

/// The errors among the warnings of an import that succeeded without the broken parts: "rule at /pointer", joined by
/// ", ". Of a failed import its outcome().
std::string survived(const ImportResult<ImportedFile>& result);

/// True if the import succeeded with this warning at this place.
bool warns(const ImportResult<ImportedFile>& result, const std::string& rule, const std::string& json_pointer);

}  // namespace sinew::test
