// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Appends animations to those of the document. The matrix of a newly animated node is replaced by translation,
/// rotation and scale; shear is a loss ("node-matrix-animated").
void add_animations(const Scene& scene, std::span<const Animation> animations, Draft& draft);

}  // namespace sinew::rewrite
