// SPDX-License-Identifier: MIT
// Occluded reflections of environment light, compared with the reference renderer and with ray casting.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/reference/lobe_rays.h"
#include "tests/reference/picture.h"
#include "tests/reference/ray_cast.h"
#include "tests/reference/shade.h"
#include "tests/viewer/reference_picture.h"
#include "tests/viewer/reference_visibility.h"

namespace sinew::viewer {
namespace {

constexpr int kWidth = 63, kHeight = 48;
constexpr float kRadius = 0.9f;

class mirrored_picture : public DeviceTest {};

View the_view() { return look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05); }

RenderOptions occluded_ambient_light() {
  RenderOptions options = only_ambient_light();
  options.ao.on = true;
  options.ao.radius_m = kRadius;
  options.ao.surface_epsilon_m = 0.02f * kRadius;
  return options;
}

reference::DepthAndNormals seen_by_reference(const reference::PictureOf& picture) {
  reference::DepthAndNormals image = empty_image(kWidth, kHeight, picture.view);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const reference::DepthAndNormal at = reference::depth_at(picture, x + 0.5, y + 0.5);
      image.distance.push_back(at.distance_m);
      image.normals.push_back(at.normal);
    }
  return image;
}

struct Difference {
  double mean = 0.0;
  int far = 0;  ///< pixels that differ by more than 0.03
};

Difference from_reference(const FloatPicture& drawn, const reference::PictureOf& picture) {
  Difference d;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double off =
          glm::length(glm::dvec3(drawn.at(x, y)) - glm::dvec3(reference::color_at(picture, x + 0.5, y + 0.5)));
      d.mean += off / (kWidth * kHeight);
      d.far += off > 0.03;
    }
  return d;
}

/// Every surface reflects, box and ball have coats, all have a texture of occlusion, and the floor has a normal map.
BuiltScene shiny_scene() {
  BuiltScene built = box_and_sphere_on_floor();
  const std::uint32_t half_open = add_plain_texture(built, {128, 255, 255, 255});
  float roughness = 0.2f;
  for (Material& material : built.scene.materials) {
    material.roughness = roughness += 0.15f;
    material.metallic = roughness > 0.4f ? 1.0f : 0.3f;
    material.occlusion_texture.texture = half_open;
  }
  for (const std::size_t coated : {1u, 2u})
    built.scene.materials[coated].clearcoat = {.factor = 0.9f, .roughness = 0.2f};
  for (Mesh& mesh : built.scene.meshes)
    mesh.primitives[0].texcoords.assign(1,
                                        std::vector<glm::vec2>(mesh.primitives[0].positions.size(), glm::vec2(0.5f)));
  Primitive& floor = built.scene.meshes[0].primitives[0];
  floor.tangents.assign(floor.positions.size(), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
  built.scene.materials[0].normal_texture.texture = add_plain_texture(built, {176, 110, 235, 255});
  return built;
}

TEST_F(mirrored_picture, is_that_of_the_reference_with_bent_normals) {
  const BuiltScene built = shiny_scene();
  RenderOptions options = occluded_ambient_light();
  const FrameResult frame = built.frame();
  for (const bool blur : {false, true}) {
    options.ao.blur = blur;
    options.ao.power = blur ? 3.0f : 1.0f;
    reference::PictureOf picture{built.scene, frame, the_view(), options, kWidth, kHeight};
    const reference::PixelVisibility open = reference_visibility(seen_by_reference(picture), options);
    picture.visibility = open.visibility;
    const FloatPicture drawn = render_float(built, kWidth, kHeight, the_view(), options);
    const Difference by_visibility = from_reference(drawn, picture);
    picture.bend = open.bend;
    const Difference d = from_reference(drawn, picture);
    EXPECT_LT(d.mean, 1.5e-3) << blur;
    EXPECT_LT(d.far, kWidth * kHeight / 50) << blur;  // a sample may fall to either side of an edge
    EXPECT_GT(by_visibility.mean, 3.0 * d.mean) << "bent normals make no difference: the comparison is empty";
  }
}

std::vector<reference::RayTriangle> triangles_of(const BuiltScene& built) {
  std::vector<reference::RayTriangle> triangles;
  const FrameResult frame = built.frame();
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const Primitive& primitive = built.scene.meshes[built.scene.instances[i].mesh].primitives[0];
    const Affined m = the_view().view_from_world * affine_cast<double>(frame.instances[i].world_from_mesh);
    for (std::size_t k = 0; k < primitive.indices.size(); k += 3) {
      reference::RayTriangle& triangle = triangles.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        triangle.corners[c] = transform_point(m, glm::dvec3(primitive.positions[primitive.indices[k + c]]));
        triangle.normals[c] = transform_vector(m, glm::dvec3(primitive.normals[primitive.indices[k + c]]));
      }
    }
  }
  return triangles;
}

/// Fraction of the reflection at each pixel that is not occluded within the radius; negative where nothing is visible.
std::vector<double> unhidden_by_rays(const BuiltScene& built, double roughness) {
  const auto triangles = triangles_of(built);
  const reference::DepthAndNormals image = gpu_depth_and_normals(built, kWidth, kHeight, the_view(), {});
  std::vector<double> shares;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t i = shares.size();
      shares.push_back(image.distance[i] > 0.0 ? 0.0 : -1.0);
      if (image.distance[i] == 0.0 || (x + y) % 3 != 0) continue;  // a third of the pixels is enough
      const glm::dvec3 p = image.point(x, y), n = glm::normalize(image.normals[i]);
      for (const reference::LobeRay& ray :
           reference::lobe_rays(n, -glm::normalize(p), roughness, 48, std::fmod(0.37 * static_cast<double>(i), 1.0)))
        if (!reference::cast(triangles, p + 1e-3 * n, ray.direction, static_cast<double>(kRadius)))
          shares.back() += ray.weight;
    }
  return shares;
}

TEST_F(mirrored_picture, is_nearer_to_rays_than_reflections_that_visibility_alone_scales) {
  for (const float roughness : {0.1f, 0.3f, 0.5f, 0.7f}) {
    BuiltScene built = box_and_sphere_on_floor();
    for (Material& material : built.scene.materials) {
      material.metallic = 1.0f;
      material.roughness = roughness;
      material.base_color = {0.02f, 0.02f, 0.02f, 1.0f};  // surroundings scatter nothing
    }
    RenderOptions options = occluded_ambient_light(), unhindered = options, visibility = options;
    options.lighting.tone_curve = unhindered.lighting.tone_curve = ToneCurve::none;
    unhindered.ao.on = false;
    visibility.show = Show::ao;
    const auto drawn_with = [&](const RenderOptions& with) {
      return render_float(built, kWidth, kHeight, the_view(), with);
    };
    const FloatPicture hidden = drawn_with(options), all = drawn_with(unhindered), open = drawn_with(visibility);
    const std::vector<double> truth = unhidden_by_rays(built, static_cast<double>(roughness));
    double bent_error = 0.0, visibility_error = 0.0, count = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double expected = truth[static_cast<std::size_t>(y * kWidth + x)];
        if (expected < 0.0 || (x + y) % 3 != 0) continue;
        const double share = reference::srgb_decoded(static_cast<double>(hidden.at(x, y).g)) /
                             reference::srgb_decoded(static_cast<double>(all.at(x, y).g));
        bent_error += std::pow(share - expected, 2.0);
        visibility_error += std::pow(static_cast<double>(open.at(x, y).r) - expected, 2.0);
        ++count;
      }
    EXPECT_GT(count, kWidth * kHeight / 6);
    EXPECT_LT(std::sqrt(bent_error), (roughness < 0.2f ? 0.98 : 0.93) * std::sqrt(visibility_error)) << roughness;
  }
}

}  // namespace
}  // namespace sinew::viewer
