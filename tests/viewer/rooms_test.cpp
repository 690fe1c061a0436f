// SPDX-License-Identifier: MIT
// The built-in rooms: how bright they are from each side, and that they are the same everywhere.
#include "viewer/light/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "runtime/base/same_bits.h"
#include "viewer/light/outdoor_skies.h"
#include "viewer/light/studio_sky.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {
namespace {

constexpr Room kAll[] = {Room::studio, Room::sunset, Room::overcast};

/// Irradiance / pi of a surface with normal n: the plain sum over the sky, and the key light.
glm::dvec3 arriving(Room room, const glm::dvec3& n) {
  const CubeMap sky = sky_of(room);
  glm::dvec3 sum(0.0);
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < sky.size; ++y)
      for (std::uint32_t x = 0; x < sky.size; ++x)
        sum += glm::dvec3(sky.texels[at++]) *
               (std::max(0.0, glm::dot(n, glm::dvec3(texel_direction(face, x, y, sky.size)))) *
                static_cast<double>(texel_solid_angle(x, y, sky.size)));
  const KeyLight key = *room_environment(room)->key;
  sum += glm::dvec3(key.irradiance) * std::max(0.0, glm::dot(n, glm::normalize(glm::dvec3(key.to_light))));
  return sum / std::numbers::pi;
}

glm::dvec3 mean_light(Room room) {
  glm::dvec3 sum(0.0);
  for (const double side : {-1.0, 1.0})
    sum += arriving(room, {side, 0, 0}) + arriving(room, {0, side, 0}) + arriving(room, {0, 0, side});
  return sum / 6.0;
}

/// Values read off public pictures of white and grey boxes in the neutral room, within 15 %.
TEST(rooms, studio_lights_each_side_as_the_neutral_room_of_other_viewers) {
  const std::pair<glm::dvec3, double> sides[] = {{{1, 0, 0}, 0.52},  {{-1, 0, 0}, 0.48}, {{0, 1, 0}, 1.05},
                                                 {{0, -1, 0}, 0.25}, {{0, 0, 1}, 0.50},  {{0, 0, -1}, 1.30}};
  for (const auto& [n, expected] : sides)
    EXPECT_NEAR(arriving(Room::studio, n).g, expected, 0.15 * expected) << n.x << ' ' << n.y << ' ' << n.z;
}

TEST(rooms, studio_is_neutral) {
  const glm::dvec3 light = mean_light(Room::studio);
  EXPECT_NEAR(light.r / light.g, 1.0, 0.02);
  EXPECT_NEAR(light.b / light.g, 1.0, 0.02);
}

TEST(rooms, all_are_about_as_bright_so_that_changing_them_needs_no_other_exposure) {
  const double studio = mean_light(Room::studio).g;
  for (const Room room : kAll) EXPECT_NEAR(mean_light(room).g, studio, 0.3 * studio) << name_of(room);
}

TEST(rooms, have_something_bright_and_something_dark_for_metals_to_mirror) {
  for (const Room room : kAll) {
    float least = 1e9f, most = 0.0f;
    for (const glm::vec3& texel : sky_of(room).texels) {
      least = std::min(least, texel.g);
      most = std::max(most, texel.g);
    }
    EXPECT_GT(most, 4.0f * least) << name_of(room);
    EXPECT_GT(least, 0.05f) << name_of(room);
    EXPECT_LT(most, 8.0f) << name_of(room) << ": sharper lights than the filter can take";
  }
}

TEST(rooms, sunset_is_warm_where_the_sun_is_and_blue_above) {
  const glm::vec3 sun = sunset_radiance(glm::normalize(kSun.to_light)), above = sunset_radiance({0, 1, 0});
  EXPECT_GT(sun.r, 2.0f * sun.b);
  EXPECT_GT(above.b, above.r);
  EXPECT_GT(kSun.to_light.y, 0.0f);
}

TEST(rooms, overcast_is_three_times_as_bright_above_as_at_the_horizon) {
  float rim = 0.0f;
  for (int i = 0; i < 64; ++i) {
    const float turn = 0.0981747704f * static_cast<float>(i);
    rim += overcast_radiance(glm::normalize(glm::vec3(std::cos(turn), 0.07f, std::sin(turn)))).g / 64.0f;
  }
  EXPECT_NEAR(overcast_radiance({0, 1, 0}).g / rim, 3.0f / 1.14f, 0.5f);
  EXPECT_EQ(room_environment(Room::overcast)->key->irradiance, glm::vec3(0.0f));
}

TEST(rooms, have_names_are_made_once_and_have_the_same_bits_each_time) {
  for (const Room room : kAll) {
    EXPECT_EQ(room_named(name_of(room)), room);
    EXPECT_EQ(room_environment(room), room_environment(room));
    const CubeMap sky = sky_of(room), again = sky_of(room);
    EXPECT_TRUE(same_bits(std::span(sky.texels), std::span(again.texels)));
  }
  EXPECT_FALSE(room_named("plain"));
  EXPECT_EQ(studio_environment(), room_environment(Room::studio));
}

TEST(rooms, bring_their_key_light) {
  Lighting lighting;
  const glm::vec3 before = lighting.key;
  lighting.use(plain_environment());
  EXPECT_EQ(lighting.key, before);
  lighting.use(room_environment(Room::sunset));
  EXPECT_EQ(lighting.key, kSun.irradiance);
  EXPECT_EQ(lighting.to_key, kSun.to_light);
  lighting.use(nullptr);
  EXPECT_FALSE(lighting.ambient());
}

}  // namespace
}  // namespace sinew::viewer
