// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sinew::ozz {

/// Counts numbers that ozz-animation 0.16 (commit 6cbdc79) expects in its own unit tests, compared with those of sinew.
struct Tally {
  int same = 0;     ///< within the tolerance
  int by_rule = 0;  ///< other numbers, where a rule in sinew's documentation differs from that of ozz

  friend bool operator==(const Tally&, const Tally&) = default;
  Tally& operator+=(const Tally& other) {
    same += other.same;
    by_rule += other.by_rule;
    return *this;
  }
};

/// Relative to the number, or to 1 for smaller numbers.
inline constexpr double kTolerance = 1e-5;
/// Numbers of rotations: ozz computes some of them with estimated square roots.
inline constexpr double kRotationTolerance = 1e-3;

/// Counts one number. Without a rule that explains it, a difference is a failure of the running test.
inline void compare(double found, double expected, double tolerance, Tally& tally, const char* rule = nullptr) {
  if (std::abs(found - expected) <= tolerance * std::max(1.0, std::abs(expected)))
    ++tally.same;
  else if (rule != nullptr)
    ++tally.by_rule;
  else
    ADD_FAILURE() << "found " << found << ", ozz has " << expected;
}

/// Counts the numbers of a rotation; q and -q are equal.
template <class Q>
void compare_rotation(const Q& found, const Q& expected, Tally& tally, const char* rule = nullptr,
                      double tolerance = kRotationTolerance) {
  const double dot = double(found.x * expected.x + found.y * expected.y + found.z * expected.z + found.w * expected.w);
  for (int c = 0; c < 4; ++c)
    compare(std::copysign(1.0, dot) * double(found[c]), double(expected[c]), tolerance, tally, rule);
}

// Groups of tests, one function for each.
Tally sampling_group();
Tally sampling_few_keys_group();
Tally blend_weights_group();
Tally blend_joint_weights_group();
Tally blend_normalised_group();
Tally blend_threshold_group();
Tally additive_group();
Tally additive_joint_weights_group();
Tally model_matrices_group();
Tally model_ranges_group();
Tally skinning_group();
Tally skinning_strides_group();
Tally extraction_group();
Tally motion_blending_group();
Tally limb_corrections_group();
Tally limb_poles_group();
Tally limb_reach_group();
Tally limb_shapes_group();
Tally aim_corrections_group();
Tally aim_directions_group();
Tally aim_offsets_group();
Tally aim_limits_group();
Tally float_tracks_group();
Tally vector_tracks_group();
Tally rotation_tracks_group();
Tally track_edges_group();

}  // namespace sinew::ozz
