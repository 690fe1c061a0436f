// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_strided.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "tests/support/fixed_random.h"
#include "tests/support/shared_joints.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kStridedCounts[] = {1, 2, 4, 5};
constexpr std::size_t kStride = 57;  // odd, so that no element is aligned
constexpr std::byte kUntouched{0x5a};

/// Vertices of a buffer: position at byte 1, normal at 17, tangent at 33, and bytes of somebody else between them.
struct VertexBytes {
  std::vector<std::byte> bytes;
  std::size_t count;

  explicit VertexBytes(std::size_t vertices) : bytes(vertices * kStride, kUntouched), count(vertices) {}

  template <class T>
  StridedSpan<T> at(std::size_t offset) {
    return {bytes.data() + offset, count, kStride};
  }
  StridedOutput out() { return {at<glm::vec3>(1), at<glm::vec3>(17), at<glm::vec4>(33)}; }
  StridedInput in() { return {at<const glm::vec3>(1), at<const glm::vec3>(17), at<const glm::vec4>(33)}; }
};

struct StridedFixture {
  test::SkinnedVertices s;
  std::vector<glm::vec3> centers;
  std::vector<RigidStretch> split;
  bool any_stretch = false;
  VertexBytes from, to;

  explicit StridedFixture(std::uint32_t group_size) : s(make(group_size)), from(s.positions.size()), to(from.count) {
    for (std::size_t v = 0; v < from.count; ++v) {
      centers.push_back(0.5f * s.positions[v]);
      from.out().positions.store(v, s.positions[v]);
      from.out().normals.store(v, s.normals[v]);
      from.out().tangents.store(v, s.tangents[v]);
    }
    split.resize(s.palette.size());
    run_unchecked(SplitPaletteJob{s.palette, split, &any_stretch});
  }
  static test::SkinnedVertices make(std::uint32_t group_size) {
    test::FixedRandom random(group_size);
    auto s = test::random_skinned_vertices(random, kStridedCounts, group_size, 24, true);
    test::share_joints(random, s, 3);
    return s;
  }
  SkinLinearJob linear() const {
    return {.influences = &s.influences, .palette = s.palette, .vertices = {}, .out = {}};
  }
  SkinDualQuaternionJob dual_quaternion() const {
    return {.influences = &s.influences, .split = split, .any_stretch = any_stretch, .vertices = {}, .out = {}};
  }
  SkinCenterOfRotationJob centered() const {
    return {.influences = &s.influences,
            .palette = s.palette,
            .split = split,
            .any_stretch = any_stretch,
            .centers = centers,
            .vertices = {},
            .out = {}};
  }

  /// Runs the job on packed vertices and on both buffers.
  template <class Job>
  void expect_same_bits(Job job) {
    const StridedSkinJob<Job> strided{job, from.in(), to.out()};
    ASSERT_EQ(run(strided), ErrorCode::ok);
    job.vertices = s.in();
    job.out = s.out();
    ASSERT_EQ(run(job), ErrorCode::ok);
    VertexBytes expected(from.count);
    for (std::size_t v = 0; v < from.count; ++v) {
      expected.out().positions.store(v, s.out_positions[v]);
      expected.out().normals.store(v, s.out_normals[v]);
      expected.out().tangents.store(v, s.out_tangents[v]);
    }
    EXPECT_TRUE(to.bytes == expected.bytes);
  }
};

TEST(skin_strided, has_the_bits_of_packed_vertices_and_leaves_the_bytes_between_them) {
  for (const std::uint32_t size : {1u, 30u, 255u, 256u, 257u, 600u})
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      SCOPED_TRACE(testing::Message() << size << ' ' << test::simd_name(target));
      StridedFixture linear(size), cofactor(size), rigid(size), centered(size);
      linear.expect_same_bits(linear.linear());
      SkinLinearJob by_cofactors = cofactor.linear();
      by_cofactors.normal_rule = NormalRule::cofactor;
      cofactor.expect_same_bits(by_cofactors);
      rigid.expect_same_bits(rigid.dual_quaternion());
      centered.expect_same_bits(centered.centered());
    }
}

TEST(skin_strided, packed_arrays_may_be_given_too) {
  StridedFixture f(300);
  const auto whole = [](const auto& array) {
    using V = typename std::remove_reference_t<decltype(array)>::value_type;
    return StridedSpan<const V>{reinterpret_cast<const std::byte*>(array.data()), array.size()};
  };
  const StridedInput packed{whole(f.s.positions), whole(f.s.normals), whole(f.s.tangents)};
  ASSERT_EQ(run(StridedSkinJob<SkinLinearJob>{f.linear(), packed, f.to.out()}), ErrorCode::ok);
  const std::vector<std::byte> of_packed = f.to.bytes;
  ASSERT_EQ(run(StridedSkinJob<SkinLinearJob>{f.linear(), f.from.in(), f.to.out()}), ErrorCode::ok);
  EXPECT_TRUE(of_packed == f.to.bytes);
}

TEST(skin_strided, attributes_that_are_not_wanted_are_not_written) {
  StridedFixture f(40);
  StridedSkinJob<SkinLinearJob> job{f.linear(), f.from.in(), f.to.out()};
  job.out.normals = {};
  job.vertices.tangents = {};
  ASSERT_EQ(run(job), ErrorCode::ok);
  for (std::size_t v = 0; v < f.to.count; ++v)
    for (std::size_t byte = 13; byte < kStride; ++byte) ASSERT_EQ(f.to.bytes[v * kStride + byte], kUntouched) << v;
}

TEST(skin_strided, rejects_what_it_cannot_do) {
  StridedFixture f(9);
  const StridedSkinJob<SkinCenterOfRotationJob> sound{f.centered(), f.from.in(), f.to.out()};
  EXPECT_EQ(check(sound), ErrorCode::ok);
  auto job = sound;
  job.skin.vertices = f.s.in();
  EXPECT_EQ(check(job), ErrorCode::unsupported);
  job = sound;
  job.skin.out = f.s.out();
  EXPECT_EQ(check(job), ErrorCode::unsupported);
  const VertexTiles tiles;
  job = sound;
  job.skin.tiles = &tiles;
  EXPECT_EQ(check(job), ErrorCode::unsupported);
  job = sound;
  job.out.normals.stride = sizeof(glm::vec3) - 1;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  job.vertices.tangents.first = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  --job.out.positions.count;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  --job.vertices.normals.count;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  job.skin.centers = job.skin.centers.first(f.centers.size() - 1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  job.skin.influences.groups = job.skin.influences.groups.first(3);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = sound;
  job.skin.palette = job.skin.palette.first(1);
  job.skin.split = job.skin.split.first(1);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew
