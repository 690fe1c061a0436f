// SPDX-License-Identifier: MIT
#include "importer/tool/cost/normal_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew::cost {
namespace {

using Vec = glm::dvec3;

double angle(const Vec& a, const Vec& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// The point at fraction t of the chord from a to b.
Vec between(const Vec& a, const Vec& b, double t) { return (1.0 - t) * a + t * b; }

/// The point at fraction t of the great arc from a to b, whose angle is `whole`.
Vec slerp(const Vec& a, const Vec& b, double whole, double t) {
  return (a * std::sin((1.0 - t) * whole) + b * std::sin(t * whole)) / std::sin(whole);
}

/// The unit vector halfway between the unit vector n and the axis +z. n must not be -z.
Vec half_way(const Vec& n) { return glm::normalize(Vec(n.x, n.y, 1.0 + n.z)); }

/// The mirror image of the axis +z about h.
Vec normal_of(const Vec& h) { return h * (2.0 * h.z / glm::dot(h, h)) - Vec(0.0, 0.0, 1.0); }

/// The vector in a view whose z axis is axis `view` / 2, in the opposite direction for odd views.
Vec seen(const Vec& n, int view) {
  const int z = view / 2;
  const double side = view % 2 == 0 ? 1.0 : -1.0;
  return {n[(z + 1) % 3], side * n[(z + 2) % 3], side * n[z]};
}

class Angles {
 public:
  void add_edge(const Vec& a, const Vec& b) {
    const double whole = angle(a, b);
    if (!(whole > 1e-6)) return;  // no arc; opposite normals are never seen at once
    for (int view = 0; view < 6; ++view) {
      const Vec from = seen(a, view), to = seen(b, view);
      if (from.z > 0.0 && to.z > 0.0) add(from, to, whole);
    }
  }
  NormalAngles angles() const {
    NormalAngles mean = sum_;
    const double degrees = 180.0 / std::numbers::pi,
                 share = degrees / static_cast<double>(std::max(sum_.samples, std::size_t{1}));
    for (ArcError* error : {&mean.linear, &mean.quaternion}) {
      error->largest *= degrees;
      error->mean *= share;
    }
    return mean;
  }

 private:
  void add(const Vec& a, const Vec& b, double whole) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const Vec exact = slerp(a, b, whole, t);
      add(sum_.linear, angle(exact, between(a, b, t)));
      add(sum_.quaternion, angle(exact, normal_of(between(half_way(a), half_way(b), t))));
      ++sum_.samples;
    }
  }
  static void add(ArcError& error, double angle) {
    error.largest = std::max(error.largest, angle);
    error.mean += angle;
  }

  NormalAngles sum_;  ///< radians; means are sums
};

}  // namespace

NormalAngles normal_angles(const Scene& scene) {
  Angles angles;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      if (primitive.normals.empty() || primitive.topology != Topology::triangles) continue;
      const auto normal = [&](std::size_t corner) {
        return glm::normalize(Vec(primitive.normals[primitive.indices[corner]]));
      };
      for (std::size_t corner = 0; corner + 2 < primitive.indices.size(); corner += 3)
        for (std::size_t edge = 0; edge < 3; ++edge)
          angles.add_edge(normal(corner + edge), normal(corner + (edge + 1) % 3));
    }
  return angles.angles();
}

}  // namespace sinew::cost
