// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Gives the channels of each animation the keys of `animations`, which is parallel to `scene.animations`. A channel
/// whose keys are those of the scene keeps its bytes; so does one that the importer ignored, and one that animates a
/// property other than translation, rotation, scale and weights.
void replace_keys(const gltf::Document& document, const Scene& scene, std::span<const Animation> animations,
                  Draft& draft);

}  // namespace sinew::rewrite
