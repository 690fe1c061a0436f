// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew {

/// Which morph weight of one model follows which one of another.
struct WeightMap {
  std::vector<std::uint32_t> source_of;  ///< [W target] a weight of the source; kNone = it rests
  std::vector<std::string> not_found;    ///< morph targets of the source that the target lacks, each once
};

/// Maps morph targets of equal names, whatever their meshes: "jawOpen" of a face moves that of teeth and tongue, too.
/// Names are also equal that differ in capitals, in what is no letter or digit, and in a prefix that ends in a dot
/// ("Face.M_jawOpen" and "mJawOpen"). Where several targets of the source have the name, the one of a mesh of the same
/// name is taken, else the first. Targets without a name are not mapped.
/// cost O(W log W), allocates
WeightMap make_weight_map(const Scene& source, const Scene& target);

/// Weights of a frame of the source on the target.
/// in   weights  [W source]
/// out  out      [W target] those that follow one; the others stay as they are
/// cost O(W), no allocation
void retarget_weights(const WeightMap& map, std::span<const float> weights, std::span<float> out) noexcept;

/// The weight tracks of an animation of the source, as tracks of whole mesh instances of the target. Keys and
/// interpolation stay where an instance follows one track; targets that nothing moves have their rest weight. Where it
/// follows several tracks, there are linear keys at the key times of all of them.
/// out  retargeted  tracks of weights, in place of those that it had
/// cost O(keys * targets), allocates
void retarget_weights(const WeightMap& map, const Animation& animation, const Scene& source, const Scene& target,
                      Animation& retargeted);

}  // namespace sinew
