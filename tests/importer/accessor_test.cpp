// SPDX-License-Identifier: MIT
#include "importer/read/accessor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "importer/issue_log.h"
#include "importer/read/check_accessors.h"

namespace sinew::test {
namespace {

using gltf::ComponentType;
using gltf::ElementType;
using testing::ElementsAre;

/// A document with one accessor on one buffer view.
class Fixture {
 public:
  template <class T>
  Fixture(const std::vector<T>& values, ComponentType component, ElementType type, std::uint64_t count) {
    const auto bytes = std::as_bytes(std::span(values));
    add_view({bytes.begin(), bytes.end()});
    document.accessors.push_back({});
    accessor().buffer_view = 0;
    accessor().component_type = component;
    accessor().type = type;
    accessor().count = count;
  }

  std::uint32_t add_view(std::vector<std::byte> bytes) {
    document.storage.push_back(std::move(bytes));
    document.buffer_views.push_back({});
    document.buffer_views.back().bytes = document.storage.back();
    document.buffer_views.back().byte_length = document.storage.back().size();
    return static_cast<std::uint32_t>(document.buffer_views.size() - 1);
  }

  /// The first rule that the checks report, or "ok".
  std::string checked() {
    IssueLog log;
    check_accessor_layout(document, log);
    if (log.ok()) check_accessors(document, log);
    if (!log.ok()) return log.take_error("x").issue.rule;
    const auto warnings = log.take_warnings();
    return warnings.empty() ? "ok" : warnings[0].rule;
  }

  gltf::Accessor& accessor() { return document.accessors[0]; }
  gltf::Document document;
};

TEST(accessor, reads_every_component_type) {
  EXPECT_THAT(
      read_floats(Fixture(std::vector<std::int8_t>{-128, 127}, ComponentType::i8, ElementType::scalar, 2).document, 0),
      ElementsAre(-128, 127));
  EXPECT_THAT(
      read_floats(Fixture(std::vector<std::uint8_t>{0, 255}, ComponentType::u8, ElementType::scalar, 2).document, 0),
      ElementsAre(0, 255));
  EXPECT_THAT(
      read_floats(Fixture(std::vector<std::int16_t>{-32768, 7}, ComponentType::i16, ElementType::scalar, 2).document,
                  0),
      ElementsAre(-32768, 7));
  EXPECT_THAT(
      read_floats(Fixture(std::vector<std::uint16_t>{1, 65535}, ComponentType::u16, ElementType::scalar, 2).document,
                  0),
      ElementsAre(1, 65535));
  EXPECT_THAT(
      read_unsigned(
          Fixture(std::vector<std::uint32_t>{1, 0xfffffffe}, ComponentType::u32, ElementType::scalar, 2).document, 0),
      ElementsAre(1, 0xfffffffe));
  EXPECT_THAT(
      read_floats(Fixture(std::vector<float>{0.1f, -2.5f}, ComponentType::f32, ElementType::scalar, 2).document, 0),
      ElementsAre(0.1f, -2.5f));
  EXPECT_THAT(
      read_unsigned(Fixture(std::vector<std::uint8_t>{3, 200}, ComponentType::u8, ElementType::scalar, 2).document, 0),
      ElementsAre(3, 200));
}

TEST(accessor, G17_normalised_integers_reach_both_ends_exactly) {
  Fixture i8(std::vector<std::int8_t>{-128, -127, 0, 127}, ComponentType::i8, ElementType::scalar, 4);
  Fixture u8(std::vector<std::uint8_t>{0, 51, 255}, ComponentType::u8, ElementType::scalar, 3);
  Fixture i16(std::vector<std::int16_t>{-32768, -32767, 32767}, ComponentType::i16, ElementType::scalar, 3);
  Fixture u16(std::vector<std::uint16_t>{0, 65535}, ComponentType::u16, ElementType::scalar, 2);
  for (Fixture* fixture : {&i8, &u8, &i16, &u16}) fixture->accessor().normalized = true;
  EXPECT_THAT(read_floats(i8.document, 0), ElementsAre(-1.0f, -1.0f, 0.0f, 1.0f));
  EXPECT_THAT(read_floats(u8.document, 0), ElementsAre(0.0f, 0.2f, 1.0f));
  EXPECT_THAT(read_floats(i16.document, 0), ElementsAre(-1.0f, -1.0f, 1.0f));
  EXPECT_THAT(read_floats(u16.document, 0), ElementsAre(0.0f, 1.0f));
}

TEST(accessor, G25_stride_skips_and_the_last_element_needs_no_padding) {
  Fixture fixture(std::vector<float>{1, 2, 9, 3, 4, 9, 5, 6}, ComponentType::f32, ElementType::vec2, 3);
  fixture.document.buffer_views[0].byte_stride = 12;
  EXPECT_EQ(fixture.checked(), "ok");
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(1, 2, 3, 4, 5, 6));
  fixture.accessor().byte_offset = 4;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
}

TEST(accessor, G25_a_stride_below_the_element_is_refused) {
  Fixture fixture(std::vector<float>(12), ComponentType::f32, ElementType::vec3, 2);
  fixture.document.buffer_views[0].byte_stride = 8;
  EXPECT_EQ(fixture.checked(), "accessor-stride");
}

TEST(accessor, G26_G67_offsets_and_counts_do_not_wrap) {
  Fixture fixture(std::vector<float>(4), ComponentType::f32, ElementType::scalar, 4);
  EXPECT_EQ(fixture.checked(), "ok");
  fixture.accessor().byte_offset = (std::uint64_t{1} << 53) - 1;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
  fixture.accessor().byte_offset = 4;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
  fixture.accessor().byte_offset = 0;
  fixture.accessor().count = (std::uint64_t{1} << 53) - 1;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
  fixture.accessor().count = std::uint64_t{1} << 32;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
  fixture.accessor().count = 5;
  EXPECT_EQ(fixture.checked(), "accessor-fit");
}

TEST(accessor, G27_unaligned_floats_are_copied_with_a_warning) {
  const float value = 1.25f;
  std::vector<std::byte> bytes(5);
  std::memcpy(bytes.data() + 1, &value, 4);
  Fixture fixture(bytes, ComponentType::f32, ElementType::scalar, 1);
  fixture.accessor().byte_offset = 1;
  EXPECT_EQ(fixture.checked(), "accessor-alignment");
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(1.25f));
}

TEST(accessor, G27_columns_of_small_matrices_are_padded) {
  Fixture mat2(std::vector<std::uint8_t>{1, 2, 0, 0, 3, 4, 0, 0}, ComponentType::u8, ElementType::mat2, 1);
  Fixture mat3(std::vector<std::uint16_t>{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0}, ComponentType::u16, ElementType::mat3,
               1);
  Fixture bytes(std::vector<std::uint8_t>{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0}, ComponentType::u8, ElementType::mat3, 1);
  EXPECT_THAT(read_floats(mat2.document, 0), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(read_floats(mat3.document, 0), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(read_floats(bytes.document, 0), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_EQ(element_layout(ElementType::mat3, ComponentType::u8).element_bytes, 12u);
  EXPECT_EQ(element_layout(ElementType::mat4, ComponentType::f32).element_bytes, 64u);
}

template <class Index, class T>
void make_sparse(Fixture& fixture, ComponentType index_type, const std::vector<Index>& indices,
                 const std::vector<T>& values) {
  const auto copy = [](const auto& list) {
    const auto bytes = std::as_bytes(std::span(list));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  };
  auto& sparse = fixture.accessor().sparse;
  sparse.count = indices.size();
  sparse.index_type = index_type;
  sparse.indices_view = fixture.add_view(copy(indices));
  sparse.values_view = fixture.add_view(copy(values));
}

void make_sparse(Fixture& fixture, std::vector<std::uint16_t> indices, std::vector<float> values) {
  make_sparse(fixture, ComponentType::u16, indices, values);
}

TEST(accessor, G24_sparse_replaces_elements_of_its_base) {
  Fixture fixture(std::vector<float>{1, 2, 3, 4, 5, 6}, ComponentType::f32, ElementType::vec2, 3);
  make_sparse(fixture, {0, 2}, {10, 20, 50, 60});
  EXPECT_EQ(fixture.checked(), "ok");
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(10, 20, 3, 4, 50, 60));
}

TEST(accessor, G24_sparse_indices_and_values_may_begin_anywhere_in_their_views) {
  Fixture fixture(std::vector<float>{1, 2, 3, 4, 5, 6}, ComponentType::f32, ElementType::vec2, 3);
  make_sparse(fixture, {1, 1, 0, 2}, {7, 10, 20, 50, 60});
  fixture.accessor().sparse.count = 2;
  fixture.accessor().sparse.indices_offset = 4;
  fixture.accessor().sparse.values_offset = 4;
  EXPECT_EQ(fixture.checked(), "ok");
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(10, 20, 3, 4, 50, 60));
}

/// Reads three elements of two numbers with `padding` bytes between elements. A sparse accessor replaces the first and
/// the last element.
template <class T, class Index>
void expect_replaced(ComponentType type, ComponentType index_type, std::size_t padding, bool normalized) {
  SCOPED_TRACE(testing::Message() << int(type) << ' ' << int(index_type) << ' ' << padding << ' ' << normalized);
  std::vector<T> base;
  for (int element = 0; element < 3; ++element) {
    base.insert(base.end(), {static_cast<T>(2 * element + 1), static_cast<T>(2 * element + 2)});
    base.insert(base.end(), padding, T(0));
  }
  Fixture sparse(base, type, ElementType::vec2, 3),
      dense(std::vector<T>{51, 102, 3, 4, 100, 7}, type, ElementType::vec2, 3);
  if (padding > 0) sparse.document.buffer_views[0].byte_stride = static_cast<std::uint32_t>((2 + padding) * sizeof(T));
  make_sparse(sparse, index_type, std::vector<Index>{0, 2}, std::vector<T>{51, 102, 100, 7});
  for (Fixture* fixture : {&sparse, &dense}) fixture->accessor().normalized = normalized;
  EXPECT_EQ(read_floats(sparse.document, 0), read_floats(dense.document, 0));
  EXPECT_EQ(read_stored(sparse.document, 0), read_stored(dense.document, 0));
  EXPECT_EQ(read_vectors<glm::vec2>(sparse.document, 0), read_vectors<glm::vec2>(dense.document, 0));
  EXPECT_EQ(read_replacements<glm::vec2>(sparse.document, 0).values.at(1),
            read_vectors<glm::vec2>(dense.document, 0)[2]);
}

template <class T>
void expect_replaced(ComponentType type) {
  for (const std::size_t padding : {0u, 1u, 2u})
    for (const bool normalized : {false, true}) {
      if (normalized && sizeof(T) == 4) continue;
      expect_replaced<T, std::uint8_t>(type, ComponentType::u8, padding, normalized);
      expect_replaced<T, std::uint16_t>(type, ComponentType::u16, padding, normalized);
      expect_replaced<T, std::uint32_t>(type, ComponentType::u32, padding, normalized);
    }
}

TEST(accessor, G24_sparse_elements_of_every_type_and_stride_are_those_of_a_dense_accessor) {
  expect_replaced<std::int8_t>(ComponentType::i8);
  expect_replaced<std::uint8_t>(ComponentType::u8);
  expect_replaced<std::int16_t>(ComponentType::i16);
  expect_replaced<std::uint16_t>(ComponentType::u16);
  expect_replaced<std::uint32_t>(ComponentType::u32);
  expect_replaced<float>(ComponentType::f32);
}

TEST(accessor, G28_no_view_is_zeros_before_sparse) {
  Fixture fixture(std::vector<float>{}, ComponentType::f32, ElementType::scalar, 3);
  fixture.accessor().buffer_view = kNone;
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(0, 0, 0));
  make_sparse(fixture, {1}, {7});
  EXPECT_EQ(fixture.checked(), "ok");
  EXPECT_THAT(read_floats(fixture.document, 0), ElementsAre(0, 7, 0));
}

TEST(accessor, G24_sparse_parts_must_fit_and_stay_in_range) {
  const auto rule = [](std::vector<std::uint16_t> indices, std::vector<float> values) {
    Fixture fixture(std::vector<float>(3), ComponentType::f32, ElementType::scalar, 3);
    make_sparse(fixture, std::move(indices), std::move(values));
    return fixture.checked();
  };
  EXPECT_EQ(rule({3}, {1}), "accessor-sparse");
  EXPECT_EQ(rule({0, 1, 2, 3}, {1, 1, 1, 1}), "accessor-sparse") << "more replacements than elements";
  EXPECT_EQ(rule({0, 1}, {1}), "accessor-fit");
  EXPECT_EQ(rule({1, 0}, {1, 2}), "accessor-sparse-order");
  EXPECT_EQ(rule({1, 1}, {1, 2}), "accessor-sparse-order");
}

TEST(accessor, an_empty_accessor_reads_as_nothing) {
  Fixture fixture(std::vector<float>{}, ComponentType::f32, ElementType::vec3, 0);
  EXPECT_EQ(fixture.checked(), "ok");
  EXPECT_TRUE(read_floats(fixture.document, 0).empty());
}

}  // namespace
}  // namespace sinew::test
