// SPDX-License-Identifier: MIT
// Pictures with normals and tangent frames that are interpolated as quaternions.
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/quaternion_normal.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class quaternion_picture : public DeviceTest {};

RenderOptions quaternions(RenderOptions options) {
  options.normals = NormalInterpolation::quaternion;
  return options;
}

/// A wall with a normal map of leaning normals.
BuiltScene relief_wall(const Primitive& primitive, const Affine& world_from_wall = {}, bool mirrored = false) {
  BuiltScene built;
  Material material = plain();
  material.double_sided = true;
  material.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
  return lit_wall(built, material, primitive, world_from_wall, mirrored);
}

/// A wall whose tangents lie at this angle, one for each corner.
Primitive wall_with_tangents(const std::array<double, 4>& degrees, float w) {
  Primitive p = wall();
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = degrees[i] * std::numbers::pi / 180.0;
    p.tangents[i] = {static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)), 0.0f, w};
  }
  return p;
}

TEST_F(quaternion_picture, a_flat_wall_has_the_frames_of_the_reference_on_both_sides_and_mirrored) {
  Affine turned, mirror;  // about y by 180 degrees
  turned.row[0].x = turned.row[2].z = -1.0f;
  mirror.row[0].x = -1.0f;
  for (const double angle : {0.0, 60.0, 135.0, 180.0, 181.0, 250.0, 315.0})
    for (const float w : {1.0f, -1.0f}) {
      SCOPED_TRACE(std::to_string(angle) + ", " + std::to_string(w));
      const Primitive p = wall_with_tangents({angle, angle, angle, angle}, w);
      expect_reference_picture(relief_wall(p), view_of_wall(), quaternions(every_light()));
      expect_reference_picture(relief_wall(p, turned), view_of_wall(), quaternions(every_light()));
      expect_reference_picture(relief_wall(p, mirror, true), view_of_wall(), quaternions(every_light()));
    }
}

TEST_F(quaternion_picture, without_tangents_or_with_useless_ones_the_map_does_as_without_quaternions) {
  Primitive p = wall();
  p.tangents.clear();
  expect_reference_picture(relief_wall(p), view_of_wall(), quaternions(every_light()));
  Primitive useless = wall();
  for (glm::vec4& t : useless.tangents) t = {0.0f, 0.0f, 1.0f, 1.0f};
  const auto with = render_float(relief_wall(useless), 24, 20, view_of_wall(), quaternions(every_light())).pixels,
             without = render_float(relief_wall(useless), 24, 20, view_of_wall(), every_light()).pixels;
  for (std::size_t i = 0; i < with.size(); ++i) EXPECT_LT(glm::length(with[i] - without[i]), 1e-3f);
}

/// Normals of the picture, 0 where there are none.
std::vector<glm::dvec3> normals_of(const BuiltScene& built, const View& view, NormalInterpolation normals) {
  RenderOptions options = every_light();
  options.show = Show::normals;
  options.normals = normals;
  options.transparent_background = true;
  std::vector<glm::dvec3> out;
  for (const glm::vec4& pixel : render_float(built, 32, 32, view, options).pixels)
    out.push_back(pixel.a > 0.0f ? glm::dvec3(pixel) * 2.0 - 1.0 : glm::dvec3(0.0));
  return out;
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

struct Apart {
  double most = 0.0, least = 180.0;
  int pixels = 0;
};

Apart apart(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
  Apart out;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == glm::dvec3(0.0) || b[i] == glm::dvec3(0.0)) continue;
    ++out.pixels;
    out.most = std::max(out.most, degrees_between(a[i], b[i]));
    out.least = std::min(out.least, degrees_between(a[i], b[i]));
  }
  return out;
}

/// Straight at a square of 2 x 2 m in the plane z = 0, which fills the picture.
View straight_view() {
  View view = look_at({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, 0.8, 0.05);
  view.half_height_m = 1.0;
  view.far_m = 9.0;
  return view;
}

/// One triangle that covers the square, with a normal of its own at each corner.
BuiltScene bent_triangle(const std::array<glm::vec3, 3>& normals) {
  Primitive p;
  p.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
  p.normals.assign(normals.begin(), normals.end());
  p.indices = {0, 1, 2};
  BuiltScene built;
  built.add(p, built.add_material(plain()));
  return built;
}

TEST_F(quaternion_picture, normals_between_three_corners_are_those_of_hast) {
  const std::array<glm::vec3, 3> corners = {glm::normalize(glm::vec3(0.9f, 0.1f, 0.15f)),
                                            glm::normalize(glm::vec3(-0.8f, 0.5f, 0.3f)),
                                            glm::normalize(glm::vec3(0.1f, -0.9f, -0.1f))};
  const BuiltScene built = bent_triangle(corners);
  std::vector<glm::dvec3> expected;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const double b = (x + 0.5) / 64.0, c = (31.5 - y) / 64.0;  // shares of the second and the third corner
      const std::array<double, 3> share = {1.0 - b - c, b, c};
      glm::dvec3 h(0.0);
      for (std::size_t i = 0; i < 3; ++i) h += share[i] * reference::half_way_from_normal(glm::dvec3(corners[i]));
      expected.push_back(2.0 * h.z / glm::dot(h, h) * h - glm::dvec3(0.0, 0.0, 1.0));
    }
  const auto drawn = normals_of(built, straight_view(), NormalInterpolation::quaternion);
  const Apart off = apart(drawn, expected);
  EXPECT_EQ(off.pixels, 32 * 32);
  EXPECT_LT(off.most, 0.06);  // stored as half floats
  EXPECT_GT(apart(normals_of(built, straight_view(), NormalInterpolation::interpolated), expected).most, 3.0);
}

TEST_F(quaternion_picture, N35_a_sphere_has_the_same_normals_as_interpolated_outside_and_inside) {
  BuiltScene built;
  Material material = plain();
  material.double_sided = true;
  built.add(showcase::sphere({0, 0, 0}, 0.9f, 24, 12), built.add_material(material));
  const View outside = look_at({0.3, 0.8, 2.2}, {0.0, 0.0, 0.0}, 0.9, 0.05),
             inside = look_at({0.1, 0.2, 0.3}, {0.3, 0.1, -1.0}, 1.4, 0.01);
  for (const View& view : {outside, inside}) {
    const Apart off = apart(normals_of(built, view, NormalInterpolation::quaternion),
                            normals_of(built, view, NormalInterpolation::interpolated));
    EXPECT_GT(off.pixels, 300);
    EXPECT_LT(off.most, 0.6);  // 15 degrees from vertex to vertex
  }
}

TEST_F(quaternion_picture, N35_frames_keep_to_one_sign_within_a_triangle) {
  Affine turned;
  turned.row[0].x = turned.row[2].z = -1.0f;
  for (const Affine& place : {Affine{}, turned})
    for (double first = -180.0; first < 180.0; first += 20.0) {
      const BuiltScene built =
          relief_wall(wall_with_tangents({first, first + 25.0, first - 20.0, first + 10.0}, 1.0f), place);
      const Apart off = apart(normals_of(built, view_of_wall(), NormalInterpolation::quaternion),
                              normals_of(built, view_of_wall(), NormalInterpolation::interpolated));
      EXPECT_GT(off.pixels, 300);
      EXPECT_LT(off.most, 0.5) << first;
    }
}

TEST_F(quaternion_picture, meshes_without_normals_and_flat_ones_are_as_before) {
  Primitive bare = wall(), zero = wall(), flat = showcase::sphere({0, 0, 0.2f}, 0.45f, 8, 5);
  bare.normals.clear();
  bare.tangents.clear();
  zero.normals.assign(4, glm::vec3(0.0f));
  zero.tangents.clear();
  flat.flat_normals = true;
  for (const Primitive& p : {bare, zero, flat}) {
    const auto pixels = [&](const RenderOptions& options) {
      return render_float(lit_wall({}, plain(), p), 24, 20, view_of_wall(), options).pixels;
    };
    EXPECT_EQ(pixels(quaternions(every_light())), pixels(every_light()));
  }
}

}  // namespace
}  // namespace sinew::viewer
