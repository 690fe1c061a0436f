// SPDX-License-Identifier: MIT
#include "runtime/deform/write_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

constexpr std::size_t kWrittenStride = 43;  // odd, so that no element is aligned
constexpr std::byte kLeftAlone{0x5a};

struct WrittenVertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;
  std::vector<std::byte> bytes;
  Aabb box;

  explicit WrittenVertices(std::size_t count) : bytes(count * kWrittenStride, kLeftAlone) {
    test::FixedRandom random(count);
    for (std::size_t v = 0; v < count; ++v) {
      positions.push_back(random.vec3(-3, 7));
      box.add(positions.back());
      normals.push_back(random.direction());
      tangents.push_back(glm::vec4(random.direction(), v % 2 ? 1.0f : -1.0f));
    }
  }
  VertexInput in() const { return {positions, normals, tangents}; }
  template <class T>
  StridedSpan<T> at(std::size_t offset) {
    return {bytes.data() + offset, positions.size(), kWrittenStride};
  }
  StridedOutput floats() { return {at<glm::vec3>(1), at<glm::vec3>(14), at<glm::vec4>(27)}; }
  QuantizedOutput integers() {
    return {at<std::array<std::uint16_t, 3>>(1), at<std::array<std::int16_t, 2>>(9),
            at<std::array<std::int16_t, 3>>(15)};
  }
};

/// The direction of an octahedral pair, by the equation of QuantizeVerticesJob.
Vec3<double> direction_of(std::int16_t x, std::int16_t y) {
  const double u = x / 32767.0, v = y / 32767.0, z = 1 - std::abs(u) - std::abs(v);
  const auto sign = [](double a) { return a < 0 ? -1.0 : 1.0; };
  if (z >= 0) return glm::normalize(Vec3<double>(u, v, z));
  return glm::normalize(Vec3<double>((1 - std::abs(v)) * sign(u), (1 - std::abs(u)) * sign(v), z));
}

double angle(const Vec3<double>& a, const Vec3<double>& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST(write_vertices, interleaves_the_bits_and_leaves_the_bytes_between) {
  WrittenVertices v(100);
  ASSERT_EQ(run(WriteVerticesJob{v.in(), v.floats()}), ErrorCode::ok);
  for (std::size_t i = 0; i < v.positions.size(); ++i) {
    EXPECT_EQ(v.floats().positions.load(i), v.positions[i]);
    EXPECT_EQ(v.floats().normals.load(i), v.normals[i]);
    EXPECT_EQ(v.floats().tangents.load(i), v.tangents[i]);
    for (const std::size_t byte : {0, 13, 26}) EXPECT_EQ(v.bytes[i * kWrittenStride + byte], kLeftAlone);
  }
}

TEST(write_vertices, positions_of_integers_agree_with_double_within_half_a_step) {
  WrittenVertices v(20'000);
  ASSERT_EQ(run(QuantizeVerticesJob{v.in(), v.box, v.integers()}), ErrorCode::ok);
  for (std::size_t i = 0; i < v.positions.size(); ++i) {
    const auto q = v.integers().positions.load(i);
    for (int c = 0; c < 3; ++c) {
      const double lower = v.box.lower[c], side = v.box.upper[c] - lower;
      ASSERT_NEAR(lower + side * q[static_cast<std::size_t>(c)] / 65535, v.positions[i][c], 0.51 / 65535 * side) << i;
    }
    EXPECT_EQ(v.bytes[i * kWrittenStride], kLeftAlone);
    for (const std::size_t byte : {7, 8, 13, 14, 21}) ASSERT_EQ(v.bytes[i * kWrittenStride + byte], kLeftAlone) << byte;
  }
}

TEST(write_vertices, octahedral_directions_are_within_seven_hundred_thousandths_of_a_radian) {
  WrittenVertices v(100'000);
  const float edges[] = {-1.0f, -0.5f, -1e-6f, 0.0f, 1e-6f, 0.5f, 1.0f};
  std::size_t at = 0;
  for (const float x : edges)
    for (const float y : edges)
      for (const float z : edges)
        if (x != 0 || y != 0 || z != 0) v.normals[at++] = 3.0f * glm::normalize(glm::vec3(x, y, z));
  ASSERT_EQ(run(QuantizeVerticesJob{v.in(), v.box, v.integers()}), ErrorCode::ok);
  double worst = 0;
  for (std::size_t i = 0; i < v.normals.size(); ++i) {
    const auto n = v.integers().normals.load(i);
    const auto t = v.integers().tangents.load(i);
    worst = std::max({worst, angle(direction_of(n[0], n[1]), Vec3<double>(v.normals[i])),
                      angle(direction_of(t[0], t[1]), Vec3<double>(glm::vec3(v.tangents[i])))});
    ASSERT_EQ(t[2], v.tangents[i].w < 0 ? -32767 : 32767);
  }
  EXPECT_LE(worst, 7e-5);
  EXPECT_GE(worst, 6e-5) << "the stated bound may be smaller";
}

TEST(write_vertices, positions_outside_of_the_box_move_to_its_sides) {
  WrittenVertices v(5);
  v.positions = {{-1, 0.5f, 2}, {1e30f, -1e30f, 0.5f}, {0, 1, 0}, {0.25f, 0.75f, 3}, {0, 0, 0}};
  v.positions[4].x = std::numeric_limits<float>::quiet_NaN();
  const Aabb box{glm::vec3(0, 0, 3), glm::vec3(1, 1, 3)};
  ASSERT_EQ(run(QuantizeVerticesJob{v.in(), box, v.integers()}), ErrorCode::ok);
  const auto at = [&](std::size_t i) { return v.integers().positions.load(i); };
  EXPECT_EQ(at(0), (std::array<std::uint16_t, 3>{0, 32768, 0}));
  EXPECT_EQ(at(1), (std::array<std::uint16_t, 3>{65535, 0, 0}));
  EXPECT_EQ(at(2), (std::array<std::uint16_t, 3>{0, 65535, 0}));
  EXPECT_EQ(at(3), (std::array<std::uint16_t, 3>{16384, 49151, 0}));
  EXPECT_EQ(at(4)[0], 0);
}

TEST(write_vertices, a_direction_without_length_becomes_z) {
  WrittenVertices v(1);
  v.normals = {{0, 0, 0}};
  ASSERT_EQ(run(QuantizeVerticesJob{v.in(), v.box, v.integers()}), ErrorCode::ok);
  EXPECT_EQ(v.integers().normals.load(0), (std::array<std::int16_t, 2>{0, 0}));
}

TEST(write_vertices, attributes_that_are_not_wanted_are_not_written) {
  WrittenVertices v(3);
  StridedOutput out = v.floats();
  out.positions = {};
  VertexInput in = v.in();
  in.tangents = {};
  ASSERT_EQ(run(WriteVerticesJob{in, out}), ErrorCode::ok);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t byte = 0; byte < kWrittenStride; ++byte) {
      const bool is_of_normal = byte >= 14 && byte < 26;
      EXPECT_TRUE(is_of_normal || v.bytes[i * kWrittenStride + byte] == kLeftAlone) << byte;
    }
}

TEST(write_vertices, rejects_what_does_not_fit) {
  WrittenVertices v(3);
  WriteVerticesJob floats{v.in(), v.floats()};
  --floats.out.positions.count;
  EXPECT_EQ(check(floats), ErrorCode::size_mismatch);
  floats.out = v.floats();
  floats.out.normals.stride = 11;
  EXPECT_EQ(check(floats), ErrorCode::size_mismatch);
  floats.out = v.floats();
  floats.out.tangents.first = nullptr;
  EXPECT_EQ(check(floats), ErrorCode::size_mismatch);
  QuantizeVerticesJob integers{v.in(), v.box, v.integers()};
  EXPECT_EQ(check(integers), ErrorCode::ok);
  integers.out.tangents.stride = 5;
  EXPECT_EQ(check(integers), ErrorCode::size_mismatch);
  integers.out = v.integers();
  for (const Aabb& bad : {Aabb{}, Aabb{glm::vec3(0), glm::vec3(1, std::numeric_limits<float>::infinity(), 1)},
                          Aabb{glm::vec3(std::numeric_limits<float>::quiet_NaN()), glm::vec3(1)}}) {
    integers.box = bad;
    EXPECT_EQ(check(integers), ErrorCode::not_finite);
  }
  integers.out.positions = {};
  EXPECT_EQ(check(integers), ErrorCode::ok) << "the box is of positions only";
}

}  // namespace
}  // namespace sinew
