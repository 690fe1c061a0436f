// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "tests/reference/ray_cast.h"
#include "tests/support/fixed_random.h"

namespace sinew::reference {

/// A floor in the plane y = 0 with walls 1 m from its middle: on the left, and where asked for behind and on the right.
std::vector<RayTriangle> room(double height, bool behind, bool right);

/// A direction over the half sphere, as often as its cosine to the normal is large.
glm::dvec3 scattered(const glm::dvec3& n, test::FixedRandom& random);

/// Shares of paths of light that end in the sky after 0, 1, 2 ... surfaces.
using Paths = std::array<double, 16>;

/// Adds one path from a point: it begins in this direction, and every surface scatters it.
void add_path(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, const glm::dvec3& direction,
              double weight, test::FixedRandom& random, Paths& out);

/// Light of paths in white light, where all surfaces scatter this share.
double light_of(const Paths& paths, double albedo);

}  // namespace sinew::reference
