// SPDX-License-Identifier: MIT
#include "tests/reference/ssao.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::reference {

namespace {

std::size_t index(int width, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

struct Texel {
  double distance;
  glm::dvec3 point, normal;
  bool usable;
};

Texel texel_at(const DepthAndNormals& image, int step, int x, int y) {
  const int full_x = std::min(step * x, image.width - 1), full_y = std::min(step * y, image.height - 1);
  const std::size_t i = index(image.width, full_x, full_y);
  return {image.distance[i], image.point(full_x, full_y), image.normals[i],
          image.distance[i] > 0.0 && image.normals[i] != glm::dvec3(0.0)};
}

double pixels_per_metre(const DepthAndNormals& image) { return 0.5 * image.cot_y * image.height; }

double same_surface(const SsaoSettings& s, const glm::dvec3& p, const glm::dvec3& n, const glm::dvec3& q,
                    const glm::dvec3& other_n, double screen_m) {
  const double off = glm::dot(n, q - p) / (s.epsilon + 0.25 * screen_m);
  return std::pow(std::max(glm::dot(n, other_n), 0.0), 4.0) * std::exp(-0.5 * off * off);
}

double occlusion_by(const DepthAndNormals& image, const SsaoSettings& s, const glm::dvec3& q, const glm::dvec3& p,
                    const glm::dvec3& n) {
  if (-q.z <= image.near_m) return 0.0;
  const double u = 0.5 + 0.5 * q.x * image.cot_x / -q.z, v = 0.5 - 0.5 * q.y * image.cot_y / -q.z;
  const int x = std::clamp(static_cast<int>(std::floor(u * image.width)), 0, image.width - 1);
  const int y = std::clamp(static_cast<int>(std::floor(v * image.height)), 0, image.height - 1);
  const double seen = image.distance[index(image.width, x, y)];
  const double nearer_by = -p.z - seen;
  if (seen == 0.0 || nearer_by <= s.epsilon) return 0.0;
  const double fade = std::clamp((s.fade_end - nearer_by) / (s.fade_end - s.fade_start), 0.0, 1.0);
  return fade * std::max(glm::dot(n, glm::normalize(image.point(x, y) - p)), 0.0);
}

}  // namespace

glm::dvec3 DepthAndNormals::point(int x, int y) const {
  const double d = distance[index(width, x, y)];
  return {(2.0 * (x + 0.5) / width - 1.0) / cot_x * d, (1.0 - 2.0 * (y + 0.5) / height) / cot_y * d, -d};
}

HalfVisibility ssao(const DepthAndNormals& image, const SsaoSettings& s) {
  HalfVisibility half{(image.width + s.step - 1) / s.step, (image.height + s.step - 1) / s.step, {}, {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const Texel texel = texel_at(image, s.step, x, y);
      double sum = 0.0;
      if (texel.usable) {
        const double resolved = std::clamp(s.radius * pixels_per_metre(image) / texel.distance - 2.0, 0.0, 1.0);
        const glm::dvec3 mirror(s.noise[static_cast<std::size_t>(y % 4 * 4 + x % 4)]);
        for (const glm::vec3& fixed : s.offsets) {
          glm::dvec3 offset = glm::dvec3(fixed) - 2.0 * glm::dot(mirror, glm::dvec3(fixed)) * mirror;
          if (glm::dot(offset, texel.normal) < 0.0) offset = -offset;
          sum += resolved * occlusion_by(image, s, texel.point + s.radius * offset, texel.point, texel.normal);
        }
      }
      half.visibility.push_back(std::pow(1.0 - sum / static_cast<double>(s.offsets.size()), s.power));
    }
  return half;
}

HalfVisibility blurred(const DepthAndNormals& image, const SsaoSettings& s, const HalfVisibility& half, bool vertical) {
  HalfVisibility out{half.width, half.height, {}, {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const Texel middle = texel_at(image, s.step, x, y);
      double sum = 0.0, weights = 0.0;
      glm::dvec3 bend(0.0);
      for (int k = -s.reach; k <= s.reach; ++k) {
        const int at_x = vertical ? x : x + k, at_y = vertical ? y + k : y;
        if (at_x < 0 || at_y < 0 || at_x >= half.width || at_y >= half.height) continue;
        const Texel other = texel_at(image, s.step, at_x, at_y);
        const double screen_m = std::abs(k) * static_cast<double>(s.step) * middle.distance / pixels_per_metre(image);
        if (k != 0 && !(middle.usable && other.usable)) continue;
        double weight = std::abs(k) == s.reach ? 0.5 : 1.0;
        if (k != 0 && s.keep_edges)
          weight *= same_surface(s, middle.point, middle.normal, other.point, other.normal, screen_m);
        sum += weight * half.visibility[index(half.width, at_x, at_y)];
        if (!half.bend.empty()) bend += weight * half.bend[index(half.width, at_x, at_y)];
        weights += weight;
      }
      out.visibility.push_back(sum / weights);
      if (!half.bend.empty())
        out.bend.push_back(middle.usable ? glm::normalize(middle.normal + bend / weights) - middle.normal
                                         : glm::dvec3(0.0));
    }
  return out;
}

PixelVisibility full_size(const DepthAndNormals& image, const SsaoSettings& s, const HalfVisibility& half) {
  PixelVisibility full;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t i = index(image.width, x, y);
      const glm::dvec3 p = image.point(x, y), n = image.normals[i];
      double sum = 0.0, weights = 0.0, nearest = 1.0, nearest_m = 1e300;
      glm::dvec3 bend(0.0), nearest_bend(0.0);
      for (int dy = 0; dy <= y % s.step; ++dy)
        for (int dx = 0; dx <= x % s.step; ++dx) {
          const int at_x = std::min(x / s.step + dx, half.width - 1), at_y = std::min(y / s.step + dy, half.height - 1);
          const Texel other = texel_at(image, s.step, at_x, at_y);
          if (other.distance == 0.0) continue;
          const std::size_t at = index(half.width, at_x, at_y);
          const glm::dvec3 bent = half.bend.empty() ? glm::dvec3(0.0) : half.bend[at];
          const double away = glm::length(other.point - p);
          if (away < nearest_m) {
            nearest_m = away;
            nearest = half.visibility[at];
            nearest_bend = bent;
          }
          const double weight =
              same_surface(s, p, n, other.point, other.normal, image.distance[i] / pixels_per_metre(image));
          sum += weight * half.visibility[at];
          bend += weight * bent;
          weights += weight;
        }
      const bool drawn = image.distance[i] > 0.0 && n != glm::dvec3(0.0);
      full.visibility.push_back(!drawn ? 1.0 : weights > 1e-6 ? sum / weights : nearest);
      full.bend.push_back(!drawn ? glm::dvec3(0.0) : weights > 1e-6 ? bend / weights : nearest_bend);
    }
  return full;
}

}  // namespace sinew::reference
