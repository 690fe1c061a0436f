// SPDX-License-Identifier: MIT
#include "importer/tool/cost/keys_in_bits.h"

#include <algorithm>
#include <cmath>

#include "runtime/clip/packed_keys.h"

namespace sinew::cost {
namespace {

/// From one tolerance to the next: fine enough that no bit is given away, since half a bit is a factor of 1.4.
constexpr double kStep = 1.1;

/// The largest difference of one component between two keys.
template <class V>
double range_of(const Track<V>& track) {
  double range = 0.0;
  for (int c = 0; c < static_cast<int>(sizeof(V) / sizeof(float)); ++c) {
    const auto [low, high] = std::minmax_element(track.values.begin(), track.values.end(),
                                                 [c](const V& a, const V& b) { return a[c] < b[c]; });
    range = std::max(range, static_cast<double>((*high)[c]) - static_cast<double>((*low)[c]));
  }
  return range;
}

/// The smallest tolerance, up to kStep, whose numbers fit.
template <class V>
double tolerance_for(const Track<V>& track, std::uint32_t bits) {
  if (track.key_count() < 2) return 0.0;
  const double range = range_of(track);
  for (double tolerance = std::ldexp(range, -static_cast<int>(bits) - 1); tolerance > 0.0 && tolerance <= 4.0 * range;
       tolerance *= kStep) {
    const std::optional<PackedTrack> packed = pack_keys(track, tolerance);
    if (packed && *std::max_element(packed->width.begin(), packed->width.end()) <= bits) return tolerance;
  }
  return 0.0;
}

}  // namespace

KeyTolerances keys_in_bits(const Animation& animation, std::uint32_t bits) {
  KeyTolerances out;
  for (const BoneAnimation& bone : animation.bones)
    out.bones.push_back(
        {tolerance_for(bone.translation, bits), tolerance_for(bone.rotation, bits), tolerance_for(bone.scale, bits)});
  return out;
}

}  // namespace sinew::cost
