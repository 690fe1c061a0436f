// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// One filter on a tilted plane, measured.
struct FilterTrial {
  std::string name;
  double error = 0.0;                ///< root mean square difference of light from the supersampled plane, in [0, 1]
  double error_turned = 0.0;         ///< the same with the texture turned by 45 degrees on the plane
  std::vector<double> milliseconds;  ///< GPU times of the pass that shades the plane; none without timestamps
  std::uint64_t texel_bytes = 0;     ///< of the texture with all its levels
};

/// One way to interpolate normals, measured on a sphere that fills the picture.
struct NormalTrial {
  std::string name;
  std::vector<double> milliseconds;         ///< as FilterTrial::milliseconds
  std::vector<double> milliseconds_mapped;  ///< the same with a normal map
};

struct ShadingStudy {
  std::string device;
  float max_anisotropy = 1.0f;  ///< of the device; filters that ask for more got this
  std::vector<FilterTrial> filters;
  std::vector<NormalTrial> normals;
};

/// Size of the pictures, samples along each side of a pixel of the truth, and number of repetitions.
struct ShadingEffort {
  std::uint32_t width = 320, height = 200, samples = 16;
  int repetitions = 15;

  /// A first impression within seconds.
  static ShadingEffort quick() noexcept { return {96, 64, 8, 3}; }
};

/// Draws a plane that reaches the horizon through every filter, and compares each pixel with the mean of samples x
/// samples points of it; and a sphere with both interpolations of normals. The ways take turns, so that disturbances of
/// the machine affect all alike.
/// err  DeviceError
/// cost seconds on a software device
ShadingStudy study_shading(Device& device, const ShadingEffort& effort);

}  // namespace sinew::viewer
