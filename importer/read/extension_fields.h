// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "importer/file/document_materials.h"
#include "importer/issue_log.h"

namespace sinew {

/// The JSON object of one extension, read field by field. A field of the wrong type or outside its range is reported
/// (extension-value) and treated as absent. The shape tables in gltf_shape.h do not cover extensions.
class ExtensionFields {
 public:
  /// Finds the extension `name` in the `extensions` of the object at `place`. Converts to false where there is none.
  ExtensionFields(const gltf::Json& extensions, const std::string& place, const char* name, IssueLog& log);

  explicit operator bool() const noexcept { return object_ != nullptr; }
  bool has(const char* field) const;

  /// An object inside this one, for example a texture.
  ExtensionFields object(const char* field) const;

  /// The objects of an array inside this one; empty where it is absent. Entries that are no objects are reported.
  std::vector<ExtensionFields> list(const char* field) const;

  /// The members of this object that are objects, with their names.
  std::vector<std::pair<std::string, ExtensionFields>> members() const;

  /// A string; empty where it is absent or of another type.
  std::string text(const char* field) const;

  /// Indices below `limit` in an array; others are reported and left out.
  std::vector<std::uint32_t> indices(const char* field, std::size_t limit) const;

  bool boolean(const char* field, bool fallback) const;

  double number(const char* field, double fallback, double lower = -kAny, double upper = kAny) const;

  /// Fills `count` numbers, or leaves all of them unchanged.
  void numbers(const char* field, float* out, std::size_t count, double lower = -kAny, double upper = kAny) const;

  /// An index below `limit`; kNone where it is absent or wrong.
  std::uint32_t index(const char* field, std::size_t limit) const;

  const gltf::Json& extensions() const;
  const std::string& place() const noexcept { return place_; }
  IssueLog& log() const noexcept { return log_; }

  static constexpr double kAny = std::numeric_limits<float>::max();

 private:
  ExtensionFields(const gltf::Json* object, std::string place, IssueLog& log)
      : object_(object), place_(std::move(place)), log_(log) {}
  const gltf::Json* find(const char* field) const;
  void complain(const char* field, const std::string& needed) const;

  const gltf::Json* object_ = nullptr;
  std::string place_;
  IssueLog& log_;
};

}  // namespace sinew
