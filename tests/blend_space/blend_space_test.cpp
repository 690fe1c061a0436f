// SPDX-License-Identifier: MIT
#include "runtime/blend_space/blend_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/reference/blend_space.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using Kind = BlendSpaceKind;
constexpr Kind kPlaneKinds[] = {Kind::cartesian, Kind::directional, Kind::radial};

/// A space with its numbers.
class Space {
 public:
  Space(Kind kind, std::vector<glm::vec2> points, float angle_factor = 1.0f)
      : points_(std::move(points)), numbers_(blend_space_numbers(kind, points_.size())) {
    EXPECT_EQ(prepare_blend_space(kind, points_, angle_factor, numbers_), ErrorCode::ok);
    space_ = {kind, points_, numbers_, angle_factor};
  }
  Space(const Space&) = delete;

  std::vector<float> weights(float x, float y) const {
    std::vector<float> out(points_.size());
    blend_space_weights(space_, x, y, out);
    return out;
  }
  const BlendSpace& view() const { return space_; }

 private:
  std::vector<glm::vec2> points_;
  std::vector<double> numbers_;
  BlendSpace space_;
};

std::vector<glm::vec2> ring(int count) {
  std::vector<glm::vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    points.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  }
  return points;
}

struct Case {
  const char* name;
  std::vector<glm::vec2> points;
  double change[3];  ///< most change of a weight in a step of 0.05: cartesian, directional, radial
};

std::vector<Case> cases() {
  return {{"six points", {{0, 0}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {0, 2}}, {0.09, 0.13, 0.08}},
          {"cross", {{0, 1}, {0, -1}, {1, 0}, {-1, 0}}, {0.08, 0.29, 0.05}},
          {"ring of 8", ring(8), {0.11, 0.29, 0.09}},
          {"duplicates", {{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}}, {0.13, 0.54, 0.06}},
          {"collinear", {{0, 0}, {0, 0.5f}, {0, 1}, {0, 2}}, {0.11, 0.22, 0.11}},
          {"one point", {{0.5f, 0.25f}}, {0.0, 0.0, 0.0}}};
}

/// Calls `see(x, y)` for 81 x 81 places, 0.05 apart.
template <class See>
void at_all_places(const See& see) {
  for (int row = -40; row <= 40; ++row)
    for (int column = -40; column <= 40; ++column)
      see(0.05f * static_cast<float>(column), 0.05f * static_cast<float>(row));
}

TEST(blend_space, weights_are_finite_and_sum_to_1_at_6561_places) {
  for (const Case& c : cases())
    for (const Kind kind : {Kind::line, Kind::cartesian, Kind::directional, Kind::radial}) {
      const Space space(kind, c.points);
      at_all_places([&](float x, float y) {
        double sum = 0.0;
        for (const float w : space.weights(x, y)) {
          EXPECT_TRUE(std::isfinite(w) && w >= 0.0f) << c.name;
          sum += static_cast<double>(w);
        }
        EXPECT_NEAR(sum, 1.0, 1e-6) << c.name << ' ' << x << ' ' << y;
      });
    }
}

TEST(blend_space, a_point_has_weight_1_at_its_place_and_shares_it_with_others_there) {
  for (const Case& c : cases())
    for (const Kind kind : kPlaneKinds) {
      const Space space(kind, c.points);
      for (const glm::vec2& at : c.points) {
        const auto sharers = static_cast<float>(std::count(c.points.begin(), c.points.end(), at));
        const std::vector<float> weights = space.weights(at.x, at.y);
        for (std::size_t i = 0; i < weights.size(); ++i)
          EXPECT_NEAR(weights[i], c.points[i] == at ? 1.0f / sharers : 0.0f, 1e-6f) << c.name << ' ' << int(kind);
      }
    }
}

TEST(blend_space, weights_change_by_a_bounded_step) {
  for (const Case& c : cases())
    for (std::size_t k = 0; k < 3; ++k) {
      const Space space(kPlaneKinds[k], c.points);
      double most = 0.0;
      const auto compare = [&](const std::vector<float>& a, const std::vector<float>& b) {
        for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(double{a[i]} - double{b[i]}));
      };
      at_all_places([&](float x, float y) {
        const std::vector<float> here = space.weights(x, y);
        compare(here, space.weights(x + 0.05f, y));
        compare(here, space.weights(x, y + 0.05f));
      });
      RecordProperty(std::string(c.name) + std::to_string(k), std::to_string(most));
      EXPECT_LE(most, c.change[k]) << c.name << ' ' << k;
    }
}

TEST(blend_space, weights_agree_with_their_equations) {
  FixedRandom random(3);
  for (int i = 0; i < 300; ++i) {
    std::vector<glm::vec2> points;
    const std::uint32_t count = 1 + random.below(9);
    if (random.below(2) == 0) points.emplace_back(0.0f, 0.0f);
    while (points.size() < count) {
      const double x = random.in(-2, 2), y = random.in(-2, 2);
      points.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
    const std::vector<glm::dvec2> exact(points.begin(), points.end());
    const float factor = random.below(2) == 0 ? 1.0f : 2.0f;
    const Space cartesian(Kind::cartesian, points), directional(Kind::directional, points, factor),
        radial(Kind::radial, points);
    for (int p = 0; p < 40; ++p) {
      const double px = random.in(-2.5, 2.5), py = random.in(-2.5, 2.5);
      const auto x = static_cast<float>(px), y = static_cast<float>(py);
      const glm::dvec2 at(x, y);
      const auto compare = [&](const Space& space, const std::vector<double>& truth) {
        const std::vector<float> weights = space.weights(x, y);
        for (std::size_t w = 0; w < weights.size(); ++w)
          ASSERT_NEAR(weights[w], truth[w], 1e-6) << int(space.view().kind) << ' ' << i;
      };
      compare(cartesian, reference::cartesian_weights(exact, at));
      compare(directional, reference::directional_weights(exact, at, double{factor}));
      compare(radial, reference::radial_weights(exact, at));
    }
  }
}

TEST(blend_space, a_line_mixes_the_points_on_both_sides) {
  const Space space(Kind::line, {{2, 0}, {0, 0}, {1, 5}, {1, -5}});
  EXPECT_EQ(space.weights(0.25f, 3), (std::vector<float>{0, 0.75f, 0.125f, 0.125f}));
  EXPECT_EQ(space.weights(1.5f, 0), (std::vector<float>{0.5f, 0, 0.25f, 0.25f}));
  EXPECT_EQ(space.weights(-9, 0), (std::vector<float>{0, 1, 0, 0}));
  EXPECT_EQ(space.weights(9, 0), (std::vector<float>{1, 0, 0, 0}));
  EXPECT_EQ(space.weights(1, 0), (std::vector<float>{0, 0, 0.5f, 0.5f}));
}

TEST(blend_space, directions_without_a_point_at_the_origin_count_alike_there) {
  for (const float weight : Space(Kind::directional, ring(8)).weights(0, 0)) EXPECT_FLOAT_EQ(weight, 0.125f);
  const Space space(Kind::directional, ring(4));
  for (const float x : {1e-6f, -1e-6f}) EXPECT_NEAR(space.weights(x, 0)[0], 0.25f, 1e-4f) << "and beside it";
}

TEST(blend_space, the_angle_factor_says_how_much_directions_count) {
  const std::vector<glm::vec2> points{{1, 0}, {0, 2}};
  const float x = 0.8f, y = 0.8f;
  EXPECT_GT(std::abs(Space(Kind::directional, points, 1.0f).weights(x, y)[0] -
                     Space(Kind::directional, points, 2.0f).weights(x, y)[0]),
            0.01f);
}

TEST(blend_space, bad_spaces_are_refused) {
  std::vector<double> numbers(blend_space_numbers(Kind::radial, 2));
  const auto code = [&](std::vector<glm::vec2> points, float factor = 1.0f) {
    return prepare_blend_space(Kind::radial, points, factor, numbers);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code({{0, 0}, {1, 0}}), ErrorCode::ok);
  EXPECT_EQ(code({}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{0, 0}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{0, 0}, {nan, 0}}), ErrorCode::not_finite);
  EXPECT_EQ(code({{0, 0}, {2e9f, 0}}), ErrorCode::too_large);
  EXPECT_EQ(code({{0, 0}, {1, 0}}, 0.0f), ErrorCode::not_a_fraction);
  EXPECT_EQ(code({{0, 0}, {1, 0}}, nan), ErrorCode::not_finite);
  std::vector<glm::vec2> many(kMostBlendPoints + 1);
  EXPECT_EQ(prepare_blend_space(Kind::line, many, 1.0f, {}), ErrorCode::size_mismatch);
}

TEST(blend_space, weights_allocate_nothing) {
  for (const Kind kind : kPlaneKinds) {
    const Space space(kind, ring(8));
    float weights[8];
    const AllocationCounter allocations;
    blend_space_weights(space.view(), 0.3f, 0.4f, weights);
    EXPECT_EQ(allocations.count(), 0u);
  }
}

}  // namespace
}  // namespace sinew::test
