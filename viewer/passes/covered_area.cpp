// SPDX-License-Identifier: MIT
#include "viewer/passes/covered_area.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace sinew::viewer {
namespace {

struct Span {
  std::uint32_t first = 0, count = 0;
};

/// Texels that cover [least, most] (normalised device coordinates), plus one on either side.
Span texels_between(double least, double most, std::uint32_t pixels, std::uint32_t step) noexcept {
  const double texels = std::ceil(static_cast<double>(pixels) / step), to_texels = 0.5 * pixels / step;
  const double first = std::clamp(std::floor((least + 1.0) * to_texels) - 1.0, 0.0, texels),
               end = std::clamp(std::ceil((most + 1.0) * to_texels) + 1.0, 0.0, texels);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::max(end - first, 0.0))};
}

}  // namespace

CoveredArea::CoveredArea(const View& view, double aspect) noexcept : near_m_(view.near_m), parallel_(view.parallel()) {
  const Mat4<double> clip = clip_from_view(view, aspect);
  scale_ = {clip[0][0], -clip[1][1]};
}

void CoveredArea::add_point(const glm::dvec3& point) noexcept {
  const double distance = parallel_ ? 1.0 : -point.z;
  if (!parallel_ && distance < near_m_) return add_everything();
  const glm::dvec2 at = scale_ * glm::dvec2(point) / distance;
  least_ = glm::min(least_, at);
  most_ = glm::max(most_, at);
}

void CoveredArea::add_box(const Affined& view_from_box, const Aabb& box) noexcept {
  if (box.empty()) return add_everything();
  for (int corner = 0; corner < 8; ++corner)
    add_point(transform_point(view_from_box,
                              glm::dvec3(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                                         corner & 4 ? box.upper.z : box.lower.z)));
}

void CoveredArea::add_everything() noexcept {
  least_ = glm::min(least_, glm::dvec2(-1.0));
  most_ = glm::max(most_, glm::dvec2(1.0));
}

VkRect2D CoveredArea::texels(VkExtent2D picture, std::uint32_t step) const noexcept {
  if (!(least_.x <= most_.x)) return {};
  const Span x = texels_between(least_.x, most_.x, picture.width, step),
             y = texels_between(least_.y, most_.y, picture.height, step);
  return {{static_cast<std::int32_t>(x.first), static_cast<std::int32_t>(y.first)}, {x.count, y.count}};
}

}  // namespace sinew::viewer
