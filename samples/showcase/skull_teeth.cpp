// SPDX-License-Identifier: MIT
#include "samples/showcase/skull_teeth.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "samples/showcase/shapes.h"
#include "samples/showcase/skull_bones.h"

namespace sinew::showcase {
namespace {

struct Crown {
  float width, depth, height;  ///< along the row, across it, from the bone to the biting edge
};

/// From the middle to the back: incisors, canine, premolars, molars.
constexpr Crown kUpperCrowns[] = {{0.86f, 0.62f, 1.10f}, {0.68f, 0.58f, 0.98f}, {0.76f, 0.76f, 1.12f},
                                  {0.70f, 0.86f, 0.92f}, {0.68f, 0.88f, 0.86f}, {1.02f, 1.05f, 0.80f},
                                  {0.96f, 1.00f, 0.74f}};
constexpr Crown kLowerCrowns[] = {{0.54f, 0.56f, 0.95f}, {0.60f, 0.58f, 0.98f}, {0.70f, 0.72f, 1.10f},
                                  {0.70f, 0.76f, 0.95f}, {0.72f, 0.80f, 0.88f}, {1.08f, 1.00f, 0.80f},
                                  {1.04f, 0.98f, 0.75f}};

/// Turns a circle into a square with round corners.
float squared(float x) { return std::copysign(std::pow(std::abs(x), 0.55f), x); }

/// A rounded box whose biting edge points to `up` and whose outer side points to `front`. Its root is as long as the
/// crown. It narrows in width towards the root, and in depth towards the edge.
Primitive tooth(const Crown& crown, const glm::vec3& neck, const glm::vec3& front, const glm::vec3& up) {
  const glm::vec3 along = glm::cross(up, front);
  Primitive out = sphere(glm::vec3(0.0f), 1.0f, 10, 8);
  for (glm::vec3& p : out.positions) {
    const float radius = glm::length(glm::vec2(p.x, p.z)), height = squared(p.y);
    const bool pole = radius < 1e-3f;
    const float x = pole ? 0.0f : squared(p.x / radius), z = pole ? 0.0f : squared(p.z / radius);
    const float size = 0.5f * std::pow(radius, 0.25f);
    p = neck + crown.height * height * up + crown.width * size * (0.94f + 0.06f * height) * x * along +
        crown.depth * size * (0.90f - 0.22f * height) * z * front;
  }
  out.normals = smooth_normals(out, out.positions);
  return out;
}

void add_row(Primitive& all, std::span<const Crown> crowns, const ToothRow& row, const glm::vec3& up) {
  float angle = 0.0f;
  for (const Crown& crown : crowns) {
    const auto half_a_tooth = [&] {
      return 0.5f * crown.width / glm::length(row.radii * glm::vec2(std::cos(angle), std::sin(angle)));
    };
    angle += half_a_tooth();
    const glm::vec2 place = row.radii * glm::vec2(std::sin(angle), std::cos(angle));
    const glm::vec2 out = glm::normalize(place / (row.radii * row.radii));
    for (const float side : {-1.0f, 1.0f})
      append(all, tooth(crown, {side * place.x, row.y, row.z + place.y}, {side * out.x, 0.0f, out.y}, up));
    angle += half_a_tooth();
  }
}

}  // namespace

Primitive skull_teeth() {
  Primitive all;
  add_row(all, kUpperCrowns, kUpperRow, {0.0f, -1.0f, 0.0f});
  add_row(all, kLowerCrowns, kLowerRow, {0.0f, 1.0f, 0.0f});
  return all;
}

}  // namespace sinew::showcase
