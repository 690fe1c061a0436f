// SPDX-License-Identifier: MIT
#include "tests/study/study_scenes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

struct Ball {
  glm::vec3 centre;
  float radius;
  std::size_t triangles;
};

/// The balls of a scene, as they are drawn; tests that they are round.
std::vector<Ball> balls_of(const Scene& scene) {
  std::vector<Ball> balls;
  for (const MeshInstance& instance : scene.instances) {
    const Primitive& p = scene.meshes[instance.mesh].primitives.at(0);
    const glm::vec3 centre = 0.5f * (p.bounds.lower + p.bounds.upper);
    const float radius = 0.5f * (p.bounds.upper.y - p.bounds.lower.y);
    for (const glm::vec3& v : p.positions) EXPECT_NEAR(glm::distance(v, centre), radius, 1e-5f);
    balls.push_back({centre, radius, p.indices.size() / 3});
  }
  return balls;
}

TEST(study_scenes, balls_lie_side_by_side_in_rows_as_wide_as_the_picture) {
  for (const auto& [draws, wide] : {std::tuple(1u, 2u), {19u, 6u}, {36u, 8u}, {115u, 15u}}) {
    const std::vector<Ball> balls = balls_of(sheet_of_balls(draws));
    ASSERT_EQ(balls.size(), draws);
    for (std::uint32_t i = 0; i < draws; ++i) {
      EXPECT_NEAR(glm::distance(balls[i].centre, glm::vec3(i % wide, i / wide, 0)), 0.0f, 1e-5f) << i;
      EXPECT_NEAR(balls[i].radius, 0.48f, 1e-5f) << "they do not touch";
      EXPECT_EQ(balls[i].triangles, 256u);
    }
  }
}

TEST(study_scenes, each_ball_has_a_material_of_its_own) {
  const Scene scene = sheet_of_balls(7);
  ASSERT_EQ(scene.materials.size(), 7u);
  std::set<std::string> names;
  for (std::size_t i = 0; i < 7; ++i) {
    const Material& material = scene.materials[scene.meshes[scene.instances[i].mesh].primitives[0].material];
    names.insert(std::string(material.name));
    EXPECT_EQ(material.roughness, 0.6f);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(material.base_color[c], 0.5 + 0.3 * std::sin(static_cast<double>(i) + 2.0 * c), 1e-6)
          << i << ' ' << c;
  }
  EXPECT_EQ(names.size(), 7u);
}

TEST(study_scenes, the_doll_is_a_person_of_19_parts) {
  std::vector<Ball> balls = balls_of(doll_of_balls());
  ASSERT_EQ(balls.size(), 19u);
  using Part = std::tuple<float, float, float>;  // x, y, radius, on the left or in the middle
  std::vector<Part> parts, right;
  for (const Ball& ball : balls) {
    EXPECT_NEAR(ball.centre.z, 0.0f, 1e-5f);
    EXPECT_EQ(ball.triangles, 2304u);
    const auto rounded = [](float v) { return std::round(100.0f * v); };
    (ball.centre.x < -0.01f ? right : parts)
        .emplace_back(std::abs(rounded(ball.centre.x)), rounded(ball.centre.y), rounded(ball.radius));
  }
  EXPECT_THAT(parts, testing::UnorderedElementsAre(Part{0, 162, 13}, Part{0, 146, 6}, Part{0, 128, 16},
                                                   Part{0, 112, 16}, Part{0, 96, 16},  // head to hips
                                                   Part{10, 78, 11}, Part{10, 60, 11}, Part{10, 40, 11},
                                                   Part{10, 18, 11},                                        // a leg
                                                   Part{24, 134, 9}, Part{42, 134, 9}, Part{60, 134, 9}));  // an arm
  parts.erase(std::remove_if(parts.begin(), parts.end(), [](const Part& p) { return std::get<0>(p) == 0.0f; }),
              parts.end());
  EXPECT_THAT(right, testing::UnorderedElementsAreArray(parts)) << "the other side";
}

TEST(study_scenes, one_ball_is_fine) {
  const std::vector<Ball> balls = balls_of(fine_ball());
  ASSERT_EQ(balls.size(), 1u);
  EXPECT_EQ(balls[0].triangles, 100352u);
  EXPECT_NEAR(balls[0].radius, 1.0f, 1e-5f);
  EXPECT_NEAR(glm::length(balls[0].centre), 0.0f, 1e-5f);
}

TEST(study_scenes, the_plane_shows_a_pattern_every_two_metres) {
  for (const bool turned : {false, true}) {
    const Scene scene = patterned_plane(turned);
    const Primitive& p = scene.meshes.at(0).primitives.at(0);
    double area = 0.0;
    for (std::size_t i = 0; i < p.indices.size(); i += 3) {
      const glm::vec3 a = p.positions[p.indices[i]];
      area +=
          0.5 * static_cast<double>(glm::cross(p.positions[p.indices[i + 1]] - a, p.positions[p.indices[i + 2]] - a).y);
    }
    EXPECT_EQ(area, 6400.0) << "all of it, with the upper side outside";
    EXPECT_EQ(p.bounds.lower, glm::vec3(-40, 0, -40));
    EXPECT_EQ(p.bounds.upper, glm::vec3(40, 0, 40));
    EXPECT_THAT(p.normals, testing::Each(glm::vec3(0, 1, 0)));
    for (std::size_t v = 0; v < 4; ++v)
      EXPECT_EQ(p.texcoords.at(0)[v], 0.5f * glm::vec2(p.positions[v].x + 40.0f, p.positions[v].z + 40.0f));
    const Material& material = scene.materials.at(p.material);
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.base_color_texture.texture, 0u);
    EXPECT_FLOAT_EQ(material.base_color_texture.rotation_rad, turned ? std::numbers::pi_v<float> / 4.0f : 0.0f);
  }
}

TEST(study_scenes, the_pattern_has_squares_of_three_sizes_and_colours_that_tell_the_dark_ones_apart) {
  const Scene scene = patterned_plane(false);
  const Image& image = scene.images.at(0);
  ASSERT_EQ(image.width, 256u);
  ASSERT_EQ(image.height, 256u);
  ASSERT_EQ(image.rgba.size(), 4u * 256 * 256);
  using Color = std::array<int, 4>;
  const auto at = [&](std::size_t x, std::size_t y) {
    const auto* texel = image.rgba.data() + 4 * (256 * y + x);
    return Color{texel[0], texel[1], texel[2], texel[3]};
  };
  constexpr Color kLight{235, 230, 210, 255};
  std::size_t light = 0;
  for (std::size_t y = 0; y < 256; ++y)
    for (std::size_t x = 0; x < 256; ++x) {
      const bool is_light = at(x, y) == kLight;
      light += is_light;
      const Color dark{20, static_cast<int>(x) / 4, static_cast<int>(y) / 2, 255};
      EXPECT_TRUE(is_light || at(x, y) == dark) << x << ' ' << y;
    }
  EXPECT_EQ(light, 128u * 256);
  /// Whether squares of that side begin in the corner, the first light and the next ones dark.
  const auto squares = [&](std::size_t x, std::size_t y, std::size_t side) {
    const std::size_t last = side - 1;
    return at(x, y) == kLight && at(x + last, y + last) == kLight && at(x + side, y + last) != kLight &&
           at(x + last, y + side) != kLight && at(x + side, y + side) == kLight;
  };
  EXPECT_TRUE(squares(0, 0, 4) && squares(120, 120, 4));
  EXPECT_TRUE(squares(0, 128, 16) && squares(96, 224, 16));
  EXPECT_TRUE(squares(128, 0, 32) && squares(192, 192, 32));
}

TEST(study_scenes, tangents_lie_along_the_circles_of_latitude) {
  for (const bool mapped : {false, true}) {
    const Scene scene = sphere_with_tangents(mapped);
    const Primitive& p = scene.meshes.at(0).primitives.at(0);
    EXPECT_EQ(p.indices.size() / 3, 2304u);
    EXPECT_EQ(p.bounds.upper.y - p.bounds.lower.y, 2.0f);
    ASSERT_EQ(p.tangents.size(), p.positions.size());
    for (std::size_t v = 0; v < p.positions.size(); ++v) {
      const glm::vec3 t(p.tangents[v]), n = p.normals[v];
      EXPECT_NEAR(glm::length(t), 1.0f, 1e-5f);
      EXPECT_NEAR(glm::dot(t, n), 0.0f, 1e-3f);
      EXPECT_NEAR(t.y, 0.0f, 1e-6f);
      EXPECT_EQ(p.tangents[v].w, 1.0f);
      EXPECT_TRUE(std::abs(n.y) > 0.99f || t.x * n.z > t.z * n.x) << "counter-clockwise from above";
    }
    EXPECT_THAT(p.texcoords.at(0), testing::AllOf(testing::SizeIs(p.positions.size()), testing::Each(glm::vec2(0.5f))));
    const Material& material = scene.materials.at(p.material);
    EXPECT_EQ(material.roughness, 0.6f);
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.normal_texture.texture, mapped ? 0u : kNone);
    ASSERT_EQ(scene.images.size(), mapped ? 1u : 0u);
    for (const Image& lean : scene.images) EXPECT_THAT(lean.rgba, testing::ElementsAre(150, 110, 240, 255));
  }
}

TEST(study_scenes, stand_still_in_a_frame_and_have_an_extent) {
  const Still still(fine_ball());
  EXPECT_EQ(still.buffer.result().instances.size(), 1u);
  EXPECT_NEAR(still.bounds.reached.upper.y, 1.0f, 1e-5f);
}

}  // namespace
}  // namespace sinew::viewer
