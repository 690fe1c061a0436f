// SPDX-License-Identifier: MIT
#include "runtime/graph/graph_masks.h"

namespace sinew {
Result<std::vector<std::vector<float>>> make_graph_masks(const GraphTables& tables, const Skeleton& skeleton) {
  std::vector<std::vector<float>> masks;
  for (const GraphMask& mask : tables.masks) {
    std::vector<float>& weights = masks.emplace_back(skeleton.joint_count(), 0.0f);
    for (std::size_t i = 0; i < mask.joint_count; ++i) {
      const GraphMaskJoint& entry = tables.mask_joints[mask.first_joint + i];
      const auto joint = skeleton.find(tables.name_at(entry.name));
      if (!joint) return tl::make_unexpected(ErrorCode::index_out_of_range);
      weights[*joint] = entry.weight;
      if (!entry.below) continue;
      const std::vector<float> below = mask_below(skeleton, *joint);
      for (std::size_t j = 0; j < weights.size(); ++j)
        if (below[j] > 0.0f) weights[j] = entry.weight;
    }
  }
  return masks;
}

}  // namespace sinew
