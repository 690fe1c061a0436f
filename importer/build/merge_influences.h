// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "importer/issue_log.h"
#include "importer/read/meshes.h"

namespace sinew {

/// The influences of every vertex after cleaning: sorted by falling weight, then by rising joint; no weight is zero, no
/// joint occurs twice, the sum is 1.
struct MergedInfluences {
  std::vector<std::uint32_t> first;  ///< [V + 1] into the arrays below
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
};

/// Joins all JOINTS_n / WEIGHTS_n sets of a primitive into one list for each vertex (G40).
/// eq       w'_j = sum of max(w, 0) of joint j / sum of all; weights up to 1e-20 count as zero (N26)
/// in       sets          each with four entries for each of `vertex_count` vertices
///          joint_limit   number of joints of the smallest skin that the mesh is used with
/// err      joint-index (G36)
/// warning  joint-index-unused; weights-sum, with the largest and the mean deviation (G38); weights-zero: joint slot 0
///          moves the vertex (G39); weights-negative: taken as zero; joint-repeated: weights are added (G41)
MergedInfluences merge_influences(std::span<const InfluenceSet> sets, std::size_t vertex_count,
                                  std::uint32_t joint_limit, const std::string& place, IssueLog& log);

}  // namespace sinew
