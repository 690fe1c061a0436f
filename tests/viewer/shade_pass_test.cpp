// SPDX-License-Identifier: MIT
// Compares prepass and shading with a ray caster and plain double-precision lighting, pixel by pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/ambient.h"
#include "tests/reference/ray_cast.h"
#include "tests/reference/shade.h"
#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

constexpr int kWidth = 64, kHeight = 48;

class shade_pass : public DeviceTest {};

View the_view() { return look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05); }

std::vector<reference::RayTriangle> triangles_of(const BuiltScene& built, const View& view) {
  std::vector<reference::RayTriangle> triangles;
  const FrameResult frame = built.frame();
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const Primitive& primitive = built.scene.meshes[built.scene.instances[i].mesh].primitives[0];
    const Affined m = view.view_from_world * affine_cast<double>(frame.instances[i].world_from_mesh);
    for (std::size_t k = 0; k < primitive.indices.size(); k += 3) {
      reference::RayTriangle& triangle = triangles.emplace_back();
      triangle.material = primitive.material;
      for (std::size_t c = 0; c < 3; ++c) {
        triangle.corners[c] = transform_point(m, glm::dvec3(primitive.positions[primitive.indices[k + c]]));
        triangle.normals[c] = transform_vector(m, glm::dvec3(primitive.normals[primitive.indices[k + c]]));
      }
    }
  }
  return triangles;
}

/// The reference picture. Pixels whose neighbours show another surface are not compared, because rounding decides which
/// of two triangles covers the centre of a pixel on their border.
struct Seen {
  std::vector<std::optional<reference::RayHit>> hits;
  std::vector<glm::dvec3> points;
  std::vector<bool> inner;

  /// Depth differences between an inner pixel and its neighbours, in metres per pixel.
  double slope(std::size_t i) const {
    return std::abs(points[i].z - points[i + 1].z) + std::abs(points[i].z - points[i - 1].z) +
           std::abs(points[i].z - points[i + kWidth].z) + std::abs(points[i].z - points[i - kWidth].z);
  }
};

Seen look(const BuiltScene& built, const View& view) {
  Seen seen;
  reference::DepthAndNormals image = empty_image(kWidth, kHeight, view);
  image.distance.assign(kWidth * kHeight, 1.0);
  const auto triangles = triangles_of(built, view);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 ray = image.point(x, y);
      const auto hit = reference::cast(triangles, glm::dvec3(0.0), ray);
      seen.points.push_back(hit ? ray * hit->t : glm::dvec3(0.0));
      seen.hits.push_back(hit);
    }
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      bool inner = x > 0 && y > 0 && x < kWidth - 1 && y < kHeight - 1;
      for (int dy = -1; dy <= 1 && inner; ++dy)
        for (int dx = -1; dx <= 1 && inner; ++dx) {
          const auto &a = seen.hits[static_cast<std::size_t>(y * kWidth + x)],
                     &b = seen.hits[static_cast<std::size_t>((y + dy) * kWidth + x + dx)];
          inner = a.has_value() == b.has_value() &&
                  (!a || (a->material == b->material && glm::dot(a->normal, b->normal) > 0.5));
        }
      seen.inner.push_back(inner);
    }
  return seen;
}

TEST_F(shade_pass, N30_depth_and_normals_of_the_prepass_are_those_of_a_ray_caster) {
  const BuiltScene built = box_and_sphere_on_floor();
  const Seen seen = look(built, the_view());
  const auto image = gpu_depth_and_normals(built, kWidth, kHeight, the_view(), {});
  int compared = 0;
  for (std::size_t i = 0; i < seen.hits.size(); ++i) {
    if (!seen.inner[i]) continue;
    ++compared;
    ASSERT_EQ(seen.hits[i].has_value(), image.distance[i] > 0.0) << i;
    if (!seen.hits[i]) continue;
    EXPECT_NEAR(image.distance[i], -seen.points[i].z, 3e-5 + vertex_grid_px() * seen.slope(i)) << i;
    EXPECT_LT(glm::length(image.normals[i] - seen.hits[i]->normal), 2e-3) << i;  // stored as half floats
  }
  EXPECT_GT(compared, kWidth * kHeight / 2);
}

struct Sun {
  glm::dvec3 to_light, irradiance;
};

glm::dvec3 expected_color(const Material& material, const glm::dvec3& p, const glm::dvec3& n, const View& view,
                          const Lighting& lighting, double visibility, const Sun& sun) {
  reference::ShadedPoint point{glm::dvec3(material.base_color), static_cast<double>(material.metallic),
                               static_cast<double>(material.roughness), n, -glm::normalize(p)};
  const glm::dvec3 up = transform_vector(view.view_from_world, glm::dvec3(0.0, 1.0, 0.0));
  const glm::dvec3 light = reference::direct(point, sun.to_light, sun.irradiance) + glm::dvec3(material.emissive) +
                           reference::ambient(point, {up, glm::dvec3(Gradient{}.sky), glm::dvec3(Gradient{}.ground)},
                                              {.visibility = visibility});
  const glm::dvec3 mapped = reference::tone_mapped(light * static_cast<double>(lighting.exposure));
  return {reference::srgb_encoded(mapped.r), reference::srgb_encoded(mapped.g), reference::srgb_encoded(mapped.b)};
}

void expect_shaded(const BuiltScene& built, const RenderOptions& options, const std::vector<double>& visibility,
                   const Sun& sun) {
  const View view = the_view();
  const Seen seen = look(built, view);
  const FloatPicture picture = render_float(built, kWidth, kHeight, view, options);
  double mean = 0.0;
  int compared = 0;
  for (std::size_t i = 0; i < seen.hits.size(); ++i) {
    if (!seen.inner[i] || !seen.hits[i]) continue;
    const Material& material = built.scene.materials[seen.hits[i]->material];
    const glm::dvec3 expected =
        expected_color(material, seen.points[i], seen.hits[i]->normal, view, options.lighting, visibility[i], sun);
    const double error = glm::length(glm::dvec3(picture.pixels[i]) - expected);
    // Scene light is stored as half floats (2^-11); the narrow highlight of a smooth metal amplifies rounding of the
    // normal.
    EXPECT_LT(error, 0.01) << i;
    mean += error;
    ++compared;
  }
  ASSERT_GT(compared, kWidth * kHeight / 3);
  EXPECT_LT(mean / compared, 1.5e-3);
}

BuiltScene shiny_scene() {
  BuiltScene built = box_and_sphere_on_floor();
  built.scene.materials[1].metallic = 1.0f;
  built.scene.materials[1].roughness = 0.35f;
  built.scene.materials[2].metallic = 0.3f;
  built.scene.materials[2].roughness = 0.5f;
  built.scene.materials[2].emissive = {0.1f, 0.0f, 0.05f};
  return built;
}

Sun sun_of(const Lighting& lighting) {
  return {glm::normalize(transform_vector(the_view().view_from_world, glm::dvec3(lighting.to_key))),
          glm::dvec3(lighting.key)};
}

TEST_F(shade_pass, agrees_with_the_reference_without_occlusion) {
  RenderOptions options;
  options.ao.on = false;
  expect_shaded(shiny_scene(), options, std::vector<double>(kWidth * kHeight, 1.0), sun_of(options.lighting));
}

TEST_F(shade_pass, occlusion_scales_the_ambient_term_only) {
  RenderOptions options;
  options.ao.method = OcclusionMethod::ssao;  // reflections with bent normals are compared in mirrored_picture_test.cpp
  options.ao.radius_m = 0.8f;
  options.ao.fade_start_m = 0.4f;
  options.ao.fade_end_m = 1.6f;
  RenderOptions visibility_only = options;
  visibility_only.show = Show::ao;
  const FloatPicture picture = render_float(shiny_scene(), kWidth, kHeight, the_view(), visibility_only);
  std::vector<double> visibility;
  double darkest = 1.0;
  for (const glm::vec4& pixel : picture.pixels) {
    visibility.push_back(static_cast<double>(pixel.r));
    darkest = std::min(darkest, visibility.back());
  }
  ASSERT_LT(darkest, 0.8);
  expect_shaded(shiny_scene(), options, visibility, sun_of(options.lighting));
}

TEST_F(shade_pass, a_directional_light_of_the_file_replaces_the_key_light) {
  BuiltScene built = shiny_scene();
  Light light;
  light.color = {1.0f, 0.8f, 0.6f};
  light.intensity = 2.5f;
  built.add_light(light,
                  {{{0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}}});  // turned about y by 90 degrees: shines along -x
  RenderOptions options;
  options.ao.on = false;
  const Sun sun{transform_vector(the_view().view_from_world, glm::dvec3(1.0, 0.0, 0.0)), glm::dvec3(light.color) * 2.5};
  expect_shaded(built, options, std::vector<double>(kWidth * kHeight, 1.0), sun);
  options.lighting.scene_lights = false;
  expect_shaded(built, options, std::vector<double>(kWidth * kHeight, 1.0), sun_of(options.lighting));
}

TEST_F(shade_pass, where_normals_are_zero_surfaces_show_their_color_as_if_unlit) {
  RenderOptions options;
  options.lighting.tone_curve = ToneCurve::none;  // which unlit colours do not pass
  options.ao.on = false;
  const auto picture_of = [&](bool unlit) {
    Primitive floor = square(2.0f);
    Material material = matte({0.5f, 0.3f, 0.1f});
    material.unlit = unlit;
    material.emissive = glm::vec3(0.0f);
    if (!unlit) std::fill(floor.normals.begin(), floor.normals.end(), glm::vec3(0.0f));
    BuiltScene built;
    built.add(floor, built.add_material(material));
    return render_float(built, kWidth, kHeight, the_view(), options).pixels;
  };
  const auto unlit = picture_of(true);
  EXPECT_EQ(picture_of(false), unlit);
  EXPECT_GT(std::count_if(unlit.begin(), unlit.end(), [&](const glm::vec4& p) { return p != unlit[0]; }),
            kWidth * kHeight / 8);
}

/// A floor in the light of a sun straight above.
BuiltScene sunny_scene(float intensity) {
  BuiltScene built = shiny_scene();
  Light sun;
  sun.intensity = intensity;
  built.add_light(sun, {{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}});
  return built;
}

constexpr float kDazzling = 1e7f;  // floors are then far brighter than half floats can hold

TEST_F(shade_pass, light_beyond_what_images_hold_is_white) {
  RenderOptions options;
  options.ao.on = false;
  const FloatPicture picture = render_float(sunny_scene(kDazzling), kWidth, kHeight, the_view(), options);
  const Seen seen = look(shiny_scene(), the_view());
  int compared = 0;
  for (std::size_t i = 0; i < seen.hits.size(); ++i) {
    if (!seen.inner[i] || !seen.hits[i] || seen.hits[i]->material != 0) continue;
    ++compared;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.pixels[i][c], 1.0f, 1e-3f) << i;
  }
  EXPECT_GT(compared, kWidth * kHeight / 8);
}

TEST_F(shade_pass, what_lies_before_light_beyond_what_images_hold_hides_it) {
  RenderOptions options;
  options.ao.on = false;
  const auto behind_a_pane = [&](float intensity) {
    BuiltScene built = sunny_scene(intensity);
    Material pane = matte({0.2f, 0.1f, 0.05f});
    pane.unlit = true;
    pane.alpha_mode = AlphaMode::blend;
    pane.double_sided = true;
    built.add(square(3.0f), built.add_material(pane), translation({0.0f, 1.5f, 0.0f}));
    return render_float(built, kWidth, kHeight, the_view(), options).pixels;
  };
  const auto plain = behind_a_pane(1.0f), dazzling = behind_a_pane(kDazzling);
  const glm::vec4 covered = plain[kHeight / 2 * kWidth + kWidth / 2];
  int compared = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (plain[i] != covered) continue;
    ++compared;
    EXPECT_LT(glm::length(dazzling[i] - covered), 0.02f) << i;  // an interpolated 1 may be a step of float below 1
  }
  EXPECT_GT(compared, kWidth * kHeight / 4);
}

TEST_F(shade_pass, P17_occlusion_of_strength_0_is_bit_for_bit_the_picture_without_it) {
  RenderOptions with, without;
  with.ao.power = 0.0f;
  without.ao.on = false;
  const FloatPicture a = render_float(shiny_scene(), kWidth, kHeight, the_view(), with);
  EXPECT_EQ(a.pixels, render_float(shiny_scene(), kWidth, kHeight, the_view(), without).pixels);
}

TEST_F(shade_pass, leaves_out_the_prepass_without_changing_the_picture) {
  RenderOptions with, without;
  with.ao.power = 1e-6f;  // occlusion with hardly any effect
  without.ao.on = false;
  const FloatPicture a = render_float(shiny_scene(), kWidth, kHeight, the_view(), with);
  const FloatPicture b = render_float(shiny_scene(), kWidth, kHeight, the_view(), without);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) EXPECT_LT(glm::length(a.pixels[i] - b.pixels[i]), 1e-3f) << i;
}

}  // namespace
}  // namespace sinew::viewer
