// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "importer/issue_log.h"
#include "importer/read/meshes.h"

namespace sinew {

/// The cleaned influences of every vertex: sorted by decreasing weight, then increasing joint. No weight is zero, no
/// joint occurs twice, the sum is 1.
struct MergedInfluences {
  std::vector<std::uint32_t> first;  ///< [V + 1] index of each vertex's first influence in the arrays below
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
};

/// Merges all JOINTS_n / WEIGHTS_n sets of a primitive into one list for each vertex.
/// eq       w'_j = sum of max(w, 0) of joint j / sum of all; weights up to 1e-20 count as zero
/// in       sets          each has four entries for each of `vertex_count` vertices
///          joint_limit   joint count of the smallest skin used with the mesh
/// err      joint-index
/// warning  joint-index-unused; weights-sum, with the largest and mean deviation; weights-zero: joint slot 0 moves the
///          vertex; weights-negative: replaced by zero; joint-repeated: weights are added
MergedInfluences merge_influences(std::span<const InfluenceSet> sets, std::size_t vertex_count,
                                  std::uint32_t joint_limit, const std::string& place, IssueLog& log);

}  // namespace sinew
