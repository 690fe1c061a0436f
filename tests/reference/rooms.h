// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "tests/reference/ray_cast.h"
#include "tests/support/fixed_random.h"

namespace sinew::reference {

/// A floor in the plane y = 0 with walls 1 m from its middle: always on the left, on request behind and on the right.
std::vector<RayTriangle> room(double height, bool behind, bool right);

/// A random direction over the half sphere about n, with density proportional to its cosine to n.
glm::dvec3 scattered(const glm::dvec3& n, test::FixedRandom& random);

/// Shares of the light paths that end in the sky after 0, 1, 2 ... bounces.
using Paths = std::array<double, 16>;

/// Adds one path that begins at `from` in `direction`; every surface it meets scatters it.
void add_path(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, const glm::dvec3& direction,
              double weight, test::FixedRandom& random, Paths& out);

/// Light that arrives along these paths from a white sky when every surface scatters the share `albedo`.
double light_of(const Paths& paths, double albedo);

}  // namespace sinew::reference
