// SPDX-License-Identifier: MIT
// Per-vertex ambient visibility: between key poses, in pictures, and in lighting.
#include "viewer/upload/visibility_blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

TEST(visibility_blend, lies_between_the_two_nearest_key_poses_and_stays_at_the_ends) {
  VertexVisibility visibility;
  visibility.clip = 3;
  visibility.times_s = {0.0, 1.0, 4.0};
  const auto expect = [&](double time_s, std::uint32_t pose, std::uint32_t next, float factor) {
    EXPECT_EQ(visibility_blend(visibility, 3, time_s), (VisibilityBlend{pose, next, factor})) << time_s;
  };
  expect(0.0, 0, 1, 0.0f);
  expect(0.25, 0, 1, 0.25f);
  expect(1.0, 1, 2, 0.0f);
  expect(3.25, 1, 2, 0.75f);
  expect(4.0, 2, 2, 0.0f);
  expect(9.0, 2, 2, 0.0f);
  expect(-1.0, 0, 0, 0.0f);
  EXPECT_EQ(visibility_blend(visibility, 2, 3.0), VisibilityBlend{}) << "another clip";
  EXPECT_EQ(visibility_blend(VertexVisibility{}, kNone, 3.0), VisibilityBlend{}) << "one pose";
}

constexpr int kSize = 32;

View front_view() { return look_at({0, 0, 3}, {0, 0, 0}, 0.8, 0.05); }

/// A square of half size 1 that faces the viewer.
BuiltScene facing_square(const Material& material = matte({0.5f, 0.5f, 0.5f})) {
  BuiltScene built;
  Affine upright;
  upright.row[1] = {0, 0, -1, 0};
  upright.row[2] = {0, 1, 0, 0};
  built.add(square(1.0f), built.add_material(material), upright);
  return built;
}

/// One list for each pose: the values of the square's vertices.
VertexVisibility visibility_of(const BuiltScene& built,
                               const std::vector<std::function<float(const glm::vec3&)>>& poses) {
  VertexVisibility visibility;
  visibility.values.resize(built.scene.meshes.size());
  for (std::size_t m = 0; m < built.scene.meshes.size(); ++m) {
    visibility.values[m].resize(1);
    for (const auto& value : poses)
      for (const glm::vec3& p : built.scene.meshes[m].primitives[0].positions)
        visibility.values[m][0].push_back(value(p));
  }
  return visibility;
}

RenderOptions baked_options(Show show) {
  RenderOptions options;
  options.show = show;
  options.ao.method = OcclusionMethod::rays;
  options.lighting.tone_curve = ToneCurve::none;
  options.lighting.exposure = 0.25f;
  return options;
}

FloatPicture draw(const BuiltScene& built, const RenderOptions& options, const VertexVisibility* visibility,
                  const VisibilityBlend& blend = {}) {
  return render_float(built, kSize, kSize, front_view(), options, {}, {}, visibility, blend);
}

class vertex_visibility : public DeviceTest {};

TEST_F(vertex_visibility, is_interpolated_over_triangles_and_between_key_poses) {
  const BuiltScene built = facing_square();
  const VertexVisibility visibility =
      visibility_of(built, {[](const glm::vec3&) { return 1.0f; }, [](const glm::vec3& p) { return 0.5f + 0.5f * p.x; },
                            [](const glm::vec3& p) { return 0.5f - 0.5f * p.z; }});
  for (const VisibilityBlend& blend :
       {VisibilityBlend{1, 2, 0.0f}, VisibilityBlend{1, 2, 0.25f}, VisibilityBlend{2, 2, 0.0f}}) {
    const FloatPicture picture = draw(built, baked_options(Show::ao), &visibility, blend);
    for (int y = 8; y < 24; ++y)
      for (int x = 8; x < 24; ++x) {
        const double half = 3.0 * std::tan(0.4), right = half * ((x + 0.5) * 2.0 / kSize - 1.0),
                     up = half * (1.0 - (y + 0.5) * 2.0 / kSize);
        const double first = 0.5 + 0.5 * right, second = 0.5 + 0.5 * up;  // the square's -z is up
        const double expected = blend.pose == 2 ? second : first + static_cast<double>(blend.factor) * (second - first);
        EXPECT_NEAR(picture.at(x, y).r, expected, 2e-3) << x << ' ' << y << ' ' << blend.factor;
      }
  }
}

TEST_F(vertex_visibility, scales_ambient_light_and_no_other) {
  for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::blend}) {
    Material material = matte({0.5f, 0.5f, 0.5f});
    material.alpha_mode = mode;
    material.metallic = 1.0f;  // nothing is scattered between metals, so that light is proportional to visibility
    const BuiltScene built = facing_square(material);
    const VertexVisibility none = visibility_of(built, {[](const glm::vec3&) { return 0.0f; }}),
                           half = visibility_of(built, {[](const glm::vec3&) { return 0.5f; }});
    const auto light = [&](const VertexVisibility* visibility, bool ambient, bool key) {
      RenderOptions options = baked_options(Show::color);
      if (!ambient) options.lighting.environment = nullptr;
      if (!key) options.lighting.key = glm::vec3(0.0f);
      return static_cast<double>(linear_from_srgb(draw(built, options, visibility).at(16, 16).g));
    };
    const double ambient = light(nullptr, true, false), key = light(nullptr, false, true);
    ASSERT_GT(ambient, 0.01);
    ASSERT_GT(key, 0.01);
    EXPECT_NEAR(light(&half, true, false), 0.5 * ambient, 2e-3 * ambient);
    EXPECT_NEAR(light(&none, true, false), 0.0, 1e-4);
    EXPECT_NEAR(light(&none, true, true), key, 2e-3 * key);
    EXPECT_EQ(light(&none, false, true), key) << "without ambient light there is nothing to scale";
  }
}

TEST_F(vertex_visibility, counts_for_its_own_method_alone_and_not_when_it_is_switched_off) {
  const BuiltScene built = facing_square();
  const VertexVisibility none = visibility_of(built, {[](const glm::vec3&) { return 0.0f; }});
  RenderOptions options = baked_options(Show::color);
  options.ao.on = false;
  const FloatPicture off = draw(built, options, &none), plain = draw(built, options, nullptr);
  EXPECT_EQ(off.at(16, 16), plain.at(16, 16));
  options.ao.on = true;
  options.ao.method = OcclusionMethod::gtao;
  EXPECT_EQ(draw(built, options, &none).at(16, 16), draw(built, options, nullptr).at(16, 16));
  options.ao.method = OcclusionMethod::rays;
  EXPECT_EQ(draw(built, options, nullptr).at(16, 16), plain.at(16, 16)) << "vertices without visibility are open";
  EXPECT_LT(draw(built, options, &none).at(16, 16).g, plain.at(16, 16).g);
}

TEST_F(vertex_visibility, takes_no_pass) {
  const BuiltScene built = facing_square();
  const VertexVisibility half = visibility_of(built, {[](const glm::vec3&) { return 0.5f; }});
  Headless headless(*test_device(), built.scene, kSize, kSize, {}, &half);
  headless.render(built.frame(), front_view(), baked_options(Show::color));
  for (const PassStage& stage : headless.report().passes) {
    const bool runs = stage.pass == Pass::opaque || stage.pass == Pass::tonemap;
    EXPECT_EQ(stage.runs, runs) << name_of(stage.pass);
    EXPECT_EQ(stage.count > 0, runs) << name_of(stage.pass);
  }
}

TEST_F(vertex_visibility, is_silent_under_validation_in_every_mode_and_size) {
  BuiltScene built = box_and_sphere_on_floor();
  Material glass = matte({0.5f, 0.8f, 1.0f});
  glass.alpha_mode = AlphaMode::blend;
  built.add(showcase::sphere({0, 1.5f, 0}, 0.5f), built.add_material(glass));
  Material mask = matte({1, 1, 1});
  mask.alpha_mode = AlphaMode::mask;
  built.add(square(0.5f), built.add_material(mask), translation({0, 2, 0}));
  const auto dark = [](const glm::vec3& p) { return 0.5f + 0.4f * std::sin(p.x); };
  const VertexVisibility visibility = visibility_of(built, {dark, dark, dark});
  for (const Show show : {Show::color, Show::ao, Show::normals, Show::depth})
    for (const bool smooth : {true, false})
      for (const auto& [width, height] : {std::pair{57, 33}, {1, 1}, {300, 1}}) {
        RenderOptions options = baked_options(show);
        options.smooth_edges = smooth;
        options.ground = ground_for({{-1, 0, -1}, {1, 1, 1}});
        options.ground.look = GroundLook::shadows;
        options.shadows = {true, {{-1, 0, -1}, {1, 1, 1}}};
        const FloatPicture picture = render_float(built, width, height, look_at({3, 3, 5}, {0, 0, 0}, 0.8, 0.05),
                                                  options, {}, {}, &visibility, {1, 2, 0.5f});
        EXPECT_TRUE(std::isfinite(picture.at(0, 0).r));
      }
  if (!test_device()->validation_active()) GTEST_SKIP() << "silent, but the validation layer is not installed";
}

}  // namespace
}  // namespace sinew::viewer
