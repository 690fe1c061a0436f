// SPDX-License-Identifier: MIT
#include "viewer/light/split_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "runtime/threads/default_executor.h"
#include "viewer/light/sheen_albedo.h"

namespace sinew::viewer {
namespace {

constexpr std::size_t kRings = 32, kTurns = 8;  // of the unit disk; turns of half of it, because the other is alike

constexpr float kSmallestAlpha = 1e-6f;   // a mirror within float
constexpr float kSmallestCosine = 1e-6f;  // at 0 nothing would be visible

struct DiskPoint {
  glm::vec2 at;
  float weight;
};

/// Points of half the unit disk whose weights add up to 1. They are denser towards the edge, where the long tail of GGX
/// is: the area inside of a ring is u (2 - u).
std::array<DiskPoint, kRings * kTurns> half_disk() {
  std::array<DiskPoint, kRings * kTurns> points{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float u = (static_cast<float>(i / kTurns) + 0.5f) / kRings, radius = std::sqrt(u * (2.0f - u));
    const float turn = std::numbers::pi_v<float> * ((static_cast<float>(i % kTurns) + 0.5f) / kTurns - 0.5f);
    points[i] = {{radius * std::cos(turn), radius * std::sin(turn)}, 2.0f * (1.0f - u) / points.size()};
  }
  return points;
}

/// A surface and a viewer in the plane y = 0; the normal is +z.
struct GgxView {
  float alpha, alpha2;
  glm::vec3 to_viewer, stretched;  ///< stretched: as for a surface of alpha 1
  float smith_v;                   ///< sqrt(alpha^2 + (1 - alpha^2) n.v^2)
};

GgxView ggx_view(float n_v, float roughness) noexcept {
  const float alpha = std::max(roughness * roughness, kSmallestAlpha), z = std::max(n_v, kSmallestCosine);
  const glm::vec3 v(std::sqrt(std::max(0.0f, 1.0f - z * z)), 0.0f, z);
  const float alpha2 = alpha * alpha;
  return {alpha, alpha2, v, glm::normalize(glm::vec3(alpha * v.x, 0.0f, v.z)),
          std::sqrt(alpha2 + (1.0f - alpha2) * z * z)};
}

/// A half vector that the viewer sees.
/// in   point  of the disk across `stretched`
glm::vec3 visible_half_vector(const GgxView& view, const glm::vec2& point) noexcept {
  const glm::vec3 aside(0.0f, 1.0f, 0.0f), up = glm::cross(view.stretched, aside);
  const float lift = 0.5f * (1.0f + view.stretched.z);
  const float y = (1.0f - lift) * std::sqrt(1.0f - point.x * point.x) + lift * point.y;
  const float z = std::sqrt(std::max(0.0f, 1.0f - point.x * point.x - y * y));
  const glm::vec3 n = aside * point.x + up * y + view.stretched * z;
  return glm::normalize(glm::vec3(view.alpha * n.x, view.alpha * n.y, std::max(0.0f, n.z)));
}

std::vector<glm::vec3> make_table() {
  constexpr float last = kSplitSumSize - 1;
  std::vector<glm::vec3> table(std::size_t{kSplitSumSize} * kSplitSumSize);
  run_in_parallel(kSplitSumSize, [&](std::size_t row) {
    for (std::uint32_t i = 0; i < kSplitSumSize; ++i) {
      const float root = static_cast<float>(i) / last, n_v = root * root;
      const float roughness = static_cast<float>(row) / last;
      table[row * kSplitSumSize + i] = glm::vec3(split_sum(n_v, roughness), sheen_albedo(n_v, roughness));
    }
  });
  return table;
}

}  // namespace

glm::vec2 split_sum(float n_v, float roughness) noexcept {
  static const auto points = half_disk();
  const GgxView view = ggx_view(n_v, roughness);
  const float z = view.to_viewer.z;
  glm::vec2 sum(0.0f);
  for (const auto& [point, weight] : points) {
    const glm::vec3 h = visible_half_vector(view, point);
    const float v_h = glm::dot(view.to_viewer, h), n_l = 2.0f * v_h * h.z - z;
    if (n_l <= 0.0f || v_h <= 0.0f) continue;
    const float smith_l = std::sqrt(view.alpha2 + (1.0f - view.alpha2) * n_l * n_l);
    const float unshadowed = n_l * (z + view.smith_v) / (n_l * view.smith_v + z * smith_l);
    const float away = std::max(0.0f, 1.0f - v_h), edge = away * away * away * away * away;
    sum += weight * unshadowed * glm::vec2(1.0f - edge, edge);
  }
  return sum;
}

const std::vector<glm::vec3>& split_sum_table() {
  static const std::vector<glm::vec3> table = make_table();
  return table;
}

}  // namespace sinew::viewer
