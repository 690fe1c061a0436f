// SPDX-License-Identifier: MIT
// Compares the ambient occlusion passes with a double-precision reference, on depth and normals drawn by the GPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/ray_cast.h"
#include "tests/viewer/device_fixture.h"
#include "tests/viewer/reference_visibility.h"

namespace sinew::viewer {
namespace {

constexpr int kSsaoWidth = 63, kSsaoHeight = 48;  // odd: the last column of half-size texels is clamped

class ssao_pass : public DeviceTest {};

RenderOptions ssao_with(float radius) {
  RenderOptions options;
  options.show = Show::ao;
  options.ao.method = OcclusionMethod::ssao;
  options.ao.radius_m = radius;
  options.ao.surface_epsilon_m = 0.02f * radius;
  options.ao.fade_start_m = 0.4f * radius;
  options.ao.fade_end_m = 2.0f * radius;
  return options;
}

std::vector<glm::vec4> greys(const std::vector<double>& values) {
  std::vector<glm::vec4> pixels;
  for (const double value : values) pixels.emplace_back(static_cast<float>(value));
  return pixels;
}

/// A corridor seen from its open end, with a post one pixel wide in front of the back wall. The post is at an odd
/// column of 64 x 48 pixels, which half-size texels miss.
BuiltScene post_in_a_corridor(float pixel_m) {
  BuiltScene built;
  const std::uint32_t grey = built.add_material(matte({0.5f, 0.5f, 0.5f}));
  for (const float side : {-1.0f, 1.0f})
    built.add(showcase::box({0.0f, 0.0f, 0.0f}, {0.2f, 2.0f, 1.0f}), grey, translation({0.5f * side, 0.0f, 1.0f}));
  built.add(showcase::box({0.0f, 0.0f, 0.0f}, {2.0f, 2.0f, 0.1f}), grey, translation({0.0f, 0.0f, -0.1f}));
  built.add(showcase::box({0.0f, 0.0f, 0.0f}, {0.5f * pixel_m, 2.0f, 0.01f}), grey,
            translation({1.5f * pixel_m, 0.0f, 0.3f}));
  return built;
}

TEST_F(ssao_pass, what_no_texel_shows_has_the_visibility_of_the_nearest_one) {
  constexpr double kFov_rad = 0.5, kPost_m = 4.69;
  const auto pixel_m = static_cast<float>(2.0 * kPost_m * std::tan(0.5 * kFov_rad) / 48.0);
  const BuiltScene built = post_in_a_corridor(pixel_m);
  const View view = look_at({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, kFov_rad, 0.05);
  for (const OcclusionMethod method : {OcclusionMethod::ssao, OcclusionMethod::gtao}) {
    RenderOptions options = ssao_with(1.0f);
    options.ao.method = method;
    const FloatPicture picture = render_float(built, 64, 48, view, options);
    for (int y = 16; y < 32; y += 2) {  // rows that have texels
      EXPECT_LT(picture.at(33, y).r, 0.85f) << y;
      EXPECT_NEAR(picture.at(33, y).r, picture.at(32, y).r, 1e-6f) << y;
    }
  }
}

TEST_F(ssao_pass, agrees_with_the_reference_before_and_after_the_blur) {
  const BuiltScene built = box_and_sphere_on_floor();
  for (const bool blur : {false, true}) {
    RenderOptions options = ssao_with(0.6f);
    options.ao.blur = blur;
    const auto image = gpu_depth_and_normals(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);
    const VisibilityDifference d =
        difference_of_visibility(render_float(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options),
                                 reference_visibility(image, options).visibility);
    EXPECT_LT(d.darkest, 0.7) << "nothing is occluded: the comparison is empty";
    // In float, a sample on the border of two pixels may fall to either side: rarely, and for one of 14 samples.
    EXPECT_LT(d.mean, 5e-4) << "blur " << blur;
    EXPECT_LT(d.worst, 0.12) << "blur " << blur;
  }
}

TEST_F(ssao_pass, agrees_with_the_reference_for_other_radii_fades_and_powers) {
  const BuiltScene built = box_and_sphere_on_floor();
  for (const float radius : {0.35f, 1.5f}) {
    RenderOptions options = ssao_with(radius);
    options.ao.power = 1.75f;
    options.ao.fade_end_m = radius;
    options.ao.surface_epsilon_m = 0.1f * radius;
    const auto image = gpu_depth_and_normals(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);
    const VisibilityDifference d =
        difference_of_visibility(render_float(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options),
                                 reference_visibility(image, options).visibility);
    EXPECT_LT(d.darkest, 0.95);
    EXPECT_LT(d.mean, 1e-3) << radius;
  }
}

TEST_F(ssao_pass, agrees_with_the_reference_whatever_the_samples_the_size_and_the_blur) {
  const BuiltScene built = box_and_sphere_on_floor();
  const RenderOptions options = ssao_with(0.6f);
  const auto image = gpu_depth_and_normals(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);
  std::vector<double> before = reference_visibility(image, options).visibility;
  for (const OcclusionShape& shape :
       {OcclusionShape{.samples = 4}, OcclusionShape{.samples = 64}, OcclusionShape{.step = 1},
        OcclusionShape{.blur_reach = 4}, OcclusionShape{.keep_edges = false},
        OcclusionShape{.samples = 32, .step = 1, .blur_reach = 4, .keep_edges = false}}) {
    const std::vector<double> expected = reference_visibility(image, options, shape).visibility;
    EXPECT_GT(difference_of_visibility(FloatPicture{kSsaoWidth, kSsaoHeight, greys(before)}, expected).mean, 1e-3)
        << "the shapes give different pictures";
    const VisibilityDifference d = difference_of_visibility(
        render_float(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options, {}, shape), expected);
    EXPECT_LT(d.mean, 1e-3) << shape.samples << " samples, step " << shape.step << ", reach " << shape.blur_reach;
    EXPECT_LT(d.worst, 2.0 / shape.samples)
        << shape.samples << " samples, step " << shape.step << ", reach " << shape.blur_reach;
    before = expected;
  }
}

TEST_F(ssao_pass, agrees_with_the_reference_where_samples_lie_behind_the_camera) {
  const BuiltScene built = box_and_sphere_on_floor();
  const RenderOptions options = ssao_with(1.5f);
  const View view = look_at({0.2, 0.9, 1.6}, {0.0, 0.3, 0.0}, 1.5, 0.05);
  const auto image = gpu_depth_and_normals(built, kSsaoWidth, kSsaoHeight, view, options);
  const VisibilityDifference d = difference_of_visibility(render_float(built, kSsaoWidth, kSsaoHeight, view, options),
                                                          reference_visibility(image, options).visibility);
  EXPECT_LT(d.darkest, 0.95);
  EXPECT_LT(d.mean, 1e-3);
}

TEST_F(ssao_pass, N31_a_plane_does_not_darken_itself_at_any_slope) {
  for (const double height : {8.0, 2.0, 0.3}) {
    BuiltScene built;
    built.add(square(30.0f), built.add_material(matte({1, 1, 1})));
    RenderOptions options = ssao_with(0.5f);
    options.ao.surface_epsilon_m = 0.0f;  // the result must not depend on the epsilon
    options.ao.blur = false;
    const View view = look_at({0.0, height, 6.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
    const FloatPicture picture = render_float(built, 96, 64, view, options);
    for (const glm::vec4& pixel : picture.pixels) EXPECT_GT(pixel.r, 0.995f) << "eye at height " << height;
  }
}

TEST_F(ssao_pass, N32_a_blocker_far_in_front_leaves_no_halo) {
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  built.add(square(30.0f), white);
  built.add(showcase::box({0.0f, 5.0f, 0.0f}, {0.5f, 0.1f, 0.5f}), white);  // 5 m over the floor, seen from above
  RenderOptions options = ssao_with(0.5f);
  const View view = look_at({0.0, 9.0, 0.01}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  const FloatPicture picture = render_float(built, 64, 64, view, options);
  for (const glm::vec4& pixel : picture.pixels) EXPECT_GT(pixel.r, 0.999f);
}

TEST_F(ssao_pass, N32_occlusion_fades_out_when_its_radius_is_below_three_pixels) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options = ssao_with(0.6f);
  const auto darkest = [&](double distance) {
    const View view = look_at(distance * glm::normalize(glm::dvec3(2.5, 2.2, 4.0)), {0.0, 0.4, 0.0}, 0.8, 0.05);
    const FloatPicture picture = render_float(built, kSsaoWidth, kSsaoHeight, view, options);
    float lowest = 1.0f;
    for (const glm::vec4& pixel : picture.pixels) lowest = std::min(lowest, pixel.r);
    return lowest;
  };
  EXPECT_LT(darkest(5.0), 0.7f);
  EXPECT_NEAR(darkest(0.6 * 0.5 / std::tan(0.4) * kSsaoHeight / 1.2), 1.0f,
              1e-6f);  // radius = 1.2 pixels at the target
}

TEST_F(ssao_pass, N33_the_blur_does_not_carry_occlusion_over_a_silhouette) {
  // Two parallel squares, 1 m apart in height: the lower one is occluded along the edge of the upper one, the upper one
  // nowhere.
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  built.add(square(4.0f), white);
  built.add(showcase::box({0.0f, 0.2f, 0.0f}, {1.0f, 0.2f, 1.0f}), white);
  const RenderOptions options = ssao_with(0.6f);
  const View view = look_at({0.0, 6.0, 0.01}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  const FloatPicture picture = render_float(built, 96, 96, view, options);
  const auto image = gpu_depth_and_normals(built, 96, 96, view, options);
  float darkest_floor = 1.0f, darkest_top = 1.0f;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const bool top = image.distance[i] > 0.0 && image.distance[i] < 5.75;
    float& darkest = top ? darkest_top : darkest_floor;
    darkest = std::min(darkest, picture.pixels[i].r);
  }
  EXPECT_LT(darkest_floor, 0.9f);
  EXPECT_GT(darkest_top, 0.999f);
}

TEST_F(ssao_pass, N34_is_nearer_to_ray_cast_truth_than_no_occlusion_and_steady_between_runs) {
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  const Primitive box = showcase::box({0.0f, 0.6f, 0.0f}, glm::vec3(0.6f));
  built.add(square(4.0f), white);
  built.add(box, white);
  const RenderOptions options = ssao_with(0.6f);
  const FloatPicture picture = render_float(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);
  const auto image = gpu_depth_and_normals(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);

  std::vector<reference::RayTriangle> triangles;
  const View view = view_of_floor();
  for (const Primitive& primitive : {square(4.0f), box})
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
      reference::RayTriangle& triangle = triangles.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        triangle.corners[c] =
            transform_point(view.view_from_world, glm::dvec3(primitive.positions[primitive.indices[i + c]]));
        triangle.normals[c] =
            transform_vector(view.view_from_world, glm::dvec3(primitive.normals[primitive.indices[i + c]]));
      }
    }
  constexpr double kDepthRoundoff = 0x1p-20;  // of points from the depth image
  double with = 0.0, without = 0.0;
  for (int y = 0; y < kSsaoHeight; ++y)
    for (int x = 0; x < kSsaoWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kSsaoWidth + x);
      if (image.distance[i] == 0.0) continue;
      const glm::dvec3 n = image.normals[i], p = reference::leave_surface(image.point(x, y), n, kDepthRoundoff);
      // Rays that leave a box start in no other, so back faces need no test.
      const double open = reference::open_share(triangles, p, n, static_cast<double>(options.ao.radius_m), 64);
      with += std::pow(open - static_cast<double>(picture.pixels[i].r), 2.0);
      without += std::pow(open - 1.0, 2.0);
    }
  EXPECT_LT(std::sqrt(with), 0.75 * std::sqrt(without));
  const FloatPicture again = render_float(built, kSsaoWidth, kSsaoHeight, view_of_floor(), options);
  EXPECT_EQ(picture.pixels, again.pixels);
}

}  // namespace
}  // namespace sinew::viewer
