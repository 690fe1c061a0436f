// SPDX-License-Identifier: MIT
// The fields of skeleton LODs, as asset_fields.h has those of models.
#pragma once
#include "runtime/asset_file/asset_fields.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

/// A skeleton LOD with the joints that are kept as numbers, 0 or 1.
struct StoredSkeletonLod {
  CompiledSkeletonLod lod;
  std::vector<std::uint8_t> kept;
};

auto fields(Is<StoredSkeletonLod> auto& s) {
  auto& [detail, tolerance_m, left_out, measured_m, worst_joint] = s.lod;
  return std::tie(s.kept, detail.held, tolerance_m, left_out, measured_m, worst_joint);
}

}  // namespace sinew
