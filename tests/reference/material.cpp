// SPDX-License-Identifier: MIT
#include "tests/reference/material.h"

#include <algorithm>
#include <cmath>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "tests/reference/shade.h"
#include "tests/reference/sheen.h"
#include "tests/reference/texture.h"

namespace sinew::reference {
namespace {

constexpr double kLeastRoughness = 0.045;  // the viewer uses the same limit, so that mirrors keep a visible highlight

/// Colour of a texture at a point; `otherwise` if the material has no such texture.
glm::dvec4 looked_up(const Scene& scene, const SurfacePoint& point, const TextureUse& use, bool srgb,
                     const glm::dvec4& otherwise = glm::dvec4(1.0)) {
  if (!use.used()) return otherwise;
  return texel(scene, use, transformed(use, point.uv[use.texcoord]), srgb);
}

glm::dvec3 mapped_normal(const Scene& scene, const SurfacePoint& point, const TextureUse& map, float map_scale) {
  if (!map.used() || point.normal == glm::dvec3(0.0)) return seen_normal(point);
  const glm::dvec3 stored(looked_up(scene, point, map, false));
  const double scale = static_cast<double>(map_scale);
  const glm::dvec3 local = (stored * 2.0 - 1.0) * glm::dvec3(scale, scale, 1.0);
  const TangentFrame& frame = point.frames[map.texcoord];
  const glm::dvec3 normal =
      glm::normalize(frame.tangent * local.x + frame.bitangent * local.y + point.normal * local.z);
  return point.front ? normal : -normal;
}

/// Share of the ambient light that baked occlusion lets through.
double baked_visibility(const Scene& scene, const SurfacePoint& point) {
  const double red = looked_up(scene, point, point.material.occlusion_texture, false).r;
  return 1.0 + static_cast<double>(point.material.occlusion_strength) * (red - 1.0);
}

/// eq   KHR_materials_ior, KHR_materials_specular: min(((ior - 1) / (ior + 1))^2 * color, 1), before the factor
glm::dvec3 dielectric_f0(const Scene& scene, const SurfacePoint& point) {
  const Specular& specular = point.material.specular;
  const double ior = static_cast<double>(specular.ior), root = (ior - 1.0) / (ior + 1.0);
  const glm::dvec3 color =
      glm::dvec3(specular.color) * glm::dvec3(looked_up(scene, point, specular.color_texture, true));
  return glm::min(root * root * color, glm::dvec3(1.0));
}

SheenLayer sheen_at(const Scene& scene, const SurfacePoint& point) {
  constexpr double least = 5.0 / 63.0;  // the viewer's limit
  const Sheen& sheen = point.material.sheen;
  return {glm::dvec3(sheen.color) * glm::dvec3(looked_up(scene, point, sheen.color_texture, true)),
          std::max(least,
                   static_cast<double>(sheen.roughness) * looked_up(scene, point, sheen.roughness_texture, false).a)};
}

Coat coat_at(const Scene& scene, const SurfacePoint& point) {
  const Clearcoat& coat = point.material.clearcoat;
  const double roughness =
      static_cast<double>(coat.roughness) * looked_up(scene, point, coat.roughness_texture, false).g;
  return {static_cast<double>(coat.factor) * looked_up(scene, point, coat.texture, false).r,
          std::clamp(roughness, kLeastRoughness, 1.0),
          mapped_normal(scene, point, coat.normal_texture, coat.normal_scale)};
}

/// Sets the direction and strength of a stretched highlight. A mesh without tangents and texture coordinates has none.
void stretch(const Scene& scene, const SurfacePoint& point, ShadedPoint& shaded) {
  const Anisotropy& anisotropy = point.material.anisotropy;
  if (anisotropy.strength == 0.0f) return;
  const glm::dvec3 texel = anisotropy.texture.used() ? glm::dvec3(looked_up(scene, point, anisotropy.texture, false))
                                                     : glm::dvec3(1.0, 0.5, 1.0);
  const std::uint32_t set =
      anisotropy.texture.used() ? anisotropy.texture.texcoord : point.material.normal_texture.texcoord;
  const double turn =
      static_cast<double>(anisotropy.rotation_rad) + std::atan2(2.0 * texel.y - 1.0, 2.0 * texel.x - 1.0);
  const TangentFrame& frame = point.frames[set];
  if (frame.tangent == glm::dvec3(0.0)) return;
  const glm::dvec3 along = frame.tangent * std::cos(turn) + frame.bitangent * std::sin(turn);
  shaded.along = glm::normalize(along - shaded.normal * glm::dot(shaded.normal, along));
  shaded.anisotropy = static_cast<double>(anisotropy.strength) * texel.z;
}

ThinFilm film_at(const Scene& scene, const SurfacePoint& point) {
  const Iridescence& film = point.material.iridescence;
  const double green = looked_up(scene, point, film.thickness_texture, false).g;
  const double thickness_nm =
      static_cast<double>(film.thinnest_nm) * (1.0 - green) + static_cast<double>(film.thickest_nm) * green;
  const double share = static_cast<double>(film.factor) * looked_up(scene, point, film.texture, false).r;
  return {thickness_nm > 0.0 ? share : 0.0, static_cast<double>(film.ior), thickness_nm};
}

ShadedPoint shaded_point(const Scene& scene, const SurfacePoint& point) {
  const Material& material = point.material;
  const glm::dvec4 texel = looked_up(scene, point, material.metallic_roughness_texture, false);
  ShadedPoint shaded;
  shaded.base_color = glm::dvec3(base_color(scene, point));
  shaded.metallic = static_cast<double>(material.metallic) * texel.b;
  shaded.roughness = std::max(roughness_at(scene, point), kLeastRoughness);
  shaded.dielectric_f90 =
      static_cast<double>(material.specular.factor) * looked_up(scene, point, material.specular.texture, false).a;
  shaded.dielectric_f0 = dielectric_f0(scene, point) * shaded.dielectric_f90;
  shaded.normal = mapped_normal(scene, point, material.normal_texture, material.normal_scale);
  shaded.to_viewer = point.to_viewer;
  shaded.transmission = static_cast<double>(material.transmission.factor) *
                        looked_up(scene, point, material.transmission.texture, false).r;
  shaded.film = film_at(scene, point);
  stretch(scene, point, shaded);
  return shaded;
}

glm::dvec3 reflected(const Scene& scene, const SurfacePoint& point, const Surroundings& around) {
  const ShadedPoint shaded = shaded_point(scene, point);
  const Coat coat = coat_at(scene, point);
  const double share = coat_share(coat, point.to_viewer);
  Openness open = around.open;
  open.baked = baked_visibility(scene, point);
  const SheenLayer sheen = sheen_at(scene, point);
  const SheenShare fibres = sheen_of_ambient(sheen, shaded.normal, point.to_viewer);
  glm::dvec3 below = ambient(shaded, around.ambient, open) * fibres.left +
                     fibres.added * diffuse_light(around.ambient, shaded.normal) * open.visibility * open.baked;
  glm::dvec3 above = ambient(coat, shaded.base_color, point.to_viewer, around.ambient, open);
  for (const ArrivingLight& light : around.lights) {
    const SheenShare own = sheen_of_light(sheen, shaded.normal, point.to_viewer, light.to_light);
    below += direct(shaded, light.to_light, light.irradiance) * own.left + own.added * light.irradiance;
    above += ggx(coat.normal, point.to_viewer, light.to_light, coat.roughness) * light.irradiance;
  }
  return below * (1.0 - share) + above * share;
}

}  // namespace

glm::dvec4 base_color(const Scene& scene, const SurfacePoint& point) {
  return glm::dvec4(point.material.base_color) * point.color *
         looked_up(scene, point, point.material.base_color_texture, true);
}

glm::dvec3 seen_normal(const SurfacePoint& point) { return point.front ? point.normal : -point.normal; }

glm::dvec3 mapped_normal(const Scene& scene, const SurfacePoint& point) {
  return mapped_normal(scene, point, point.material.normal_texture, point.material.normal_scale);
}

glm::dvec3 radiance(const Scene& scene, const SurfacePoint& point, const Surroundings& around) {
  const Material& material = point.material;
  const glm::dvec3 base(base_color(scene, point));
  if (material.unlit) return base;
  const bool shows_light = point.normal != glm::dvec3(0.0);
  const double through = shows_light ? 1.0 - coat_share(coat_at(scene, point), point.to_viewer) : 1.0;
  const glm::dvec3 emitted = through * glm::dvec3(material.emissive) * static_cast<double>(material.emissive_strength) *
                             glm::dvec3(looked_up(scene, point, material.emissive_texture, true));
  return (shows_light ? reflected(scene, point, around) : base) + emitted;
}

bool transmits(const SurfacePoint& point) { return !point.material.unlit && point.material.transmission.factor > 0.0f; }

double roughness_at(const Scene& scene, const SurfacePoint& point) {
  const Material& material = point.material;
  const double texel = looked_up(scene, point, material.metallic_roughness_texture, false).g;
  const double roughness = static_cast<double>(material.roughness) * texel;
  if (!material.specular.has_glossiness) return std::clamp(roughness, 0.0, 1.0);
  const double alpha = looked_up(scene, point, material.specular.color_texture, true).a;
  return std::clamp(1.0 - (1.0 - roughness) * alpha, 0.0, 1.0);
}

glm::dvec3 transmitted(const Scene& scene, const SurfacePoint& point) {
  if (!transmits(point) || point.normal == glm::dvec3(0.0)) return glm::dvec3(0.0);
  const ShadedPoint shaded = shaded_point(scene, point);
  const double sheen = sheen_of_ambient(sheen_at(scene, point), shaded.normal, point.to_viewer).left;
  const glm::dvec3 passed = passed_through(shaded) * sheen * (1.0 - coat_share(coat_at(scene, point), point.to_viewer));
  const Volume& volume = point.material.volume;
  if (volume.attenuation_distance_m == 0.0f) return passed;
  return passed *
         glm::pow(glm::dvec3(volume.attenuation_color),
                  glm::dvec3(path_in_volume(scene, point) / static_cast<double>(volume.attenuation_distance_m)));
}

double path_in_volume(const Scene& scene, const SurfacePoint& point) {
  const Volume& volume = point.material.volume;
  return static_cast<double>(volume.thickness_m) * looked_up(scene, point, volume.texture, false).g * point.scale;
}

glm::dvec3 exit_of(const Scene& scene, const SurfacePoint& point) {
  const glm::dvec3 in = -point.to_viewer, n = shaded_point(scene, point).normal;
  const double eta = 1.0 / std::max(static_cast<double>(point.material.specular.ior), 1.0), cosine = -glm::dot(in, n);
  const glm::dvec3 refracted = eta * in + (eta * cosine - std::sqrt(1.0 - eta * eta * (1.0 - cosine * cosine))) * n;
  return point.position + refracted * path_in_volume(scene, point);
}

}  // namespace sinew::reference
