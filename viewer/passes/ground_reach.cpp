// SPDX-License-Identifier: MIT
#include "viewer/passes/ground_reach.h"

#include <limits>

#include <glm/common.hpp>

namespace sinew::viewer {
namespace {

/// A rectangle on the ground that grows with each point, within the ground's radius.
class Footprint {
 public:
  Footprint(const Ground& ground, double margin_m)
      : middle_(ground.middle), radius_(static_cast<double>(ground.radius_m)), margin_(margin_m) {}

  void add(const glm::dvec3& p) noexcept {
    const glm::dvec2 at(p.x - middle_.x, p.z - middle_.z);
    least_ = glm::min(least_, at - margin_);
    most_ = glm::max(most_, at + margin_);
  }
  glm::vec4 rectangle() const noexcept {
    const glm::dvec2 least = glm::clamp(least_, -radius_, radius_), most = glm::clamp(most_, -radius_, radius_);
    return {glm::vec2(least), glm::vec2(most)};
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::max();
  glm::dvec3 middle_;
  double radius_, margin_;
  glm::dvec2 least_{kFar}, most_{-kFar};
};

}  // namespace

GroundReach ground_reach(const Ground& ground, const Aabb& standing, const ShadowLights& shadows, double contact_m) {
  const float radius = ground.radius_m;
  const glm::vec4 whole(-radius, -radius, radius, radius);
  if (standing.empty()) return {whole, whole, shadows.count() > 0 || contact_m > 0.0};
  const bool touched = contact_m > 0.0 && static_cast<double>(standing.lower.y) - ground.middle.y < contact_m;
  const bool above = static_cast<double>(standing.upper.y) > ground.middle.y;
  bool shadowed = false, everywhere = ground.look == GroundLook::grid;
  Footprint footprint(ground, contact_m), contact(ground, contact_m);
  for (int c = 0; c < 8; ++c) {
    const glm::dvec3 corner(c & 1 ? standing.upper.x : standing.lower.x, c & 2 ? standing.upper.y : standing.lower.y,
                            c & 4 ? standing.upper.z : standing.lower.z);
    footprint.add(corner);
    contact.add(corner);
    for (const ShadowLight& shadow : shadows) {
      const glm::dvec3 to_light = shadow.spot ? shadow.position - corner : shadow.to_light;
      shadowed = shadowed || (above && (shadow.spot || to_light.y > 0.0));
      if (to_light.y > 0.0)
        footprint.add(corner - to_light * ((corner.y - ground.middle.y) / to_light.y));
      else
        everywhere = true;  // a light below the highest caster casts infinite shadows
    }
  }
  return {everywhere ? whole : footprint.rectangle(), touched ? contact.rectangle() : glm::vec4(0.0f),
          shadowed || touched};
}

}  // namespace sinew::viewer
