// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "importer/ambient/access_surfaces.h"
#include "runtime/model/vertex_access.h"

namespace sinew {

/// The times of key poses spread evenly over a clip, the first and the last included.
/// eq   duration * i / (count - 1)
/// out  the time 0 alone for one pose, and for a clip that lasts no time
std::vector<double> key_pose_times(double duration_s, std::uint32_t count);

/// Bakes the values of key pose `index` behind those of the poses before it. A primitive that a pose does not show is
/// open in it, and one that none shows has no values.
/// err, cost  those of bake_ambient_access()
void bake_key_pose(const Scene& scene, const FrameResult& pose, std::size_t index, const AccessOptions& options,
                   VertexAccess& access);

}  // namespace sinew
