// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "importer/file/document_materials.h"

/// Reading of JSON whose shape no table has checked: the extensions.
namespace sinew {

/// The member `name` of an object; null where `object` is null or no object, or has no such member.
inline const gltf::Json* member(const gltf::Json* object, const char* name) {
  if (object == nullptr || !object->is_object()) return nullptr;
  const auto found = object->find(name);
  return found == object->end() ? nullptr : &*found;
}

/// The value as an index below `limit`; kNone where it is null or no such index.
inline std::uint32_t index_below(const gltf::Json* value, std::size_t limit) {
  const bool is_index =
      value != nullptr && value->is_number_unsigned() && value->get<std::uint64_t>() < std::uint64_t{limit};
  return is_index ? value->get<std::uint32_t>() : kNone;
}

}  // namespace sinew
