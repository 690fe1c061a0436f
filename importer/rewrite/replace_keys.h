// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Keys to write, parallel to `scene.animations`, and the joint that the channels of each joint move with them.
struct NewKeys {
  std::span<const Animation> animations;
  std::span<const std::uint32_t> channels_to;  ///< [J] or empty: each its own
};

/// Gives the channels of each animation the keys of `keys.animations`. A channel
/// whose keys are those of the scene keeps its bytes; so does one that the importer ignored, and one that animates a
/// property other than translation, rotation, scale and weights. Channels of joints that other joints take over name
/// the node of these.
void replace_keys(const gltf::Document& document, const Scene& scene, const NewKeys& keys, Draft& draft);

}  // namespace sinew::rewrite
