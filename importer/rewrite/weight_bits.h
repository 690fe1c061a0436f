// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <set>

#include "importer/rewrite/draft.h"
#include "runtime/model/scene.h"

namespace sinew::rewrite {

/// Weights are stored in 8 bits if that moves no vertex by more than this share of the model's size, else in 16 bits.
inline constexpr double kWeightsMove = 1e-3;

/// Rounds four weights to multiples of 1 / `most` that have the sum 1. Each goes to the nearest multiple. The weights
/// that moved farthest take the part that is missing. Weights of the sum 0 stay 0.
/// out  multiples, 0 to `most`
std::array<double, 4> rounded_weights(const std::array<float, 4>& weights, double most);

/// The accessors of weights that need 16 bits (kWeightsMove), judged in the rest pose and in poses of all clips.
/// cost O(vertices x poses), at most 64 poses
std::set<std::uint32_t> weights_of_16_bits(const gltf::Document& document, const Scene& scene, Draft& draft);

}  // namespace sinew::rewrite
