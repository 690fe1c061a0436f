// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "importer/file/document.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The target of a KHR_animation_pointer, with indices of the file.
struct PointedProperty {
  enum class List : std::uint8_t { nodes, meshes, cameras, lights, materials };
  List list = List::nodes;
  std::uint32_t index = 0;
  std::string_view
      node_path;  ///< path of a node or mesh: translation, rotation, scale or weights; empty for other properties
  std::uint32_t element = kNone;  ///< index of a single weight; kNone = all
  PropertyTarget target;          ///< only if `node_path` is empty
};

/// Why a pointer cannot be used. `past_end`: only its index is out of range.
struct PointerFault {
  std::string text;
  bool past_end = false;
};
/// Parses a pointer of the glTF object model, such as "/materials/0/alphaCutoff". The runtime must support the
/// property, and it must exist in the file or have a default in glTF.
/// out   fault   the reason, if nothing is returned
std::optional<PointedProperty> read_property_pointer(const gltf::Document& document, std::string_view text,
                                                     PointerFault& fault);

/// True if the file defines a property or glTF has a default for it, so that a channel may point to it.
/// in    target   a property of `scene`, which was read from `document`
bool property_is_defined(const gltf::Document& document, const Scene& scene, const PropertyTarget& target);

/// The pointer to a property in a file written from `scene`: lists are in scene order, nodes are numbered by
/// Skeleton::node_of_joint.
std::string property_pointer(const PropertyTarget& target, const Scene& scene);

}  // namespace sinew
