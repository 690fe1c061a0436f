// SPDX-License-Identifier: MIT
// Pictures of the buffers between passes (Show::normals, depth, ao), compared with the reference renderer alone.
#include <cmath>
#include <vector>

#include "samples/showcase/shapes.h"
#include "tests/reference/picture.h"
#include "tests/viewer/reference_picture.h"
#include "tests/viewer/reference_visibility.h"

namespace sinew::viewer {
namespace {

class show_picture : public DeviceTest {};

constexpr int kShownWidth = 36, kShownHeight = 28;

View the_view() { return look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05); }

/// Shapes of every kind: one-sided, double-sided seen from behind, masked with holes, and glass, which no buffer shows.
BuiltScene shapes() {
  BuiltScene built = box_and_sphere_on_floor();
  Material material = matte({1, 1, 1});
  material.double_sided = true;
  material.alpha_mode = AlphaMode::mask;
  material.base_color_texture.texture = add_noise_texture(built);
  Affine turned = translation({0.0f, 1.4f, -1.2f});
  turned.row[0].x = turned.row[2].z = -1.0f;
  built.add(wall(), built.add_material(material), turned);
  Material glass = matte({1, 1, 1});
  glass.alpha_mode = AlphaMode::blend;
  built.add(showcase::sphere({0.2f, 0.6f, 1.2f}, 0.4f), built.add_material(glass));
  return built;
}

TEST_F(show_picture, normals_are_those_of_the_seen_sides_in_view_space) {
  RenderOptions options;
  options.show = Show::normals;
  for (const bool transparent : {false, true}) {
    options.transparent_background = transparent;
    expect_reference_picture(shapes(), the_view(), options,
                             {.width = kShownWidth, .height = kShownHeight, .sharp = 0.5});
  }
}

TEST_F(show_picture, normals_are_those_of_normal_maps) {
  RenderOptions options;
  options.show = Show::normals;
  for (const bool tangents : {false, true})
    for (const bool behind : {false, true}) {
      BuiltScene built;
      Material material = matte({1, 1, 1});
      material.double_sided = true;
      material.normal_scale = 0.8f;
      material.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
      Primitive p = wall();
      if (!tangents) p.tangents.clear();
      Affine turned;  // about y by 180 degrees
      if (behind) turned.row[0].x = turned.row[2].z = -1.0f;
      built.add(p, built.add_material(material), turned);
      expect_reference_picture(built, view_of_wall(), options, {.bound = 0.002});
    }
}

TEST_F(show_picture, depth_is_bright_near_and_dark_far_within_its_range) {
  RenderOptions options;
  options.show = Show::depth;
  options.depth_range = {3.2f, 6.0f};
  View parallel = the_view();
  parallel.half_height_m = 1.8;
  parallel.far_m = 9.0;
  View cut = the_view();
  cut.far_m = 5.0;
  for (const View& view : {the_view(), parallel, cut})
    expect_reference_picture(shapes(), view, options, {.width = kShownWidth, .height = kShownHeight, .sharp = 0.5});
}

TEST_F(show_picture, ambient_visibility_is_white_where_nothing_asks_for_it) {
  RenderOptions off, rays;
  off.ao.on = false;
  rays.ao.method = OcclusionMethod::rays;  // and no vertex has any
  for (RenderOptions* options : {&off, &rays}) {
    options->show = Show::ao;
    for (const glm::vec4& pixel : render_float(shapes(), kShownWidth, kShownHeight, the_view(), *options).pixels)
      ASSERT_NEAR(pixel.r, 1.0f, 1e-3f);  // of a half float
  }
}

/// Compares ambient visibility with the reference's, from the depth and the normals that the reference sees.
void expect_reference_visibility(const BuiltScene& built, double bound) {
  RenderOptions options;
  options.show = Show::ao;
  options.ao.radius_m = 0.7f;
  const FrameResult frame = built.frame();
  const reference::PictureOf picture{built.scene, frame, the_view(), options, kShownWidth, kShownHeight};
  reference::DepthAndNormals image = empty_image(kShownWidth, kShownHeight, the_view());
  for (int y = 0; y < kShownHeight; ++y)
    for (int x = 0; x < kShownWidth; ++x) {
      const reference::DepthAndNormal at = reference::depth_at(picture, x + 0.5, y + 0.5);
      image.distance.push_back(at.distance_m);
      image.normals.push_back(at.normal);
    }
  const std::vector<double> visibility = reference_visibility(image, options).visibility;
  const FloatPicture drawn = render_float(built, kShownWidth, kShownHeight, the_view(), options);
  double mean = 0.0, occluded = 0.0;
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    mean += std::abs(static_cast<double>(drawn.pixels[i].r) - visibility[i]) / static_cast<double>(visibility.size());
    occluded += (1.0 - visibility[i]) / static_cast<double>(visibility.size());
  }
  EXPECT_GT(occluded, 0.015) << "nothing is occluded: the comparison is empty";
  EXPECT_LT(mean, bound);  // a sample may fall to either side of an edge
}

TEST_F(show_picture, ambient_visibility_is_that_of_the_reference_from_its_own_depth_and_normals) {
  expect_reference_visibility(box_and_sphere_on_floor(), 2e-3);
}

TEST_F(show_picture, ambient_visibility_is_that_of_the_normals_of_normal_maps) {
  BuiltScene built = box_and_sphere_on_floor();
  const std::uint32_t leaning = add_plain_texture(built, {196, 100, 225, 255});
  for (Material& material : built.scene.materials) material.normal_texture.texture = leaning;
  expect_reference_visibility(built, 5e-3);  // the floor rises above the horizon of leaning normals everywhere
}

}  // namespace
}  // namespace sinew::viewer
