// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// Input of ambient occlusion: depth (distance along -z) and view-space unit normal per pixel, rows from the top. Depth
/// 0 = nothing was drawn; a zero normal = a surface without normals.
struct DepthAndNormals {
  int width = 0, height = 0;
  std::vector<double> distance;
  std::vector<glm::dvec3> normals;
  double cot_x = 1.0, cot_y = 1.0;  ///< clip x = x * cot_x / distance, y likewise
  double near_m = 0.01;

  /// The view-space point seen through the middle of a pixel.
  glm::dvec3 point(int x, int y) const;
};

struct SsaoSettings {
  double radius = 0.5, epsilon = 0.01, fade_start = 0.2, fade_end = 1.0, power = 2.0;
  std::span<const glm::vec3> offsets;
  std::span<const glm::vec3> noise;  ///< [16] a tile of 4 x 4
  int step = 2;                      ///< pixels from one texel of the half-size result to the next
  int reach = 2;                     ///< of the blur, in texels
  bool keep_edges = true;            ///< the blur does not cross from one surface to another
};

/// Ambient visibility of every `step`-th pixel of a picture.
struct HalfVisibility {
  int width = 0, height = 0;
  std::vector<double> visibility;
  std::vector<glm::dvec3> bend;  ///< from the normal to the bent normal; empty = unknown
};

/// Ambient visibility of every pixel.
struct PixelVisibility {
  std::vector<double> visibility;
  std::vector<glm::dvec3> bend;
};

/// Ambient visibility by random samples in a sphere (SSAO).
/// eq   (1 - sum of fade(nearer by) * max(n . normalise(r - p), 0) / samples)^power
///      r = surface seen in the direction of p + radius * offset; nearer by = metres that r lies before that point
///      offsets are mirrored at the noise vector and flipped into the hemisphere of n
HalfVisibility ssao(const DepthAndNormals& image, const SsaoSettings& settings);

/// One direction of the blur. Weights are 1/2 1 1 1 1/2 (a longer reach has more ones), times the share to which a
/// texel is on the same surface. The mean bend is rescaled so that the bent normal has unit length.
/// eq   (n . other n)^4 * exp(-(distance from the tangent plane / scale)^2 / 2); scale = epsilon + 1/4 of the distance on
///      screen
HalfVisibility blurred(const DepthAndNormals& image, const SsaoSettings& settings, const HalfVisibility& half,
                       bool vertical);

/// Visibility and bend of every pixel: a mean of the half-size texels around it, weighted as in blurred(). Pixels where
/// nothing was drawn get visibility 1 and bend 0.
PixelVisibility full_size(const DepthAndNormals& image, const SsaoSettings& settings, const HalfVisibility& half);

}  // namespace sinew::reference
