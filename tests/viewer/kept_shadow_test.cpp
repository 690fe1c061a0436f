// SPDX-License-Identifier: MIT
// Shadow maps that stay while nothing that they depend on changes.
#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/passes/shadow_key.h"

namespace sinew::viewer {
namespace {

class kept_shadows : public DeviceTest {};

RenderOptions with_shadows() {
  RenderOptions options;
  options.lighting.to_key = {0.7f, 0.8f, 0.35f};
  options.shadows = {true, {glm::vec3(-4.0f), glm::vec3(4.0f)}};
  return options;
}

View from_the_right() { return look_at({2.5, 3.2, 4.0}, {0.0, 0.3, 0.0}, 0.8, 0.05); }
View from_the_left() { return look_at({-3.0, 4.0, 2.0}, {0.0, 0.2, 0.0}, 0.8, 0.05); }

bool draws_shadows(const Headless& pictures) {
  return pictures.report().passes[static_cast<std::size_t>(Pass::shadow)].runs;
}

TEST_F(kept_shadows, are_drawn_again_only_if_a_light_or_what_casts_them_has_moved) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options = with_shadows();
  Headless pictures(*test_device(), built.scene, 40, 30);
  const auto draw = [&](const View& view, const FrameResult& frame) {
    const Picture picture = pictures.render(frame, view, options);
    Headless fresh(*test_device(), built.scene, 40, 30);
    EXPECT_EQ(picture.rgba, fresh.render(frame, view, options).rgba);
    return draws_shadows(pictures);
  };
  FrameResult frame = built.frame();
  EXPECT_TRUE(draw(from_the_right(), frame));
  EXPECT_FALSE(draw(from_the_right(), frame));
  EXPECT_FALSE(draw(from_the_left(), frame)) << "only the camera has moved";
  std::vector<InstanceResult> instances(frame.instances.begin(), frame.instances.end());
  instances.back().world_from_mesh.row[0].w += 0.2f;
  frame.instances = instances;
  EXPECT_TRUE(draw(from_the_left(), frame));
  options.lighting.to_key.x += 0.3f;
  EXPECT_TRUE(draw(from_the_left(), frame));
  options.shadows.on = false;
  EXPECT_FALSE(draw(from_the_left(), frame));
  options.shadows.on = true;
  EXPECT_TRUE(draw(from_the_left(), frame)) << "the image was freed in between";
  EXPECT_FALSE(draw(from_the_right(), frame));
}

TEST_F(kept_shadows, of_a_light_that_follows_the_camera_are_drawn_again) {
  const BuiltScene built = box_and_sphere_on_floor();
  RenderOptions options = with_shadows();
  options.lighting.key_follows_camera = true;
  Headless pictures(*test_device(), built.scene, 40, 30);
  pictures.render(built.frame(), from_the_right(), options);
  pictures.render(built.frame(), from_the_left(), options);
  EXPECT_TRUE(draws_shadows(pictures));
}

Caster deformed_caster() {
  Caster caster;
  caster.scene = 3;
  caster.source = 7;
  caster.since = 5;
  caster.draw.index_count = 12;
  return caster;
}

TEST(shadow_key, changes_with_each_thing_that_maps_depend_on) {
  const std::vector<ShadowView> views(1);
  ShadowKey key;
  std::vector<Caster> casters = {deformed_caster()};
  const auto holds = [&] { return key.holds(views, casters, {64, 48}); };
  EXPECT_FALSE(holds());
  EXPECT_TRUE(holds());
  const auto changed = [&](auto change) {
    change(casters[0]);
    const bool drawn = !holds();
    EXPECT_TRUE(holds());
    return drawn;
  };
  EXPECT_TRUE(changed([](Caster& c) { c.since = 6; }));
  EXPECT_TRUE(changed([](Caster& c) { c.source = 8; }));
  EXPECT_TRUE(changed([](Caster& c) { c.scene = 4; }));
  EXPECT_TRUE(changed([](Caster& c) { c.variant = 1; }));
  EXPECT_TRUE(changed([](Caster& c) { c.world_from_mesh.row[2].w = 1e-9; }));
  EXPECT_TRUE(changed([](Caster& c) { c.draw.index_count = 9; }));
  EXPECT_FALSE(key.holds(views, casters, {64, 49})) << "images are made again";
  key.forget();
  EXPECT_FALSE(key.holds(views, casters, {64, 49}));
  casters[0].since = 0;
  EXPECT_FALSE(holds());
  EXPECT_FALSE(holds()) << "vertices of unknown age";
}

}  // namespace
}  // namespace sinew::viewer
