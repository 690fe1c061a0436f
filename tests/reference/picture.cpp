// SPDX-License-Identifier: MIT
#include "tests/reference/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/reference/ambient.h"
#include "tests/reference/gooch.h"
#include "tests/reference/material.h"
#include "tests/reference/shade.h"

namespace sinew::reference {
namespace {

using viewer::Lighting;
using viewer::RenderOptions;
using viewer::Show;
using viewer::View;

glm::dvec3 into_world(const View& view, const glm::dvec3& direction) {
  return glm::transpose(linear_part(view.view_from_world)) * direction;  // the transpose of a rotation is its inverse
}

}  // namespace

SightLine sight_line(const PictureOf& picture, double x, double y) {
  const View& view = picture.view;
  const double aspect = static_cast<double>(picture.width) / picture.height;
  const double right = (2.0 * x / picture.width - 1.0) * aspect, up = 1.0 - 2.0 * y / picture.height;
  const glm::dvec3 eye = into_world(view, -translation_of(view.view_from_world));
  if (view.half_height_m > 0.0)
    return {eye + into_world(view, glm::dvec3(right, up, 0.0) * view.half_height_m),
            into_world(view, glm::dvec3(0.0, 0.0, -1.0))};
  const double slope = std::tan(0.5 * view.fov_y_rad);
  return {eye, into_world(view, glm::dvec3(right * slope, up * slope, -1.0))};
}

namespace {

/// The visible layers from near to far, down to the first opaque one.
std::vector<SurfacePoint> layers(const PictureOf& picture, double x, double y) {
  std::vector<SurfacePoint> kept;
  for (const SurfacePoint& point : surfaces_along(picture.scene, picture.frame, sight_line(picture, x, y))) {
    if (point.distance_m < picture.view.near_m) continue;
    if (picture.view.far_m > 0.0 && point.distance_m > picture.view.far_m) continue;
    const bool masked = point.material.alpha_mode == AlphaMode::mask;
    if (masked && base_color(picture.scene, point).a < static_cast<double>(point.material.alpha_cutoff)) continue;
    kept.push_back(point);
    if (point.material.alpha_mode != AlphaMode::blend && !transmits(point)) break;
  }
  return kept;
}

std::vector<ArrivingLight> lights_at(const PictureOf& picture, const glm::dvec3& point) {
  constexpr std::size_t most = 16;  // the viewer's limit
  const Lighting& lighting = picture.options.lighting;
  std::vector<ArrivingLight> arrived;
  if (lighting.scene_lights)
    for (std::size_t i = 0; i < std::min(most, picture.scene.lights.size()); ++i) {
      const Light& light = picture.scene.lights[i];
      arrived.push_back(arriving(light, affine_cast<double>(picture.frame.model[light.joint]), point));
    }
  if (!arrived.empty()) return arrived;
  const glm::dvec3 to_key = glm::normalize(glm::dvec3(lighting.to_key));
  return {{lighting.key_follows_camera ? into_world(picture.view, to_key) : to_key, glm::dvec3(lighting.key)}};
}

Openness openness_of(const PictureOf& picture, const SurfacePoint& point, double x, double y) {
  if (picture.visibility.empty() || point.material.alpha_mode == AlphaMode::blend || transmits(point)) return {};
  const std::size_t i =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
  Openness open{.visibility = picture.visibility[i]};
  if (!picture.bend.empty()) open.bend = into_world(picture.view, picture.bend[i]);
  return open;
}

glm::dvec3 radiance_of(const PictureOf& picture, const SurfacePoint& point, double x, double y) {
  const Lighting& lighting = picture.options.lighting;
  const std::vector<ArrivingLight> lights = lights_at(picture, point.position);
  const double ambient = lighting.ambient() ? static_cast<double>(lighting.environment_intensity) : 0.0;
  return radiance(
      picture.scene, point,
      {lights,
       {{0.0, 1.0, 0.0}, glm::dvec3(picture.ambient.sky) * ambient, glm::dvec3(picture.ambient.ground) * ambient},
       openness_of(picture, point, x, y)});
}

template <class Function>
glm::dvec3 each(const glm::dvec3& v, const Function& f) {
  return {f(v.x), f(v.y), f(v.z)};
}

glm::dvec3 displayed(const Lighting& lighting, const glm::dvec3& light) {
  const glm::dvec3 exposed = light * static_cast<double>(lighting.exposure);
  switch (lighting.tone_curve) {
    case viewer::ToneCurve::aces: return tone_mapped_aces(exposed);
    case viewer::ToneCurve::none: return glm::min(exposed, glm::dvec3(1.0));
    default: return tone_mapped(exposed);
  }
}

double backdrop_intensity(const Lighting& lighting) {
  return static_cast<double>(lighting.environment_intensity) * static_cast<double>(lighting.environment->backdrop);
}

/// The environment's light that the line of sight through a point of the picture meets.
glm::dvec3 gradient_behind(const PictureOf& picture, double x, double y) {
  const double t = 0.5 + 0.5 * glm::normalize(sight_line(picture, x, y).direction).y;
  const glm::dvec3 light = glm::dvec3(picture.ambient.ground) * (1.0 - t) + glm::dvec3(picture.ambient.sky) * t;
  return light * backdrop_intensity(picture.options.lighting);
}

/// True if the background shows the environment. Without ambient light the background is a plain colour in any case.
bool environment_is_seen(const RenderOptions& options) {
  return options.backdrop == viewer::Backdrop::sharp && options.lighting.ambient();
}

/// Cool to warm tone of a surface in the light of the first lamp, linear.
glm::dvec3 tone_of(const PictureOf& picture, const SurfacePoint& point) {
  const glm::dvec3 base = each(glm::dvec3(base_color(picture.scene, point)), srgb_encoded);
  const glm::dvec3 normal = seen_normal(point);
  if (normal == glm::dvec3(0.0)) return each(base, srgb_decoded);
  return each(gooch_tone(base, normal, lights_at(picture, point.position)[0].to_light, point.to_viewer), srgb_decoded);
}

/// Darkness of the outlines at a point of the picture. The neighbours are whole pixels away from this point.
double outline_at(const PictureOf& picture, double x, double y) {
  if (depth_at(picture, x, y).normal == glm::dvec3(0.0)) return 0.0;
  const View& view = picture.view;
  const bool parallel = view.half_height_m > 0.0;
  double line = 0.0;
  for (const glm::dvec2 step : {glm::dvec2(1.0, 0.0), {0.0, 1.0}}) {
    std::array<OutlinePixel, 3> row;
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      const double at_x = x + (i - 1) * step.x, at_y = y + (i - 1) * step.y;
      inside = inside && at_x > 0.0 && at_y > 0.0 && at_x < picture.width && at_y < picture.height;
      const DepthAndNormal at = depth_at(picture, at_x, at_y);
      row[static_cast<std::size_t>(i)] = {at.distance_m, at.normal};
    }
    const double half_height = parallel ? view.half_height_m : std::tan(0.5 * view.fov_y_rad) * row[1].distance_m;
    if (inside) line = std::max(line, outline(row, 0.5 * picture.height / half_height, parallel));
  }
  return line;
}

/// Puts the colour of a thin surface before what is already in `behind`. If the environment shows behind it, the
/// surface filters that too. Before any other background, the surface adds coverage for the light it blocks in every
/// colour.
void filter(const PictureOf& picture, const glm::dvec3& passed, double alpha, double x, double y, Layered& behind) {
  const glm::dvec3 colour = glm::dvec3(1.0 - alpha) + alpha * passed;
  const double most = std::max({colour.r, colour.g, colour.b}), unlit = (behind.coverage - behind.lit) * most;
  behind.light *= colour;
  behind.unlit *= colour;
  if (environment_is_seen(picture.options) && !picture.options.transparent_background) {
    behind.light += gradient_behind(picture, x, y) * passed * alpha * (1.0 - behind.coverage);
    behind.coverage += alpha * (1.0 - behind.coverage);
  } else {
    behind.coverage = 1.0 - most * (1.0 - behind.coverage);
  }
  behind.lit = behind.coverage - unlit;
}

/// True if the surface shows the blurred or refracted opaque picture.
bool is_frosted(const SurfacePoint& point) {
  return point.material.roughness > 0.0f || point.material.volume.thickness_m > 0.0f;
}

/// The point of the picture where the viewer sees a point of the world, in pixels.
glm::dvec2 seen_at(const PictureOf& picture, const glm::dvec3& p) {
  const View& view = picture.view;
  const glm::dvec3 v = transform_point(view.view_from_world, p);
  const double half = view.half_height_m > 0.0 ? view.half_height_m : -v.z * std::tan(0.5 * view.fov_y_rad);
  return {0.5 * picture.width + 0.5 * picture.height * v.x / half, 0.5 * picture.height * (1.0 - v.y / half)};
}

/// Puts a rough or thick transmitting surface before what is already in `behind`. It shows the blurred opaque surfaces
/// behind it, seen where the refracted ray leaves it.
/// in   passed  share of the light behind that passes through
void frost(const PictureOf& picture, const SurfacePoint& point, const glm::dvec3& passed, double alpha, double x,
           double y, Layered& behind) {
  const double roughness = roughness_at(picture.scene, point), most = std::max({passed.r, passed.g, passed.b});
  const bool thick = point.material.volume.thickness_m > 0.0f;
  const glm::dvec2 from = thick ? seen_at(picture, exit_of(picture.scene, point)) : glm::dvec2(x, y);
  Layered seen = picture.blurred->at(from.x, from.y, roughness, thick);
  const double unlit_share = most * seen.unlit_share();
  if (environment_is_seen(picture.options) && !picture.options.transparent_background) {
    const AmbientGradient around{{0.0, 1.0, 0.0}, glm::dvec3(picture.ambient.sky), glm::dvec3(picture.ambient.ground)};
    const glm::dvec3 direction = glm::normalize(sight_line(picture, from.x, from.y).direction);
    seen.light += (1.0 - seen.coverage) * backdrop_intensity(picture.options.lighting) *
                  light_around(around, direction, roughness);
    seen.coverage = 1.0;
  }
  const double coverage = 1.0 - most * (1.0 - seen.coverage);
  behind = alpha * Layered{passed * seen.light, passed * seen.unlit, coverage, coverage - unlit_share} +
           (1.0 - alpha) * behind;
}

/// True if the surface blends in any order, by weights (Transparency::weighted).
bool is_weighted(const PictureOf& picture, const SurfacePoint& point) {
  return picture.options.transparency == viewer::Transparency::weighted &&
         point.material.alpha_mode == AlphaMode::blend && !transmits(point);
}

/// Adds the colour and the coverage of one surface to a pixel.
void add_surface(const PictureOf& picture, const SurfacePoint& point, double alpha, double x, double y, Layered& sum) {
  const bool gooch = picture.options.shading == viewer::Shading::gooch;
  if (gooch && !point.material.unlit)
    sum.unlit += tone_of(picture, point) * alpha;
  else
    (point.material.unlit ? sum.unlit : sum.light) += radiance_of(picture, point, x, y) * alpha;
  sum.coverage += alpha;
  if (!gooch && !point.material.unlit) sum.lit += alpha;
}

/// Lays all surfaces that blend by weights over everything behind them.
/// eq   McGuire and Bavoil (2013), eqs. 6 and 7: sum(w a c) / sum(w a) * (1 - product(1 - a)); the weight falls by 2^5
///      from the nearest to the farthest distance of any such surface
void lay_weighted_over(const PictureOf& picture, const std::vector<SurfacePoint>& seen, double x, double y,
                       Layered& behind) {
  double nearest_m = 1e9, farthest_m = 0.0;
  for (std::size_t i = 0; i < picture.scene.instances.size(); ++i)
    for (const Primitive& primitive : picture.scene.meshes[picture.scene.instances[i].mesh].primitives) {
      if (primitive.material == kNone) continue;
      SurfacePoint point;
      point.material = picture.scene.materials[primitive.material];
      if (!is_weighted(picture, point)) continue;
      const Affined view_from_mesh =
          picture.view.view_from_world * affine_cast<double>(picture.frame.instances[i].world_from_mesh);
      for (const glm::vec3& position : primitive.positions) {
        const double distance_m = -transform_point(view_from_mesh, glm::dvec3(position)).z;
        nearest_m = std::min(nearest_m, distance_m);
        farthest_m = std::max(farthest_m, distance_m);
      }
    }
  Layered sums;
  double passed = 1.0;
  for (const SurfacePoint& point : seen) {
    if (!is_weighted(picture, point)) continue;
    const double alpha = std::clamp(base_color(picture.scene, point).a, 0.0, 1.0),
                 along = (point.distance_m - nearest_m) / std::max(farthest_m - nearest_m, 1e-30);
    add_surface(picture, point, alpha * std::exp2(-5.0 * along), x, y, sums);
    passed *= 1.0 - alpha;
  }
  if (sums.coverage <= 0.0) return;
  const double scale = (1.0 - passed) / sums.coverage;
  behind.light = behind.light * passed + sums.light * scale;
  behind.unlit = behind.unlit * passed + sums.unlit * scale;
  behind.coverage = behind.coverage * passed + sums.coverage * scale;
  behind.lit = behind.lit * passed + sums.lit * scale;
}

Layered layered(const PictureOf& picture, double x, double y) {
  const std::vector<SurfacePoint> seen = layers(picture, x, y);
  Layered sum;
  for (auto point = seen.rbegin(); point != seen.rend(); ++point) {
    if (is_weighted(picture, *point)) continue;
    const bool blended = point->material.alpha_mode == AlphaMode::blend;
    const double alpha = blended ? std::clamp(base_color(picture.scene, *point).a, 0.0, 1.0) : 1.0;
    if (transmits(*point) && picture.options.shading != viewer::Shading::gooch) {
      const glm::dvec3 passed = transmitted(picture.scene, *point);
      if (is_frosted(*point))
        frost(picture, *point, passed, alpha, x, y, sum);
      else
        filter(picture, passed, alpha, x, y, sum);
      sum.light += radiance_of(picture, *point, x, y) * alpha;
      continue;
    }
    for (double* below : {&sum.coverage, &sum.lit}) *below *= 1.0 - alpha;
    for (glm::dvec3* below : {&sum.light, &sum.unlit}) *below *= 1.0 - alpha;
    add_surface(picture, *point, alpha, x, y, sum);
    if (picture.options.shading == viewer::Shading::gooch && !blended) sum.unlit *= 1.0 - outline_at(picture, x, y);
  }
  lay_weighted_over(picture, seen, x, y, sum);
  return sum;
}

glm::dvec4 lit_color(const PictureOf& picture, double x, double y) {
  const auto [light, unlit, coverage, lit] = layered(picture, x, y);
  glm::dvec3 display(0.0);
  if (lit > 0.0) display = displayed(picture.options.lighting, light / lit) * lit / coverage;
  if (coverage > 0.0) display += unlit / coverage;
  if (picture.options.transparent_background) return {each(display, srgb_encoded), coverage};
  const glm::dvec3 behind = environment_is_seen(picture.options)
                                ? displayed(picture.options.lighting, gradient_behind(picture, x, y))
                                : each(glm::dvec3(picture.options.background), srgb_decoded);
  return {each(display * coverage + behind * (1.0 - coverage), srgb_encoded), 1.0};
}

glm::dvec3 shown_buffer(const PictureOf& picture, const DepthAndNormal& nearest, double x, double y) {
  const bool covered = nearest.distance_m > 0.0;
  switch (picture.options.show) {
    case Show::normals: return nearest.normal * 0.5 + 0.5;
    case Show::depth: {
      const double near_m = static_cast<double>(picture.options.depth_range.nearest_m),
                   far_m = static_cast<double>(picture.options.depth_range.farthest_m);
      return glm::dvec3(covered ? 1.0 - std::clamp((nearest.distance_m - near_m) / (far_m - near_m), 0.0, 1.0) : 0.0);
    }
    default: return glm::dvec3(covered ? openness_of(picture, {}, x, y).visibility : 1.0);
  }
}

}  // namespace

Blurred blurred_opaque(const PictureOf& picture) {
  std::vector<Layered> pixels;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::vector<SurfacePoint> seen = layers(picture, x + 0.5, y + 0.5);
      const bool opaque =
          !seen.empty() && seen.back().material.alpha_mode != AlphaMode::blend && !transmits(seen.back());
      pixels.emplace_back();
      if (opaque) add_surface(picture, seen.back(), 1.0, x + 0.5, y + 0.5, pixels.back());
    }
  return {picture.width, picture.height, std::move(pixels)};
}

double automatic_exposure(const PictureOf& picture) {
  double sum = 0.0, weight = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Layered pixel = layered(picture, x + 0.5, y + 0.5);
      const double light = glm::dot(pixel.light, glm::dvec3(0.2126, 0.7152, 0.0722));
      if (pixel.lit <= 0.0 || light <= 1e-6 * pixel.lit) continue;
      sum += pixel.lit * std::log(light / pixel.lit);
      weight += pixel.lit;
    }
  return weight > 0.0 ? 0.18 / std::exp(sum / weight) : 1.0;
}

DepthAndNormal depth_at(const PictureOf& picture, double x, double y) {
  for (const SurfacePoint& point : layers(picture, x, y)) {
    if (point.material.alpha_mode == AlphaMode::blend || transmits(point)) continue;
    return {point.distance_m, transform_vector(picture.view.view_from_world, mapped_normal(picture.scene, point))};
  }
  return {};
}

glm::dvec4 color_at(const PictureOf& picture, double x, double y) {
  if (picture.options.show == Show::color) return lit_color(picture, x, y);
  const DepthAndNormal nearest = depth_at(picture, x, y);
  const bool covered = nearest.distance_m > 0.0 || !picture.options.transparent_background;
  return {shown_buffer(picture, nearest, x, y), covered ? 1.0 : 0.0};
}

}  // namespace sinew::reference
