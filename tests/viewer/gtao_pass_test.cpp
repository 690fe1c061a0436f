// SPDX-License-Identifier: MIT
// Compares horizon-based ambient visibility with a double-precision reference on depth and normals drawn by the GPU,
// and with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "tests/viewer/reference_visibility.h"

namespace sinew::viewer {
namespace {

constexpr int kGtaoWidth = 63, kGtaoHeight = 48;

class gtao_pass : public DeviceTest {};

RenderOptions gtao_with(float radius) {
  RenderOptions options;
  options.show = Show::ao;
  options.ao.method = OcclusionMethod::gtao;
  options.ao.radius_m = radius;
  options.ao.surface_epsilon_m = 0.02f * radius;
  return options;
}

TEST_F(gtao_pass, agrees_with_the_reference_whatever_the_slices_the_size_and_the_radius) {
  const BuiltScene built = box_and_sphere_on_floor();
  for (const float radius : {0.6f, 1.4f})
    for (const bool blur : {false, true})
      for (const OcclusionShape& shape : {OcclusionShape{}, OcclusionShape{.slices = 1, .steps = 4, .step = 1},
                                          OcclusionShape{.slices = 3, .steps = 2}}) {
        RenderOptions options = gtao_with(radius);
        options.ao.blur = blur;
        options.ao.power = blur ? 1.7f : 1.0f;
        const auto image = gpu_depth_and_normals(built, kGtaoWidth, kGtaoHeight, view_of_floor(), options);
        const VisibilityDifference d =
            difference_of_visibility(render_float(built, kGtaoWidth, kGtaoHeight, view_of_floor(), options, {}, shape),
                                     reference_visibility(image, options, shape).visibility);
        EXPECT_LT(d.darkest, 0.7) << "nothing is occluded: the comparison is empty";
        EXPECT_LT(d.mean, 2e-3) << shape.slices << ' ' << blur;
        // In float, a point on the border of two pixels, or at the radius, may fall to either side.
        EXPECT_LT(d.far, kGtaoWidth * kGtaoHeight / 50) << shape.slices << ' ' << blur;
      }
}

TEST_F(gtao_pass, agrees_with_the_reference_where_normals_point_away_from_the_picture) {
  // At the edges of a wide view, spheres are visible beyond their equators, down to the wall that they intersect.
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  for (const glm::vec3& side : {glm::vec3(2.6f, 0, -1.2f), {-2.6f, 0, -1.2f}, {0, 2.6f, -1.2f}, {0, -2.6f, -1.2f}})
    built.add(showcase::sphere(side, 1.0f), white);
  built.add(showcase::box({0.0f, 0.0f, -1.7f}, {6.0f, 5.0f, 0.1f}), white);
  const View view = look_at({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 2.2, 0.05);
  const RenderOptions options = gtao_with(0.6f);
  const auto image = gpu_depth_and_normals(built, kGtaoWidth, kGtaoHeight, view, options);
  const std::vector<double> expected = reference_visibility(image, options).visibility;
  const FloatPicture picture = render_float(built, kGtaoWidth, kGtaoHeight, view, options);
  double mean = 0.0, occluded = 0.0;
  int quadrants[2][2] = {};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const glm::dvec3& n = image.normals[i];
    if (n.z > -0.05) continue;
    ++quadrants[n.x > 0.0][n.y > 0.0];
    mean += std::abs(static_cast<double>(picture.pixels[i].r) - expected[i]);
    occluded += 1.0 - expected[i];
  }
  const int count = quadrants[0][0] + quadrants[0][1] + quadrants[1][0] + quadrants[1][1];
  for (const auto& side : quadrants)
    for (const int pixels : side) EXPECT_GT(pixels, 10);
  EXPECT_GT(occluded / count, 0.1);
  EXPECT_LT(mean / count, 1e-3) << count << " " << occluded / count;
}

TEST_F(gtao_pass, N31_a_plane_does_not_darken_itself_at_any_slope) {
  for (const double height : {8.0, 2.0, 0.3}) {
    BuiltScene built;
    built.add(square(30.0f), built.add_material(matte({1, 1, 1})));
    RenderOptions options = gtao_with(0.5f);
    options.ao.blur = false;
    const View view = look_at({0.0, height, 6.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
    for (const glm::vec4& pixel : render_float(built, 96, 64, view, options).pixels)
      EXPECT_GT(pixel.r, 0.995f) << "eye at height " << height;
  }
}

/// Visibility beside a wall that is wider and higher than the radius R, at the distance a < R.
/// eq   rays at the angle t from the floor's normal towards the wall, and turned by f from its normal, meet it within R
///      where sin t cos f >= a / R; the cosine-weighted share of these is
///      (acos(a/R) - a/R sqrt(1 - (a/R)^2)) / pi
double visibility_beside_wall(double part) {
  return 1.0 - (std::acos(part) - part * std::sqrt(1.0 - part * part)) / std::numbers::pi;
}

TEST_F(gtao_pass, is_what_is_open_beside_a_wall) {
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  built.add(square(30.0f), white);
  Affine upright;  // the plane x = 0, facing +x
  upright.row[0] = {0, 1, 0, 0};
  upright.row[1] = {-1, 0, 0, 0};
  built.add(square(30.0f), white, upright);
  const RenderOptions options = gtao_with(1.0f);
  View down = look_at({2.0, 8.0, 0.0}, {1.0, 0.0, 0.0}, 0.5, 0.05);
  const int width = 161, height = 121;
  const FloatPicture picture =
      render_float(built, width, height, down, options, {}, {.slices = 8, .steps = 16, .step = 1});
  const auto image = gpu_depth_and_normals(built, width, height, down, options);
  const Affined world_from_view = [&] {
    Affined m;
    const glm::dvec3 eye = eye_of(down);
    for (int r = 0; r < 3; ++r)
      m.row[static_cast<std::size_t>(r)] = glm::dvec4(down.view_from_world.row[0][r], down.view_from_world.row[1][r],
                                                      down.view_from_world.row[2][r], eye[r]);
    return m;
  }();
  int compared = 0;
  double sum = 0.0;
  for (int y = 35; y < height - 35; ++y)  // rays of a metre stay in the picture
    for (int x = 35; x < width - 35; ++x) {
      const auto i = static_cast<std::size_t>(y * width + x);
      const glm::dvec3 p = transform_point(world_from_view, image.point(x, y));
      if (std::abs(p.y) > 0.01 || p.x < 0.1 || p.x > 0.9) continue;
      const double off = std::abs(static_cast<double>(picture.pixels[i].r) - visibility_beside_wall(p.x));
      EXPECT_LT(off, 0.05) << "at " << p.x << " m";
      sum += off;
      ++compared;
    }
  EXPECT_GT(compared, 500);
  EXPECT_LT(sum / compared, 0.025);
}

TEST_F(gtao_pass, N32_a_blocker_far_in_front_leaves_no_halo) {
  BuiltScene built;
  const std::uint32_t white = built.add_material(matte({1, 1, 1}));
  built.add(square(30.0f), white);
  built.add(showcase::box({0.0f, 5.0f, 0.0f}, {0.5f, 0.1f, 0.5f}), white);  // 5 m over the floor, seen from above
  const View view = look_at({0.0, 9.0, 0.01}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  for (const glm::vec4& pixel : render_float(built, 64, 64, view, gtao_with(0.5f)).pixels) EXPECT_GT(pixel.r, 0.99f);
}

TEST_F(gtao_pass, fades_out_when_its_radius_is_below_three_pixels_and_is_steady) {
  const BuiltScene built = box_and_sphere_on_floor();
  const RenderOptions options = gtao_with(0.6f);
  const auto at = [&](double distance) {
    const View view = look_at(distance * glm::normalize(glm::dvec3(2.5, 2.2, 4.0)), {0.0, 0.4, 0.0}, 0.8, 0.05);
    return render_float(built, kGtaoWidth, kGtaoHeight, view, options).pixels;
  };
  const auto darkest = [](const std::vector<glm::vec4>& pixels) {
    return std::min_element(pixels.begin(), pixels.end(), [](const auto& a, const auto& b) { return a.r < b.r; })->r;
  };
  EXPECT_LT(darkest(at(5.0)), 0.7f);
  EXPECT_NEAR(darkest(at(0.6 * 0.5 / std::tan(0.4) * kGtaoHeight / 1.2)), 1.0f,
              1e-6f);  // radius = 1.2 pixels at the target
  EXPECT_EQ(at(5.0), at(5.0));
}

}  // namespace
}  // namespace sinew::viewer
