// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "importer/file/document.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The property that a pointer of KHR_animation_pointer names, in the file's indices.
struct PointedProperty {
  enum class List : std::uint8_t { nodes, meshes, cameras, lights, materials };
  List list = List::nodes;
  std::uint32_t index = 0;
  std::string_view
      node_path;  ///< translation, rotation, scale or weights of a node or mesh; empty for other properties
  std::uint32_t element = kNone;  ///< index of a single weight; kNone = all
  PropertyTarget target;          ///< only where `node_path` is empty
};

/// Why a pointer cannot be used. `past_end` is true when only its index is wrong.
struct PointerFault {
  std::string text;
  bool past_end = false;
};
/// Reads a pointer of the glTF object model such as "/materials/0/alphaCutoff". The runtime must have the property, and
/// the file must define it or glTF give it a default (G58).
/// out   fault   the reason, where nothing is returned
std::optional<PointedProperty> read_property_pointer(const gltf::Document& document, std::string_view text,
                                                     PointerFault& fault);

/// Whether a file defines a property, or glTF gives it a default, so that a channel may point to it.
/// in    target   of the scene that was read from the document
bool property_is_defined(const gltf::Document& document, const Scene& scene, const PropertyTarget& target);

/// The pointer that names a property in a file written from `scene`: lists are in the scene's order, nodes are numbered
/// by Skeleton::node_of_joint.
std::string property_pointer(const PropertyTarget& target, const Scene& scene);

}  // namespace sinew
