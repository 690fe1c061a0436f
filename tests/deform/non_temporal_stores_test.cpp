// SPDX-License-Identifier: MIT
/// Large outputs, and others on demand, are written past the caches where they are aligned; that must not show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <span>

#include "runtime/deform/skin_linear.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kStoredCounts[] = {1, 2, 4};
constexpr std::uint32_t kGroupSize = 70'001;  // three groups of positions, normals and tangents: just over 8 MiB
constexpr std::size_t kLine = 64, kSlack = 16 * sizeof(glm::vec4);

/// Room for `count` values of which number `first` begins a cache line, and `off` bytes more.
template <class T>
class PlacedValues {
 public:
  PlacedValues(std::size_t count, std::size_t first, std::size_t off)
      : bytes_(new (std::align_val_t(kLine)) std::byte[count * sizeof(T) + 2 * kSlack]),
        values_(reinterpret_cast<T*>(bytes_.get() + kSlack - first * sizeof(T) % kLine + off), count) {
    std::memset(bytes_.get(), kUntouched, count * sizeof(T) + 2 * kSlack);
  }
  std::span<T> span() const { return values_; }
  bool is_untouched_around() const {
    const auto* begin = reinterpret_cast<const unsigned char*>(values_.data());
    const auto untouched = [](unsigned char byte) { return byte == kUntouched; };
    return std::all_of(begin - kLine, begin, untouched) &&
           std::all_of(begin + values_.size_bytes(), begin + values_.size_bytes() + kLine, untouched);
  }

 private:
  static constexpr unsigned char kUntouched = 0xa5;
  struct Free {
    void operator()(std::byte* bytes) const { ::operator delete[](bytes, std::align_val_t(kLine)); }
  };
  std::unique_ptr<std::byte[], Free> bytes_;
  std::span<T> values_;
};

struct PlacedOutput {
  PlacedValues<glm::vec3> positions, normals;
  PlacedValues<glm::vec4> tangents;

  /// Vertex `first` begins a cache line in all three, unless normals are `off` bytes behind.
  PlacedOutput(const test::SkinnedVertices& s, std::size_t first, std::size_t off, std::int64_t target,
               bool past_caches = false)
      : positions(s.positions.size(), first, 0),
        normals(s.positions.size(), first, off),
        tangents(s.positions.size(), first, 0) {
    const test::OnlyTarget only(target);
    EXPECT_EQ(run(SkinLinearJob{.influences = &s.influences,
                                .palette = s.palette,
                                .vertices = s.in(),
                                .out = {positions.span(), normals.span(), tangents.span()},
                                .past_caches = past_caches}),
              ErrorCode::ok);
  }
  bool same_bits(const PlacedOutput& other) const {
    const auto same = [](const auto& a, const auto& b) {
      return std::memcmp(a.span().data(), b.span().data(), a.span().size_bytes()) == 0;
    };
    return same(positions, other.positions) && same(normals, other.normals) && same(tangents, other.tangents);
  }
  bool is_untouched_around() const {
    return positions.is_untouched_around() && normals.is_untouched_around() && tangents.is_untouched_around();
  }
};

TEST(non_temporal_stores, has_the_bits_of_output_that_is_not_wherever_it_is_aligned) {
  test::FixedRandom random(41);
  auto s = test::random_skinned_vertices(random, kStoredCounts, kGroupSize, 24, true);
  for (glm::vec4& column : s.palette[5].column)
    column = glm::vec4(0, 0, 0, column.w);  // vertices that are done again one by one
  for (const std::int64_t target : test::simd_targets()) {
    const PlacedOutput never(s, 0, sizeof(float), target);
    for (const std::size_t first : {0, 3, 13}) {
      const PlacedOutput streamed(s, first, 0, target);
      EXPECT_TRUE(streamed.same_bits(never)) << test::simd_name(target) << ' ' << first;
      EXPECT_TRUE(streamed.is_untouched_around()) << test::simd_name(target) << ' ' << first;
    }
  }
}

TEST(non_temporal_stores, on_demand_have_the_bits_of_others_for_any_number_of_vertices) {
  test::FixedRandom random(42);
  for (const std::uint32_t group_size : {1, 7, 16, 33, 100}) {
    auto s = test::random_skinned_vertices(random, kStoredCounts, group_size, 24, true);
    for (const bool same_joints : {false, true}) {
      if (same_joints) std::fill(s.influences.joints.begin(), s.influences.joints.end(), std::uint16_t{2});
      for (const bool tangents : {true, false}) {
        if (!tangents) s.tangents.clear();  // those are stored past the caches without lanes
        for (const std::int64_t target : test::simd_targets())
          for (const std::size_t first : {0, 3, 13}) {
            const PlacedOutput cached(s, first, 0, target), streamed(s, first, 0, target, true);
            EXPECT_TRUE(streamed.same_bits(cached)) << test::simd_name(target) << ' ' << group_size << ' ' << first;
            EXPECT_TRUE(streamed.is_untouched_around()) << test::simd_name(target) << ' ' << group_size << ' ' << first;
          }
      }
    }
  }
}

}  // namespace
}  // namespace sinew
