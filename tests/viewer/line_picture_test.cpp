// SPDX-License-Identifier: MIT
// Overlay lines, compared with a double-precision reference: pixel coverage and depth cue.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

constexpr int kSize = 48;

class lines : public DeviceTest {};

/// Two metres from the origin; half the picture is half the distance wide.
View front_view() { return look_at({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, 2.0 * std::atan(0.5), 0.05); }

glm::dvec2 pixel_of(const glm::dvec3& p) {
  return 0.5 * kSize * glm::dvec2(1.0 + p.x / (0.5 * (2.0 - p.z)), 1.0 - p.y / (0.5 * (2.0 - p.z)));
}

/// Expected value of a pixel near a white line on black, except at its ends.
/// eq   clamp(1.25 - pixels from the line, 0, 1), halved linearly from the nearest to the farthest distance, times 3/4
///      where something is in front of it
struct Line {
  glm::vec3 from, to;

  double share(double x, double y, const DepthRange& range, double surface_m) const {
    const glm::dvec2 a = pixel_of(from), b = pixel_of(to), along = glm::normalize(b - a), off = glm::dvec2(x, y) - a;
    const double part = glm::dot(off, along) / glm::length(b - a);
    if (part < 0.0 || part > 1.0) return 0.0;
    const double near_m = 2.0 - static_cast<double>(from.z), far_m = 2.0 - static_cast<double>(to.z);
    const double distance = 1.0 / ((1.0 - part) / near_m + part / far_m);
    const double away =
        (distance - static_cast<double>(range.nearest_m)) / static_cast<double>(range.farthest_m - range.nearest_m);
    const double cue = (1.0 - 0.5 * std::clamp(away, 0.0, 1.0)) * (surface_m < distance ? 0.75 : 1.0);
    return cue * std::clamp(1.25 - std::abs(along.x * off.y - along.y * off.x), 0.0, 1.0);
  }

  /// The ends are cut between pixels.
  bool near_end(double x, double y) const {
    return std::min(glm::length(glm::dvec2(x, y) - pixel_of(from)), glm::length(glm::dvec2(x, y) - pixel_of(to))) < 2.0;
  }
};

RenderOptions options_of(bool occlusion, bool smooth) {
  RenderOptions options;
  options.background = glm::vec3(0.0f);
  options.depth_range = {1.2f, 2.8f};
  options.ao.on = occlusion;
  options.smooth_edges = smooth;
  return options;
}

/// A black wall before the right half of the picture, 1.4 m away.
BuiltScene wall_on_the_right() {
  BuiltScene built;
  Material black = matte({0, 0, 0});
  black.unlit = true;
  Primitive p;
  p.positions = {{0, -2, 0.6f}, {4, -2, 0.6f}, {4, 2, 0.6f}, {0, 2, 0.6f}};
  p.normals.assign(4, {0, 0, 1});
  p.indices = {0, 1, 2, 0, 2, 3};
  built.add(p, built.add_material(black));
  return built;
}

TEST_F(lines, cover_pixels_by_their_distance_and_are_fainter_far_away_and_behind_surfaces) {
  const BuiltScene built = wall_on_the_right();
  for (const Line& line :
       {Line{{-0.5f, -0.3f, 0.9f}, {0.7f, 0.6f, -0.7f}}, Line{{0.6f, -0.7f, -0.6f}, {-0.6f, 0.2f, 0.3f}},
        Line{{0.2f, 0.4f, 0.0f}, {0.21f, -0.8f, 0.0f}}, Line{{-0.9f, 0.11f, 0.0f}, {0.9f, 0.11f, 0.0f}}})
    for (const bool occlusion : {false, true})
      for (const bool smooth : {false, true}) {
        const RenderOptions options = options_of(occlusion, smooth);
        const std::array vertices = {LineVertex{line.from}, LineVertex{line.to}};
        FrameInputs extras;
        extras.lines = vertices;
        const FloatPicture drawn = render_float(built, kSize, kSize, front_view(), options, extras);
        int covered = 0;
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x) {
            if (line.near_end(x + 0.5, y + 0.5) || std::abs(x - kSize / 2) < 2) continue;  // or where the wall ends
            const double expected = line.share(x + 0.5, y + 0.5, options.depth_range, x >= kSize / 2 ? 1.4 : 1e9);
            EXPECT_NEAR(static_cast<double>(drawn.at(x, y).r), expected, 0.004) << x << ' ' << y;
            covered += expected > 0.1;
          }
        EXPECT_GT(covered, 15);
      }
}

TEST_F(lines, end_at_the_near_plane_and_have_the_colour_of_their_first_vertex) {
  const BuiltScene nothing;
  const Line through{{0.1f, 0.05f, 3.0f}, {-0.4f, -0.3f, 0.0f}}, behind{{0.1f, 0.0f, 3.0f}, {0.2f, 0.1f, 2.5f}};
  const std::array vertices = {LineVertex{through.from, 0xff0000ffu}, LineVertex{through.to, 0xff00ff00u},
                               LineVertex{behind.from}, LineVertex{behind.to}};
  FrameInputs extras;
  extras.lines = vertices;
  const FloatPicture drawn = render_float(nothing, kSize, kSize, front_view(), options_of(false, false), extras);
  // Where the line passes the near plane it leaves the picture; the part in front goes on to its end.
  const float part = (3.0f - 1.95f) / 3.0f;
  const Line front{through.from + part * (through.to - through.from), through.to};
  int covered = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      EXPECT_EQ(drawn.at(x, y).g, 0.0f);
      if (front.near_end(x + 0.5, y + 0.5)) continue;
      const double expected = front.share(x + 0.5, y + 0.5, options_of(false, false).depth_range, 1e9);
      EXPECT_NEAR(static_cast<double>(drawn.at(x, y).r), expected, 0.004) << x << ' ' << y;
      covered += expected > 0.1;
    }
  EXPECT_GT(covered, 10);
}

}  // namespace
}  // namespace sinew::viewer
