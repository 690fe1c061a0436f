// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/base/shared_array.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The names by which clips of a file bind to another skeleton or model, and what is at rest there. An empty name binds
/// to nothing.
///
///     joint                 its name
///     morph weight          "mesh/target"; a target without a name has its number: "mesh/2", and a mesh without one
///     the
///                           name of the joint that it is placed at
///     number of a property  "joint arm/visible", "material skin/base_color/2": the thing, the property, the component;
///                           of texture transforms the slot too: "material skin/base_color_texture/offset/0"
///
/// owns  the names, together with its copies
struct ClipChannels {
  std::uint64_t signature = 0;       ///< of the skeleton (animation/skeleton_signature.h)
  SharedArray<std::string> joints;   ///< [J]
  SharedArray<std::string> weights;  ///< [W]
  SharedArray<std::string> numbers;  ///< [P]
  ClipRest rest;
};

/// Those of a scene. Its rest numbers are those that its clips share.     cost O(J + W + P), allocates
ClipChannels clip_channels(const Scene& scene);

/// Those of a skeleton alone, without weights and properties.     cost O(J), allocates
ClipChannels clip_channels(const Skeleton& skeleton);

/// "material skin/base_color": the name of a property of a scene, without its components; empty where the thing that
/// has it is without a name.
std::string property_name(const Scene& scene, const PropertyTarget& target);

}  // namespace sinew
