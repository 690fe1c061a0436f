// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/math/vectors.h"
#include "runtime/procedures/feet.h"

namespace sinew::tool {

/// Ground whose height changes along one horizontal direction: flat ground, a slope, stairs, or a list of heights.
struct GroundProfile {
  Vec3<double> direction{0.0, 0.0, 1.0};  ///< unit, horizontal
  double height_m = 0.0;                  ///< at the origin; for flat ground and slopes
  double slope = 0.0;                     ///< rise per metre
  double rise_m = 0.0, tread_m = 0.0;     ///< endless stairs, whose first step up is at the origin; 0 = none

  /// A list, if it is not empty: heights at increasing distances, or steps that begin there.
  std::vector<double> distances_m, heights_m;
  bool has_steps = true;

  GroundHit at(const Vec3<double>& place) const;

  /// Height of a body above its place: that of the ground without steps, as a capsule slides up stairs.
  double body_height(const Vec3<double>& place) const;

  /// As Ground::find asks for it. The profile must outlive the result.
  Ground ground() const noexcept;
};

/// Reads "0.1" (a height), "slope=DEGREES", "steps=RISExTREAD" or the name of a file with {"distances": [0, 1],
/// "heights": [0, 0.2], "steps": true, "direction": [x, z]}.
/// err   a sentence; for a file it names the file and the place in it
tl::expected<GroundProfile, std::string> read_ground(const std::string& text);

}  // namespace sinew::tool
