// SPDX-License-Identifier: MIT
#include "viewer/app/camera/file_camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/math/transform.h"

namespace sinew::viewer {
namespace {

TEST(file_camera, looks_along_minus_z_of_its_node_whatever_its_scale) {
  Camera camera;
  camera.fov_y_rad = 0.5f;
  camera.near_m = 0.25f;
  const Transform local{{1, 2, 3}, quat_xyzw(0.0f, 0.70710678f, 0.0f, 0.70710678f), {2, 3, 4}};
  const View view = view_of_camera(camera, affine_from_transform(local), 1.5, {});
  EXPECT_FALSE(view.parallel());
  EXPECT_NEAR(view.fov_y_rad, 0.5, 1e-7);
  EXPECT_EQ(view.near_m, 0.25);
  EXPECT_EQ(view.far_m, 0.0) << "no far plane in the file";
  const glm::dvec3 ahead =
      transform_point(view.view_from_world, glm::dvec3(-4.0, 2.0, 3.0));  // turned by 90 degrees it looks along -x
  EXPECT_NEAR(ahead.x, 0.0, 1e-6);
  EXPECT_NEAR(ahead.y, 0.0, 1e-6);
  EXPECT_NEAR(ahead.z, -5.0, 1e-6);
}

TEST(file_camera, shows_all_that_it_sees_in_a_picture_of_any_shape) {
  Camera camera;
  camera.fov_y_rad = 0.8f;
  camera.aspect = 1.5f;
  const double half = std::tan(0.4);
  const auto half_height = [&](double aspect) {
    return std::tan(0.5 * view_of_camera(camera, Affine{}, aspect, {}).fov_y_rad);
  };
  EXPECT_NEAR(half_height(1.5), half, 1e-7);
  EXPECT_NEAR(half_height(3.0), half, 1e-7) << "a wider picture shows more at the sides";
  EXPECT_NEAR(half_height(0.5), half * 3.0, 1e-7) << "a narrower one above and below";
  camera.aspect = 0.0f;
  EXPECT_NEAR(half_height(0.5), half, 1e-7) << "without a shape of its own it has the picture's";
}

TEST(file_camera, orthographic_ones_show_width_and_height_fully) {
  Camera camera;
  camera.perspective = false;
  camera.half_width = 3.0f;
  camera.half_height = 2.0f;
  EXPECT_NEAR(view_of_camera(camera, Affine{}, 1.5, {}).half_height_m, 2.0, 1e-12);
  EXPECT_NEAR(view_of_camera(camera, Affine{}, 4.0, {}).half_height_m, 2.0, 1e-12);
  EXPECT_NEAR(view_of_camera(camera, Affine{}, 0.5, {}).half_height_m, 6.0, 1e-12);
  camera.half_width = -3.0f;
  camera.half_height = -2.0f;  // valid, if unusual: glTF only forbids zero
  EXPECT_NEAR(view_of_camera(camera, Affine{}, 1.5, {}).half_height_m, 2.0, 1e-12);
  EXPECT_NEAR(view_of_camera(camera, Affine{}, 0.5, {}).half_height_m, 6.0, 1e-12);
}

TEST(file_camera, orthographic_ones_have_a_far_plane_behind_everything) {
  Camera camera;
  camera.perspective = false;
  camera.half_height = 2.5f;
  camera.near_m = 0.0f;
  const Aabb box{{-1, -1, -21}, {1, 1, -19}};
  const View view = view_of_camera(camera, Affine{}, 1.0, box);
  EXPECT_TRUE(view.parallel());
  EXPECT_EQ(view.near_m, 0.0);
  EXPECT_GT(view.far_m, 21.0);
  camera.far_m = 30.0f;
  EXPECT_EQ(view_of_camera(camera, Affine{}, 1.0, box).far_m, 30.0);
}

TEST(file_camera, keeps_the_far_plane_of_a_perspective_one) {
  Camera camera;
  camera.near_m = 0.5f;
  camera.far_m = 8.0f;
  EXPECT_EQ(view_of_camera(camera, Affine{}, 1.0, {}).far_m, 8.0);
}

TEST(file_camera, whatever_a_clip_does_to_it_the_view_is_finite_and_not_empty) {
  for (const float x : {-2.0f, 0.0f, 7.0f, 1e30f})
    for (const bool perspective : {true, false}) {
      const Camera camera{.perspective = perspective,
                          .fov_y_rad = x,
                          .aspect = x,
                          .half_width = x,
                          .half_height = x,
                          .near_m = x,
                          .far_m = 0.5f * x};
      Affine flat;
      flat.row[0] = flat.row[1] = flat.row[2] = glm::vec4(0.0f);
      const View view = view_of_camera(camera, flat, 1.5, {});
      EXPECT_TRUE(std::isfinite(view.view_from_world.row[0].x) && std::isfinite(view.far_m)) << x;
      EXPECT_GT(perspective ? view.near_m : view.half_height_m, 0.0) << x;
      EXPECT_GT(view.fov_y_rad, 0.0) << x;
      EXPECT_LT(view.fov_y_rad, 3.14159265) << x;
      EXPECT_TRUE(view.far_m > view.near_m || (perspective && view.far_m == 0.0)) << x;
    }
}

}  // namespace
}  // namespace sinew::viewer
