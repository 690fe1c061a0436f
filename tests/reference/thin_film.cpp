// SPDX-License-Identifier: MIT
#include "tests/reference/thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew::reference {
namespace {

constexpr double kPi = std::numbers::pi, kWhite = 1.0685e-7;

/// A Gaussian of the extension: height, middle and variance.
struct Bell {
  int channel;
  double height, middle, variance;
};
constexpr Bell kBells[] = {{0, 5.4856e-13, 1.6810e6, 4.3278e9},
                           {0, 9.7470e-14, 2.2399e6, 4.5282e9},
                           {1, 4.4201e-13, 1.7953e6, 9.3046e9},
                           {2, 5.2481e-13, 2.2084e6, 6.6121e9}};

double schlick(double f0, double cosine) { return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0); }

double between(double a, double b) { return std::pow((a - b) / (a + b), 2.0); }

/// Response of each channel to cos(2 pi path / wavelength + shift), linear sRGB.
glm::dvec3 response(double path_m, const glm::dvec3& shift) {
  glm::dvec3 xyz(0.0);
  const double phase = 2.0 * kPi * path_m;
  for (const Bell& bell : kBells)
    xyz[bell.channel] += bell.height * std::sqrt(2.0 * kPi * bell.variance) *
                         std::cos(bell.middle * phase + shift[bell.channel]) * std::exp(-bell.variance * phase * phase);
  return srgb_from_xyz(xyz / kWhite);
}

}  // namespace

glm::dvec3 eye_sensitivity(double per_metre) {
  glm::dvec3 xyz(0.0);
  for (const Bell& bell : kBells)
    xyz[bell.channel] += bell.height / std::sqrt(2.0) *
                         std::exp(-std::pow(per_metre - bell.middle, 2.0) / (4.0 * bell.variance)) / kWhite;
  return xyz;
}

glm::dvec3 srgb_from_xyz(const glm::dvec3& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z, -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

glm::dvec3 film_reflectance(const ThinFilm& film, const glm::dvec3& f0, double cosine) {
  const double t = std::clamp(film.thickness_nm / 30.0, 0.0, 1.0);  // thinner films fade
  const double ior = 1.0 + (film.ior - 1.0) * t * t * (3.0 - 2.0 * t);
  const double inside2 = 1.0 - (1.0 - cosine * cosine) / (ior * ior);
  if (inside2 < 0.0) return glm::dvec3(1.0);
  const double outer = schlick(between(ior, 1.0), cosine), passed = 1.0 - outer;
  glm::dvec3 shift(0.0), product(0.0), returned(0.0);
  for (int c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(f0[c], 0.0, 0.9999)), below = (1.0 + root) / (1.0 - root);
    const double inner = schlick(between(below, ior), std::sqrt(inside2));
    shift[c] = (ior >= 1.0 ? kPi : 0.0) + (below < ior ? kPi : 0.0);
    product[c] = std::clamp(outer * inner, 1e-5, 0.9999);
    returned[c] = passed * passed * inner / (1.0 - product[c]);
  }
  glm::dvec3 sum = glm::dvec3(outer) + returned;
  for (int m = 1; m <= 2; ++m) {
    const glm::dvec3 wave =
        response(m * 2.0 * ior * film.thickness_nm * 1e-9 * std::sqrt(inside2), static_cast<double>(m) * shift);
    for (int c = 0; c < 3; ++c) sum[c] += 2.0 * (returned[c] - passed) * std::pow(product[c], 0.5 * m) * wave[c];
  }
  for (int c = 0; c < 3; ++c) sum[c] = std::max(sum[c], 0.0);
  return sum;
}

glm::dvec3 normal_reflectance(const glm::dvec3& reflectance, double cosine) {
  const double edge = std::min(std::pow(1.0 - cosine, 5.0), 0.9999);
  glm::dvec3 f0;
  for (int c = 0; c < 3; ++c) f0[c] = std::clamp((reflectance[c] - edge) / (1.0 - edge), 0.0, 1.0);
  return f0;
}

}  // namespace sinew::reference
