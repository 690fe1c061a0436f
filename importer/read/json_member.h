// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "importer/file/document_materials.h"

/// Helpers to read unchecked JSON: extensions.
namespace sinew {

/// The member `name` of an object; null if `object` is null or not an object, or has no such member.
inline const gltf::Json* member(const gltf::Json* object, const char* name) {
  if (object == nullptr || !object->is_object()) return nullptr;
  const auto found = object->find(name);
  return found == object->end() ? nullptr : &*found;
}

/// The value as an index below `limit`; kNone if it is null or invalid.
inline std::uint32_t index_below(const gltf::Json* value, std::size_t limit) {
  const bool is_index =
      value != nullptr && value->is_number_unsigned() && value->get<std::uint64_t>() < std::uint64_t{limit};
  return is_index ? value->get<std::uint32_t>() : kNone;
}

}  // namespace sinew
