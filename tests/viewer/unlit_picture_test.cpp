// SPDX-License-Identifier: MIT
// KHR_materials_unlit: colours are displayed as the file has them. Exposure and tone curve apply only to light.
#include <cmath>

#include "tests/viewer/reference_picture.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

class unlit_picture : public DeviceTest {};

constexpr ToneCurve kCurves[] = {ToneCurve::neutral, ToneCurve::aces, ToneCurve::none};

Material unlit(const glm::vec4& color, AlphaMode mode = AlphaMode::opaque) {
  Material material;
  material.unlit = true;
  material.base_color = color;
  material.alpha_mode = mode;
  return material;
}

glm::vec4 color_of_bytes(int r, int g, int b) {
  const auto linear = [](int byte) { return linear_from_srgb(static_cast<float>(byte) / 255.0f); };
  return {linear(r), linear(g), linear(b), 1.0f};
}

int byte_of(float value) { return static_cast<int>(std::lround(value * 255.0f)); }

RenderOptions displayed_with(ToneCurve curve, float exposure) {
  RenderOptions options;
  options.ao.on = false;
  options.lighting.tone_curve = curve;
  options.lighting.exposure = exposure;
  return options;
}

TEST_F(unlit_picture, colors_come_out_to_the_byte_with_every_tone_curve_and_exposure) {
  for (int first = 0; first < 256; first += 15) {
    const int r = first, g = 255 - first, b = (first * 7) % 256;
    BuiltScene built;
    built.add(wall(), built.add_material(unlit(color_of_bytes(r, g, b))));
    for (const ToneCurve curve : kCurves)
      for (const float exposure : {0.125f, 1.0f, 9.0f}) {
        const glm::vec4 pixel = render_float(built, 4, 4, view_of_wall(), displayed_with(curve, exposure)).at(2, 2);
        EXPECT_EQ(byte_of(pixel.x), r) << static_cast<int>(curve) << " " << exposure;
        EXPECT_EQ(byte_of(pixel.y), g) << static_cast<int>(curve) << " " << exposure;
        EXPECT_EQ(byte_of(pixel.z), b) << static_cast<int>(curve) << " " << exposure;
      }
  }
}

/// A lit wall with panes before it, each covering another part: unlit and lit ones, blended over each other.
BuiltScene panes_before_a_wall(AlphaMode mode) {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.7f, 0.4f, 0.2f})));
  built.add(wall(), built.add_material(unlit({0.1f, 0.9f, 0.3f, 0.6f}, mode)), translation({0.9f, 0.0f, 0.2f}));
  Material glass = matte({0.2f, 0.3f, 0.9f});
  glass.base_color.a = 0.4f;
  glass.alpha_mode = AlphaMode::blend;
  built.add(wall(), built.add_material(glass), translation({0.0f, 1.0f, 0.3f}));
  return built;
}

TEST_F(unlit_picture, lit_and_unlit_surfaces_blend_as_the_reference_has_it) {
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend})
    for (const ToneCurve curve : kCurves)
      for (const bool transparent : {false, true}) {
        RenderOptions options = displayed_with(curve, 2.5f);
        options.transparent_background = transparent;
        const View straight = look_at({0.5, 0.4, 3.0}, {0.5, 0.4, 0.0}, 0.8, 0.05);
        expect_reference_picture(panes_before_a_wall(mode), straight, options, {.bound = 0.002});
      }
}

TEST_F(unlit_picture, smooth_edges_are_shares_of_the_displayed_colors) {
  BuiltScene built;
  built.add(wall(), built.add_material(unlit({1, 1, 1, 1})));
  RenderOptions options = displayed_with(ToneCurve::aces, 4.0f);
  options.smooth_edges = true;
  const float behind = linear_from_srgb(options.background.x);
  bool partly = false;
  const View far = look_at({1.0, 0.7, 6.0}, {0.0, 0.0, 0.0}, 0.6, 0.05);
  for (const glm::vec4& pixel : render_float(built, 32, 32, far, options).pixels) {
    const float share = (linear_from_srgb(pixel.x) - behind) / (1.0f - behind), quarters = 4.0f * share;
    EXPECT_NEAR(quarters, std::round(quarters), 0.01f);
    partly = partly || (share > 0.2f && share < 0.8f);
  }
  EXPECT_TRUE(partly) << "the picture has edges";
}

TEST_F(unlit_picture, light_alone_is_drawn_as_without_unlit_surfaces) {
  BuiltScene lit, both;
  for (BuiltScene* built : {&lit, &both}) built->add(wall(), built->add_material(matte({0.7f, 0.4f, 0.2f})));
  both.add(square(0.001f), both.add_material(unlit({1, 0, 0, 1})), translation({0.0f, -0.1f, 0.01f}));
  const RenderOptions options = displayed_with(ToneCurve::neutral, 1.0f);
  const FloatPicture a = render_float(lit, 16, 16, view_of_wall(), options),
                     b = render_float(both, 16, 16, view_of_wall(), options);
  EXPECT_EQ(a.at(1, 1), b.at(1, 1));
  EXPECT_EQ(a.at(14, 14), b.at(14, 14));
}

}  // namespace
}  // namespace sinew::viewer
