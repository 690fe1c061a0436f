// SPDX-License-Identifier: MIT
// Automatic exposure: maps the log average to middle grey; deterministic.
#include <tuple>
#include <utility>

#include "tests/reference/picture.h"
#include "tests/viewer/reference_picture.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

class exposure : public DeviceTest {};

RenderOptions automatic() {
  RenderOptions options;
  options.ao.on = false;
  options.lighting.auto_exposure = true;
  return options;
}

/// A wall with an unlit pane and glass before it, under the default light.
BuiltScene wall_and_panes() {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.7f, 0.4f, 0.2f})));
  Material sign = matte({0.9f, 0.9f, 0.1f});
  sign.unlit = true;
  built.add(wall(), built.add_material(sign), translation({1.7f, 0.0f, 0.1f}));
  Material glass = matte({0.1f, 0.2f, 0.9f});
  glass.base_color.a = 0.5f;
  glass.alpha_mode = AlphaMode::blend;
  built.add(wall(), built.add_material(glass), translation({0.0f, 1.5f, 0.2f}));
  return built;
}

/// Expects that automatic exposure gives the same picture as the reference's exposure set by hand.
void expect_exposure_of_reference(const BuiltScene& built, const View& view, int width, int height, float key) {
  RenderOptions options = automatic();
  options.lighting.key *= key;
  options.lighting.environment_intensity = key;
  const FrameResult frame = built.frame();
  const double expected = reference::automatic_exposure({built.scene, frame, view, options, width, height, Gradient{}});
  const FloatPicture followed = render_float(built, width, height, view, options);
  options.lighting.auto_exposure = false;
  options.lighting.exposure = static_cast<float>(expected);
  const FloatPicture given = render_float(built, width, height, view, options);
  for (std::size_t i = 0; i < given.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(followed.pixels[i][c], given.pixels[i][c], 0.002) << i << " " << expected;
}

TEST_F(exposure, follows_the_log_average_of_light) {
  const BuiltScene built = wall_and_panes();
  const View view = look_at({0.5, 0.4, 3.0}, {0.5, 0.4, 0.0}, 0.8, 0.05);
  for (const float key : {1e-3f, 1.0f, 500.0f}) expect_exposure_of_reference(built, view, 48, 36, key);
  for (const auto& [width, height] : {std::pair(1, 1), {640, 2}, {3, 200}})
    expect_exposure_of_reference(built, view_of_wall(), width, height, 1.0f);
}

TEST_F(exposure, of_a_lamp_of_54351_candela_shows_the_wall_and_not_white) {
  BuiltScene built;
  built.add(wall(), built.add_material(matte({0.7f, 0.4f, 0.2f})));
  add_light_at(built, {.kind = Light::Kind::point, .intensity = 54351.0f}, {0.0f, 0.0f, 4.0f}, {0, 0, -1});
  RenderOptions options = automatic();
  const glm::vec4 followed = render_float(built, 16, 16, view_of_wall(), options).at(8, 8);
  EXPECT_GT(followed.x, followed.z + 0.1f) << "the colour of the wall is seen";
  EXPECT_NEAR(followed.y, 0.46f, 0.1f) << "about middle grey";
  options.lighting.auto_exposure = false;
  EXPECT_GT(render_float(built, 16, 16, view_of_wall(), options).at(8, 8).z, 0.95f) << "white at EV 0";
}

TEST_F(exposure, is_1_where_nothing_gives_light) {
  const View away = look_at({0, 0, 5}, {0, 0, 9}, 0.8, 0.05);
  BuiltScene lit = wall_and_panes(), dark, sign;
  dark.add(wall(), dark.add_material(matte({0.7f, 0.4f, 0.2f})));
  Material unlit = matte({0.9f, 0.9f, 0.1f});
  unlit.unlit = true;
  sign.add(wall(), sign.add_material(unlit));
  const View wide = look_at({0, 0, 6}, {0, 0, 0}, 0.8, 0.05);  // the backdrop is seen beside the sign
  RenderOptions none = automatic();
  none.lighting.key = glm::vec3(0.0f);
  none.lighting.environment = nullptr;
  for (const auto& [built, view, asked] : {std::tuple(&lit, away, automatic()), std::tuple(&dark, view_of_wall(), none),
                                           std::tuple(&sign, wide, automatic())}) {
    RenderOptions options = asked;
    options.backdrop = Backdrop::sharp;
    const FloatPicture followed = render_float(*built, 16, 16, view, options);
    options.lighting.auto_exposure = false;
    EXPECT_EQ(followed.pixels, render_float(*built, 16, 16, view, options).pixels);
  }
}

TEST_F(exposure, is_the_same_each_time_and_takes_the_given_one_as_stops_besides) {
  const BuiltScene built = wall_and_panes();
  RenderOptions options = automatic();
  options.smooth_edges = true;
  options.lighting.tone_curve = ToneCurve::none;
  const FloatPicture first = render_float(built, 100, 70, view_of_wall(), options);
  EXPECT_EQ(first.pixels, render_float(built, 100, 70, view_of_wall(), options).pixels);
  options.lighting.exposure = 0.25f;
  const FloatPicture darker = render_float(built, 100, 70, view_of_wall(), options);
  EXPECT_NEAR(linear_from_srgb(darker.at(20, 60).x), 0.25f * linear_from_srgb(first.at(20, 60).x), 1e-4f);
}

}  // namespace
}  // namespace sinew::viewer
