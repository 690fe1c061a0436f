// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Which morph weight of the source each morph weight of the target follows.
struct WeightMap {
  /// [W target] index of a weight of the source; kNone = the weight stays at rest
  std::vector<std::uint32_t> source_of;
  std::vector<std::string> not_found;  ///< names of source morph targets that the target lacks, each once
};

/// Maps morph targets of equal names, whatever their meshes: "jawOpen" of a face also moves teeth and tongue. Names are
/// compared without case, without characters that are no letter or digit, and without a prefix that ends in a dot:
/// "Face.M_jawOpen" equals "mJawOpen". If several targets of the source have the name, the one on a mesh of the same
/// name is taken, else the first. Targets without a name are not mapped.
/// cost O(W log W), allocates
SINEW_API WeightMap make_weight_map(const Scene& source, const Scene& target);

/// Retargets the morph weights of one frame.
/// in   weights  [W source]
/// out  out      [W target] only mapped weights are written
/// cost O(W), no allocation
SINEW_API void retarget_weights(const WeightMap& map, std::span<const float> weights, std::span<float> out) noexcept;

/// Retargets the weight tracks of an animation. The result has one track per mesh instance of the target. An instance
/// that follows a single track keeps its keys and interpolation. An instance that follows several tracks gets linear
/// keys at the key times of all of them. Unmapped morph targets keep their rest weight.
/// out  retargeted  its weight tracks are replaced
/// cost O(keys * targets), allocates
SINEW_API void retarget_weights(const WeightMap& map, const Animation& animation, const Scene& source,
                                const Scene& target, Animation& retargeted);

}  // namespace sinew
