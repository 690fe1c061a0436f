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

/// Checked access to the JSON object of an extension, which gltf_shape.h does not cover. A field of the wrong type or
/// out of range is reported (extension-value) and treated as absent.
class ExtensionFields {
 public:
  /// Finds the extension `name` in the `extensions` of the object at `place`. Converts to false if there is none.
  ExtensionFields(const gltf::Json& extensions, const std::string& place, const char* name, IssueLog& log);

  explicit operator bool() const noexcept { return object_ != nullptr; }
  bool has(const char* field) const;

  /// A nested object, such as a texture.
  ExtensionFields object(const char* field) const;

  /// The objects of a nested array; empty if absent. Reports entries that are not objects.
  std::vector<ExtensionFields> list(const char* field) const;

  /// All members that are objects, with their names.
  std::vector<std::pair<std::string, ExtensionFields>> members() const;

  /// A string; empty if absent or of another type.
  std::string text(const char* field) const;

  /// The indices of an array; reports and drops those not below `limit`.
  std::vector<std::uint32_t> indices(const char* field, std::size_t limit) const;

  bool boolean(const char* field, bool fallback) const;

  double number(const char* field, double fallback, double lower = -kAny, double upper = kAny) const;

  /// Reads an array of `count` numbers; on error all of `out` stays unchanged.
  void numbers(const char* field, float* out, std::size_t count, double lower = -kAny, double upper = kAny) const;

  /// An index below `limit`; kNone if absent or invalid.
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
