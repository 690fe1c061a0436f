// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "importer/ambient/bake_ambient_visibility.h"

namespace sinew::reference {

/// Ambient visibility of each vertex in double precision, without any search structure: each ray tries each triangle.
/// The rays are those of importer/ambient/visibility_rays.h. So only the test whether a ray is blocked differs from
/// bake_ambient_visibility().
/// eq   sum of angle_f * open_f over the faces of the vertex / sum of angle_f
/// cost O(V * rays * T)
std::vector<std::vector<double>> ambient_visibility(std::span<const VisibilitySurface> surfaces,
                                                    const VisibilityOptions& options);

}  // namespace sinew::reference
