// SPDX-License-Identifier: MIT
// Exposure that follows the picture by itself where light would clip the model.
#include "viewer/app/adaptive_exposure.h"

#include "tests/viewer/headless_run_fixture.h"

namespace sinew::viewer {
namespace {

class adaptive_exposure : public HeadlessRunTest {};

/// A grey box under a lamp of this many candela, one metre above it.
LoadedScene under_a_lamp(float candela) {
  showcase::SceneBuilder builder;
  Material grey;
  grey.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  grey.metallic = 0.0f;
  builder.add_prop("box", showcase::box({0, 0, 0}, glm::vec3(0.5f)), builder.add_material(grey));
  const std::uint32_t lamp = builder.add_joint("lamp", kNone, {{1.0f, 1.5f, 1.0f}, {1, 0, 0, 0}, {1, 1, 1}});
  LoadedScene loaded;
  loaded.name = "lamp.glb";
  loaded.scene = builder.finish();
  Light light;
  light.kind = Light::Kind::point;
  light.intensity = candela;
  light.joint = lamp;
  loaded.scene.lights.push_back(light);
  return loaded;
}

TEST_F(adaptive_exposure, follows_the_picture_under_a_strong_lamp_and_says_so) {
  Options options = small_picture();
  EXPECT_EQ(adapt_exposure(*test_device(), options, under_a_lamp(3.0f), kNone), "");
  const std::string why = adapt_exposure(*test_device(), options, under_a_lamp(5000.0f), kNone);
  EXPECT_NE(why.find("% of the model: exposure follows the picture"), std::string::npos) << why;
  Options automatic = options;
  automatic.auto_exposure = true;
  EXPECT_EQ(written(options, under_a_lamp(5000.0f), kNone), written(automatic, under_a_lamp(5000.0f), kNone));
}

TEST_F(adaptive_exposure, leaves_the_exposure_that_the_user_gives) {
  Options options = small_picture();
  options.exposure_is_given = true;
  EXPECT_EQ(adapt_exposure(*test_device(), options, under_a_lamp(5000.0f), kNone), "");
}

TEST_F(adaptive_exposure, is_measured_only_where_light_may_be_strong) {
  LoadedScene dark = under_a_lamp(1.0f);
  dark.scene.lights.clear();
  Options options = small_picture();
  EXPECT_FALSE(may_clip(options, dark.scene));
  for (const char* room : {"studio", "overcast", "plain", "none"}) {
    options.environment = room;
    EXPECT_FALSE(may_clip(options, dark.scene)) << room;
  }
  options.environment = "noon.hdr";
  EXPECT_TRUE(may_clip(options, dark.scene));
  options.show = Show::normals;
  EXPECT_FALSE(may_clip(options, dark.scene)) << "normals have no exposure";
  Options bright = small_picture();
  bright.environment_intensity = 2.0f;
  EXPECT_TRUE(may_clip(bright, dark.scene));
  dark.scene.materials[0].emissive_strength = 9.0f;
  EXPECT_TRUE(may_clip(small_picture(), dark.scene));
}

TEST_F(adaptive_exposure, counts_opaque_pixels_with_a_channel_at_its_end) {
  EXPECT_EQ(clipped_share({1, 1, {255, 255, 255, 0}}), 0.0);
  EXPECT_EQ(clipped_share({2, 1, {255, 10, 10, 255, 250, 250, 250, 255}}), 0.5);
  EXPECT_EQ(why_exposure_follows(0.2, 0.0), "");
  EXPECT_EQ(why_exposure_follows(0.8, 0.5), "") << "colours that no exposure changes";
  EXPECT_NE(why_exposure_follows(0.8, 0.1), "");
}

}  // namespace
}  // namespace sinew::viewer
