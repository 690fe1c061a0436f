// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// The surfaces of a pixel over each other: light and unlit colours, and how much of the pixel they cover.
struct Layered {
  glm::dvec3 light{0.0}, unlit{0.0};
  double coverage = 0.0, lit = 0.0;

  double unlit_share() const { return coverage - lit; }
};
Layered operator+(const Layered& a, const Layered& b);
Layered operator*(double factor, const Layered& a);

/// A picture in copies of half the size each, down to one texel.
/// eq   each texel is the bilinear value of the larger copy at its middle; where a side is even, the mean of 2 x 2
class Blurred {
 public:
  /// in   pixels  [width * height], the top row first
  Blurred(int width, int height, std::vector<Layered> pixels);

  /// eq   of copies 1 and on the mean of 4 x 4 texels with the weights of a cubic B-spline, of the picture itself the
  ///      pixel; between two copies linearly. The copy is log2(height) times the roughness, at most the last
  /// in   x, y  pixels from the upper left corner
  Layered at(double x, double y, double roughness) const;

 private:
  struct Copy {
    int width, height;
    std::vector<Layered> texels;

    const Layered& texel(int x, int y) const;  ///< those beyond the edge are as those on it
  };
  static Copy half_of(const Copy& larger);
  Layered smooth(const Copy& copy, double x, double y) const;

  std::vector<Copy> copies_;
};

}  // namespace sinew::reference
