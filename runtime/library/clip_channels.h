// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "runtime/base/api.h"
#include "runtime/base/shared_array.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The channels that clips of a file can move: joints, morph weights and components of properties. They bind to another
/// skeleton or model by these names. An empty name binds to nothing.
///
///     joint                  the name of the joint
///     morph weight           "mesh/target"; a target without a name has its number ("mesh/2"), and a mesh without a
///                            name has that of its joint
///     component of property  "joint arm/visible", "material skin/base_color/2"; of a texture transform with the
///                            slot: "material skin/base_color_texture/offset/0"
///
/// owns  the names, together with its copies
struct ClipChannels {
  std::uint64_t signature = 0;       ///< signature of the skeleton (animation/skeleton_signature.h)
  SharedArray<std::string> joints;   ///< [J] name of each joint
  SharedArray<std::string> weights;  ///< [W] name of each morph weight
  SharedArray<std::string> numbers;  ///< [P] name of each component of a property
  ClipRest rest;
};

/// The channels of a scene. They share the rest values of its clips.     cost O(J + W + P), allocates
SINEW_API ClipChannels clip_channels(const Scene& scene);

/// The channels of a skeleton alone, without weights and properties.     cost O(J), allocates
SINEW_API ClipChannels clip_channels(const Skeleton& skeleton);

/// The name of a property without its component: "material skin/base_color". Empty if its joint, camera, light or
/// material has no name.
SINEW_API std::string property_name(const Scene& scene, const PropertyTarget& target);

}  // namespace sinew
