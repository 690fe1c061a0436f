// SPDX-License-Identifier: MIT
// Order-independent blending, compared with its equation in double precision. Also its error against exact per-pixel
// order where surfaces intersect, which sorting whole primitives cannot solve.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/reference/picture.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class weighted_picture : public DeviceTest {};

Material pane(const glm::vec4& color, bool unlit = false) {
  Material material = matte(glm::vec3(color));
  material.base_color.a = color.a;
  material.alpha_mode = AlphaMode::blend;
  material.double_sided = true;
  material.unlit = unlit;
  return material;
}

RenderOptions weighted(RenderOptions options = every_light()) {
  options.transparency = Transparency::weighted;
  return options;
}

/// Four panes before a lit wall. Some panes are lit and some are not; each has its own distance and hides another part
/// of the wall.
BuiltScene panes_before_a_wall(bool reversed = false) {
  struct Pane {
    Material material;
    glm::vec3 at;
  };
  std::vector<Pane> panes = {{pane({0.1f, 0.9f, 0.3f, 0.6f}, true), {0.9f, 0.0f, 0.2f}},
                             {pane({0.2f, 0.3f, 0.9f, 0.4f}), {0.0f, 1.0f, 0.3f}},
                             {pane({0.9f, 0.2f, 0.1f, 0.8f}), {-1.0f, -0.7f, 0.6f}},
                             {pane({0.8f, 0.8f, 0.1f, 0.1f}), {0.4f, -0.6f, 0.9f}}};
  if (reversed) std::reverse(panes.begin(), panes.end());
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.7f, 0.4f, 0.2f})), translation({-0.8f, 0.0f, 0.0f}));
  for (const Pane& p : panes) built.add(wall(), built.add_material(p.material), translation(p.at));
  return built;
}

const View kStraight = look_at({0.3, 0.2, 4.0}, {0.3, 0.2, 0.0}, 0.9, 0.05);

TEST_F(weighted_picture, is_the_weighted_mean_of_the_equation_over_what_is_behind) {
  for (const ToneCurve curve : {ToneCurve::neutral, ToneCurve::aces, ToneCurve::none})
    for (const bool transparent : {false, true}) {
      RenderOptions options = weighted();
      options.lighting.tone_curve = curve;
      options.lighting.exposure = 2.5f;
      options.transparent_background = transparent;
      expect_reference_picture(panes_before_a_wall(), kStraight, options, {.bound = 0.003});
    }
}

TEST_F(weighted_picture, holds_the_sums_of_strong_light) {
  RenderOptions options = weighted();
  options.lighting.key *= 5e4f;
  options.lighting.environment = nullptr;
  options.lighting.exposure = 1e-5f;
  BuiltScene built = panes_before_a_wall();
  for (int i = 0; i < 12; ++i)
    built.add(wall(), built.add_material(pane({0.7f, 0.8f, 0.9f, 0.9f})),
              translation({0.0f, 0.0f, 1.0f + 0.01f * static_cast<float>(i)}));
  expect_reference_picture(built, kStraight, options, {.bound = 0.003});
}

TEST_F(weighted_picture, of_gooch_shading_is_of_its_tones) {
  RenderOptions options = weighted();
  options.shading = Shading::gooch;
  expect_reference_picture(panes_before_a_wall(), kStraight, options, {.bound = 0.003});
  BuiltScene alone;
  alone.add(wall(), alone.add_material(pane({0.2f, 0.3f, 0.9f, 0.6f})));
  alone.add(wall(), alone.add_material(pane({0.9f, 0.2f, 0.1f, 0.4f})), translation({0.4f, 0.3f, 0.5f}));
  options.lighting.exposure = 3.0f;  // which changes no tone
  expect_reference_picture(alone, kStraight, options, {.bound = 0.003});
}

TEST_F(weighted_picture, leaves_surfaces_that_light_passes_through_behind_those_that_blend) {
  Material glass;
  glass.base_color = {0.9f, 0.5f, 0.2f, 1.0f};
  glass.roughness = 0.3f;
  glass.metallic = 0.0f;
  glass.transmission.factor = 0.8f;
  BuiltScene built = panes_before_a_wall();
  built.add(wall(), built.add_material(glass), translation({0.5f, 0.5f, 0.1f}));
  expect_reference_picture(built, kStraight, weighted(), {.bound = 0.003});
}

TEST_F(weighted_picture, does_not_depend_on_the_order_of_the_file) {
  const FloatPicture a = render_float(panes_before_a_wall(false), 32, 24, kStraight, weighted()),
                     b = render_float(panes_before_a_wall(true), 32, 24, kStraight, weighted());
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a.pixels[i][c], b.pixels[i][c], 0.002f) << "half floats are summed";
}

TEST_F(weighted_picture, with_one_pane_at_each_pixel_is_the_sorted_one) {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.7f, 0.4f, 0.2f})));
  built.add(wall(), built.add_material(pane({0.1f, 0.9f, 0.3f, 0.6f}, true)), translation({1.3f, 0.33f, 0.2f}));
  built.add(wall(), built.add_material(pane({0.2f, 0.3f, 0.9f, 0.02f})), translation({-1.2f, -0.33f, 0.9f}));
  for (const auto& [smooth, unlit_behind] : {std::pair(false, false), {false, true}, {true, false}}) {
    built.scene.materials[0].unlit = unlit_behind;
    RenderOptions options = every_light();
    options.smooth_edges = smooth;
    const FloatPicture sorted = render_float(built, 32, 24, kStraight, options),
                       summed = render_float(built, 32, 24, kStraight, weighted(options));
    int apart = 0;
    for (std::size_t i = 0; i < sorted.pixels.size(); ++i)
      for (int c = 0; c < 4; ++c) {
        const float off = std::abs(sorted.pixels[i][c] - summed.pixels[i][c]);
        EXPECT_LT(off, smooth ? 0.06f : 0.004f) << i;
        apart += off > 0.004f;
      }
    EXPECT_LT(apart, 40) << "samples are averaged before they lie over each other: seen where two edges cross a pixel";
  }
}

TEST_F(weighted_picture, automatic_exposure_counts_the_light_of_what_blends) {
  const BuiltScene built = panes_before_a_wall();
  RenderOptions options = weighted();
  options.lighting.auto_exposure = true;
  const FrameResult frame = built.frame();
  const double expected = reference::automatic_exposure({built.scene, frame, kStraight, options, 48, 36, Gradient{}});
  const FloatPicture followed = render_float(built, 48, 36, kStraight, options);
  options.lighting.auto_exposure = false;
  options.lighting.exposure = static_cast<float>(expected);
  const FloatPicture given = render_float(built, 48, 36, kStraight, options);
  for (std::size_t i = 0; i < given.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(followed.pixels[i][c], given.pixels[i][c], 0.003) << i << " " << expected;
}

/// Panes of one height through each other, turned about the vertical axis like the doors of a revolving door.
BuiltScene revolving_door() {
  BuiltScene built;
  const glm::vec4 colors[] = {{0.9f, 0.1f, 0.1f, 0.5f}, {0.1f, 0.8f, 0.2f, 0.5f}, {0.1f, 0.2f, 0.9f, 0.5f}};
  for (int i = 0; i < 3; ++i) {
    const float angle = 0.5f + 1.05f * static_cast<float>(i);
    Affine turned;
    turned.row[0] = {std::cos(angle), 0.0f, std::sin(angle), 0.0f};
    turned.row[2] = {-std::sin(angle), 0.0f, std::cos(angle), 0.0f};
    built.add(wall(), built.add_material(pane(colors[i], true)), turned);
  }
  return built;
}

/// Mean distance of a picture from the one in which each pixel has its own order, per channel.
double mean_error(const BuiltScene& built, const View& view, RenderOptions options) {
  constexpr int kWidth = 64, kHeight = 48;
  const FloatPicture drawn = render_float(built, kWidth, kHeight, view, options);
  options.transparency = Transparency::sorted;  // the reference sorts the surfaces of each pixel
  const FrameResult frame = built.frame();
  const reference::PictureOf exact{built.scene, frame, view, options, kWidth, kHeight, {}, {}};
  double sum = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec4 color = reference::color_at(exact, x + 0.5, y + 0.5);
      for (int c = 0; c < 3; ++c) sum += std::abs(color[c] - static_cast<double>(drawn.at(x, y)[c]));
    }
  return sum / (3.0 * kWidth * kHeight);
}

TEST_F(weighted_picture, is_nearer_to_the_exact_order_where_surfaces_intersect) {
  const View view = look_at({0.0, 0.4, 4.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  const double sorted = mean_error(revolving_door(), view, every_light()),
               summed = mean_error(revolving_door(), view, weighted());
  RecordProperty("sorted", std::to_string(sorted));
  RecordProperty("weighted", std::to_string(summed));
  EXPECT_LT(summed, 0.5 * sorted) << sorted;
  EXPECT_LT(summed, 0.008);
}

}  // namespace
}  // namespace sinew::viewer
