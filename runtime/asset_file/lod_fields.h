// SPDX-License-Identifier: MIT
// The fields of skeleton LODs; see asset_fields.h.
#pragma once
#include "runtime/asset_file/asset_fields.h"
#include "runtime/model/skeleton_lod.h"

namespace sinew {

/// A skeleton LOD; `kept` has its flags for kept joints as bytes, 0 or 1.
struct StoredSkeletonLod {
  CompiledSkeletonLod lod;
  std::vector<std::uint8_t> kept;
};

auto fields(Is<StoredSkeletonLod> auto& s) {
  auto& [detail, tolerance_m, left_out, measured_m, worst_joint] = s.lod;
  return std::tie(s.kept, detail.held, tolerance_m, left_out, measured_m, worst_joint);
}

}  // namespace sinew
