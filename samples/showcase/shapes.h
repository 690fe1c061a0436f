// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>

#include "runtime/model/mesh.h"

namespace sinew::showcase {

/// A surface over (u, v) in [0, 1]^2, for example a point on a sphere by longitude and latitude.
using Surface = std::function<glm::vec3(float u, float v)>;

/// A grid of (columns + 1) x (rows + 1) vertices on the surface, two triangles per cell, counter-clockwise if u x v
/// points outwards. Normals are area-weighted. Vertices at the same position share their normal, so that seams and
/// poles are smooth.
Primitive grid(const Surface& surface, std::uint32_t columns, std::uint32_t rows);

/// Axis-aligned box with flat faces.
Primitive box(const glm::vec3& centre, const glm::vec3& half_size);

Primitive sphere(const glm::vec3& centre, float radius, std::uint32_t columns = 32, std::uint32_t rows = 16);

/// A closed solid of revolution around +Y.
/// eq   radius(v) at height base.y + v * height, v in [0, 1]
Primitive lathe(const glm::vec3& base, float height, const std::function<float(float v)>& radius,
                std::uint32_t columns = 32, std::uint32_t rows = 16);

/// Appends the vertices and triangles of `part`; both must have the same attributes.
void append(Primitive& whole, const Primitive& part);

/// Area-weighted normals for `positions`. Vertices of `primitive` with the same rest position share a normal.
std::vector<glm::vec3> smooth_normals(const Primitive& primitive, const std::vector<glm::vec3>& positions);

}  // namespace sinew::showcase
