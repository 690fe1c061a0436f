// SPDX-License-Identifier: MIT
// The approximation of iridescence that pictures are compared with, beside the waves that a film reflects.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/reference/thin_film.h"

namespace sinew::reference {
namespace {

/// eq   Airy: r = (a + b e^(i d)) / (1 + a b e^(i d)), amplitudes a and b of the outer and the inner side, phase d = 4
///      pi ior thickness / wavelength. |r|^2, weighted with the sensitivity of the eye.
glm::dvec3 summed_waves(const ThinFilm& film, double below_ior) {
  const double a = (1.0 - film.ior) / (1.0 + film.ior), b = (film.ior - below_ior) / (film.ior + below_ior);
  glm::dvec3 xyz(0.0);
  constexpr double step = 1e3;
  for (double per_metre = 0.8e6; per_metre < 3.0e6; per_metre += step) {
    const auto turn = std::polar(1.0, 4.0 * std::numbers::pi * film.ior * film.thickness_nm * 1e-9 * per_metre);
    xyz += eye_sensitivity(per_metre) * std::norm((a + b * turn) / (1.0 + a * b * turn)) * step;
  }
  return srgb_from_xyz(xyz);
}

TEST(thin_film, reflects_the_sum_of_the_waves_along_the_normal) {
  for (const double ior : {1.2, 1.33, 1.6, 2.0})
    for (const double thickness_nm : {100.0, 250.0, 400.0, 800.0})
      for (const double below : {1.1, 1.5, 2.5}) {
        const double f0 = std::pow((below - 1.0) / (below + 1.0), 2.0);
        const ThinFilm film{1.0, ior, thickness_nm};
        const glm::dvec3 waves = summed_waves(film, below), found = film_reflectance(film, glm::dvec3(f0), 1.0);
        // The extension's white is not exactly that of sRGB.
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(found[c], waves[c], 0.04) << ior << ' ' << thickness_nm << ' ' << below << ' ' << c;
      }
}

TEST(thin_film, of_no_thickness_reflects_along_the_normal_as_the_surface_does) {
  const glm::dvec3 f0(0.04, 0.3, 0.9), found = film_reflectance({1.0, 1.8, 0.0}, f0, 1.0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], f0[c], 0.01) << c;
}

TEST(thin_film, reflectance_along_the_normal_gives_back_that_of_the_angle) {
  for (const double cosine : {0.2, 0.7, 1.0})
    EXPECT_NEAR(normal_reflectance(glm::dvec3(0.3 + 0.7 * std::pow(1.0 - cosine, 5.0)), cosine).g, 0.3, 1e-12);
}

}  // namespace
}  // namespace sinew::reference
