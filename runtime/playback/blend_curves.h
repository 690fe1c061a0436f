// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <type_traits>

#include "runtime/animation/annotations.h"

namespace sinew {

/// A curve of a clip that plays. Without keys (the clip has no curve of that name) the layer does not count.
template <class V>
struct CurveLayer {
  Curve<V> keys;
  double time_s = 0.0;
  float weight = 1.0f;  ///< >= 0
};

/// Blends a curve over clips that play at the same time.
/// eq   S = sum of the weights w_i of layers with keys, v_i their values, r the rest value
///      mean:      (sum w_i v_i + max(0, 1 - S) r) / max(1, S); rotations are aligned with r, and the result is
///                 normalised; a flag is true if true values have at least half of the weight
///      sum:       r + sum w_i v_i
///      heaviest:  v_i of the largest w_i, of equal ones the first; r if no weight is above 0
/// in   layers  curves that check(Curve) accepts
/// cost O(layers * log K), no allocation
template <class V>
V blend_curves(std::span<const CurveLayer<V>> layers, CurveBlend rule, const V& rest) noexcept {
  const CurveLayer<V>* heaviest = nullptr;
  float total = 0.0f;
  for (const CurveLayer<V>& layer : layers) {
    if (layer.keys.empty() || !(layer.weight > 0.0f)) continue;
    total += layer.weight;
    if (heaviest == nullptr || layer.weight > heaviest->weight) heaviest = &layer;
  }
  if (heaviest == nullptr) return rest;
  if (rule == CurveBlend::heaviest) return sample(heaviest->keys, heaviest->time_s);
  if constexpr (std::is_same_v<V, bool>) {
    float is_true = total < 1.0f && rest ? 1.0f - total : 0.0f;
    for (const CurveLayer<V>& layer : layers)
      if (!layer.keys.empty() && layer.weight > 0.0f && sample(layer.keys, layer.time_s)) is_true += layer.weight;
    return is_true >= 0.5f * (total < 1.0f ? 1.0f : total);
  } else {
    const float remainder = rule == CurveBlend::sum ? 1.0f : total < 1.0f ? 1.0f - total : 0.0f;
    V out = rest * remainder;
    for (const CurveLayer<V>& layer : layers) {
      if (layer.keys.empty() || !(layer.weight > 0.0f)) continue;
      V value = sample(layer.keys, layer.time_s);
      if constexpr (kIsRotation<V>) value = aligned_with(rest, value);
      out = out + value * layer.weight;
    }
    if constexpr (kIsRotation<V>) return normalised(out);
    return rule == CurveBlend::mean && total > 1.0f ? out * (1.0f / total) : out;
  }
}

}  // namespace sinew
