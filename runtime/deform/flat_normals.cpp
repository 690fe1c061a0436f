// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_normals.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// The cross product in double, so that neither tiny nor huge triangles lose their normal.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, double sign,
                      bool& has_area) noexcept {
  const Vec3<double> u = Vec3<double>(b) - Vec3<double>(a), v = Vec3<double>(c) - Vec3<double>(a);
  const Vec3<double> n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  has_area = length > 0.0;
  return has_area ? glm::vec3(n * (sign / length)) : glm::vec3(0.0f);
}

}  // namespace

void flat_normals(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> rest_normals, bool turned, std::span<glm::vec3> normals) noexcept {
  std::copy(rest_normals.begin(), rest_normals.end(), normals.begin());
  const double sign = turned ? -1.0 : 1.0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
    bool has_area = false;
    const glm::vec3 n = face_normal(positions[a], positions[b], positions[c], sign, has_area);
    if (has_area) normals[a] = normals[b] = normals[c] = n;
  }
}

}  // namespace sinew
