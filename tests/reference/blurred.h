// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// The blended surfaces of a pixel: exposed light, unlit colours, and how much of the pixel they cover.
struct Layered {
  glm::dvec3 light{0.0}, unlit{0.0};
  double coverage = 0.0, lit = 0.0;

  double unlit_share() const { return coverage - lit; }
};
Layered operator+(const Layered& a, const Layered& b);
Layered operator*(double factor, const Layered& a);

/// A mip chain of a picture: each copy has half the size of the one before, down to one texel.
/// eq   each texel is the bilinear value of the larger copy at the texel's middle; where a side is even, the mean of 2 x 2
class Blurred {
 public:
  /// in   pixels  [width * height], the top row first
  Blurred(int width, int height, std::vector<Layered> pixels);

  /// The picture blurred for this roughness.
  /// eq   level = log2(height) * roughness, at most the last one; linear between two levels. A level from 1 on is read as
  ///      the mean of 4 x 4 texels with the weights of a cubic B-spline, level 0 as the pixel itself.
  /// in   x, y  pixels from the upper left corner;   between  true = level 0 is bilinear between pixels
  Layered at(double x, double y, double roughness, bool between = false) const;

 private:
  struct Copy {
    int width, height;
    std::vector<Layered> texels;

    const Layered& texel(int x, int y) const;  ///< coordinates beyond the edge give the texel at the edge
  };
  static Copy half_of(const Copy& larger);
  Layered smooth(const Copy& copy, double x, double y) const;
  Layered bilinear(double x, double y) const;  ///< of the picture itself

  std::vector<Copy> copies_;
};

}  // namespace sinew::reference
