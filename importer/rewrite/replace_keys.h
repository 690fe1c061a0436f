// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Replacement keys, parallel to `scene.animations`, and the new target joint of each joint's channels.
struct NewKeys {
  std::span<const Animation> animations;
  std::span<const std::uint32_t> channels_to;  ///< [J]; empty = unchanged
};

/// Replaces the keys of all channels by `keys.animations`. A channel whose keys equal those of the scene keeps its
/// bytes. So do ignored channels, and channels of properties other than translation, rotation, scale and weights. A
/// channel whose target has no keys any more is removed, unless it or its sampler has extras or extensions.
/// Channels are redirected to the nodes of their new target joints. With `channels_to`, tracks of joints that no
/// channel moves become channels.
void replace_keys(const gltf::Document& document, const Scene& scene, const NewKeys& keys, Draft& draft);

}  // namespace sinew::rewrite
