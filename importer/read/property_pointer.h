// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "importer/file/document.h"
#include "runtime/model/scene.h"

namespace sinew {

/// What a pointer of KHR_animation_pointer names, in the file's indices.
struct PointedProperty {
  enum class List : std::uint8_t { nodes, meshes, cameras, lights, materials };
  List list = List::nodes;
  std::uint32_t index = 0;
  std::string_view node_path;     ///< translation, rotation, scale or weights of a node or mesh, else empty
  std::uint32_t element = kNone;  ///< one of the weights
  PropertyTarget target;          ///< where `node_path` is empty; its index is the file's
};

/// Reads a pointer of the glTF object model, "/materials/0/alphaCutoff". The property must be one that the runtime has,
/// and be defined or have a default in the file (G58). out  why the pointer means nothing here, in `fault`, when the
/// answer is empty;  `past_end` when its index is what is wrong
struct PointerFault {
  std::string text;
  bool past_end = false;
};
std::optional<PointedProperty> read_property_pointer(const gltf::Document& document, std::string_view text,
                                                     PointerFault& fault);

/// The pointer of a property of a scene whose lists are written in their order, nodes by Skeleton::node_of_joint.
std::string property_pointer(const PropertyTarget& target, const Scene& scene);

}  // namespace sinew
