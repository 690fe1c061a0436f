// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Appends animations of joints behind those of the document. A node whose matrix is now animated gets the translation,
/// rotation and scale of it; what they cannot say is a loss ("node-matrix-animated").
void add_animations(const Scene& scene, std::span<const Animation> animations, Draft& draft);

}  // namespace sinew::rewrite
