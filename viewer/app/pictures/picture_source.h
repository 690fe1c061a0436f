// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "viewer/app/headless.h"

namespace sinew::viewer {

/// Pictures of a command line: of one scene, or of several evaluations of it side by side.
class PictureSource {
 public:
  virtual ~PictureSource() = default;

  /// Renders a single picture, evaluated exactly at its time.
  /// in   turn_rad  the camera goes around what it looks at by this angle, counter-clockwise seen from above
  virtual Picture at(double time_s, double turn_rad) = 0;

  /// Renders picture number `picture` of a sequence; `time_of` returns the clip time of each number.
  virtual Picture in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) = 0;

  /// One sentence if the last picture could not show the geometry cache; else empty.
  virtual std::string fault() const = 0;
};

}  // namespace sinew::viewer
