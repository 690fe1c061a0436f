// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "importer/ambient/bake_ambient_visibility.h"

namespace sinew::reference {

/// Ambient visibility of each vertex in plain double precision: every ray tries every triangle. The rays are those of
/// importer/ambient/visibility_rays.h, so that the only difference from bake_ambient_visibility() is whether a ray is
/// blocked.
/// eq   sum of angle_f * open_f over the faces of the vertex / sum of angle_f
/// cost O(V * rays * T)
std::vector<std::vector<double>> ambient_visibility(std::span<const VisibilitySurface> surfaces,
                                                    const VisibilityOptions& options);

}  // namespace sinew::reference
