// SPDX-License-Identifier: MIT
#include "importer/decode/decode_meshopt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>
#include <cstring>

#include "importer/read/accessor.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using gltf::Json;
using testing::HasSubstr;
using testing::SizeIs;

/// A document with one compressed view: buffer 0 holds the stream, buffer 1 is a placeholder.
gltf::Document compressed(const std::vector<unsigned char>& stream, std::size_t count, std::size_t stride,
                          const char* mode, const char* filter = nullptr,
                          const char* name = "EXT_meshopt_compression") {
  gltf::Document document;
  std::vector<std::byte> bytes(stream.size());
  std::memcpy(bytes.data(), stream.data(), stream.size());
  document.storage.push_back(bytes);
  document.buffers.resize(2);
  document.buffers[0].bytes = document.storage.back();
  document.buffers[0].byte_length = stream.size();
  document.buffers[1].placeholder = true;
  gltf::BufferView view;
  view.buffer = 1;
  view.byte_length = count * stride;
  view.extensions[name] = {{"buffer", 0},          {"byteOffset", 0}, {"byteLength", stream.size()},
                           {"byteStride", stride}, {"count", count},  {"mode", mode}};
  if (filter != nullptr) view.extensions[name]["filter"] = filter;
  document.buffer_views.push_back(view);
  return document;
}

ImportIssue meshopt_error(gltf::Document document, std::uint64_t file_bytes = 1000) {
  IssueLog log;
  DecodeBudget budget(file_bytes);
  decode_meshopt(document, budget, log);
  EXPECT_FALSE(log.ok());
  return log.ok() ? ImportIssue{} : log.take_error("").issue;
}

template <class T>
std::vector<T> decoded(gltf::Document document) {
  IssueLog log;
  DecodeBudget budget(1000);
  decode_meshopt(document, budget, log);
  EXPECT_TRUE(log.ok()) << (log.ok() ? "" : log.take_error("").issue.detail);
  const gltf::Bytes bytes = document.buffer_views[0].bytes;
  std::vector<T> out(bytes.size() / sizeof(T));
  if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

template <class T>
std::vector<unsigned char> encode_vertices(const std::vector<T>& values, std::size_t stride) {
  const std::size_t count = values.size() * sizeof(T) / stride;
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, stride));
  meshopt_encodeVertexVersion(0);
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), values.data(), count, stride));
  return out;
}

std::vector<unsigned char> encode_triangles(const std::vector<unsigned>& indices, std::size_t vertex_count) {
  std::vector<unsigned char> out(meshopt_encodeIndexBufferBound(indices.size(), vertex_count));
  meshopt_encodeIndexVersion(1);
  out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
  return out;
}

std::vector<float> some_floats(std::size_t count) {
  test::FixedRandom random(4);
  std::vector<float> out(count);
  for (float& f : out) f = static_cast<float>(random.in(-10, 10));
  return out;
}

TEST(decode_meshopt, G61_gives_the_vertices_back_under_both_names) {
  const auto values = some_floats(3 * 100);
  const auto stream = encode_vertices(values, 12);
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    EXPECT_EQ(decoded<float>(compressed(stream, 100, 12, "ATTRIBUTES", nullptr, name)), values);
}

TEST(decode_meshopt, gives_triangles_back_in_16_and_32_bits) {
  const std::vector<unsigned> indices{0, 1, 2, 2, 1, 3, 3, 1, 4};
  const auto stream = encode_triangles(indices, 5);
  EXPECT_EQ(decoded<unsigned>(compressed(stream, 9, 4, "TRIANGLES")), indices);
  EXPECT_EQ(decoded<std::uint16_t>(compressed(stream, 9, 2, "TRIANGLES")),
            std::vector<std::uint16_t>(indices.begin(), indices.end()));
}

TEST(decode_meshopt, gives_index_sequences_back) {
  const std::vector<unsigned> indices{5, 4, 3, 3, 100, 7, 0};
  std::vector<unsigned char> stream(meshopt_encodeIndexSequenceBound(indices.size(), 101));
  stream.resize(meshopt_encodeIndexSequence(stream.data(), stream.size(), indices.data(), indices.size()));
  EXPECT_EQ(decoded<unsigned>(compressed(stream, 7, 4, "INDICES")), indices);
}

TEST(decode_meshopt, undoes_the_octahedral_filter) {
  const float directions[] = {0.6f, 0.0f, 0.8f, 0.0f, 0.0f, -1.0f, 0.0f, 0.0f};  // x y z w
  std::vector<std::int8_t> coded(8);
  meshopt_encodeFilterOct(coded.data(), 2, 4, 8, directions);
  const auto out = decoded<std::int8_t>(compressed(encode_vertices(coded, 4), 2, 4, "ATTRIBUTES", "OCTAHEDRAL"));
  ASSERT_THAT(out, SizeIs(8));
  for (std::size_t i = 0; i < 8; ++i) {
    if (i % 4 != 3) {
      EXPECT_NEAR(out[i] / 127.0, directions[i], 0.02) << i;
    }
  }
}

TEST(decode_meshopt, undoes_the_quaternion_filter_up_to_sign) {
  test::FixedRandom random(6);
  std::vector<float> rotations;
  for (int i = 0; i < 20; ++i) {
    const auto q = random.rotation();
    rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
  }
  std::vector<std::int16_t> coded(80);
  meshopt_encodeFilterQuat(coded.data(), 20, 8, 16, rotations.data());
  const auto out = decoded<std::int16_t>(compressed(encode_vertices(coded, 8), 20, 8, "ATTRIBUTES", "QUATERNION"));
  for (std::size_t q = 0; q < 20; ++q) {
    double dot = 0;
    for (std::size_t k = 0; k < 4; ++k) dot += out[4 * q + k] / 32767.0 * static_cast<double>(rotations[4 * q + k]);
    EXPECT_NEAR(std::abs(dot), 1.0, 1e-4) << q;
  }
}

TEST(decode_meshopt, undoes_the_exponential_filter) {
  const auto values = some_floats(40);
  std::vector<std::uint32_t> coded(40);
#if MESHOPTIMIZER_VERSION >= 200
  meshopt_encodeFilterExp(coded.data(), 40, 4, 20, values.data(), meshopt_EncodeExpSeparate);
#else
  meshopt_encodeFilterExp(coded.data(), 40, 4, 20, values.data());
#endif
  const auto out = decoded<float>(compressed(encode_vertices(coded, 4), 40, 4, "ATTRIBUTES", "EXPONENTIAL"));
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(out[i], values[i], 10.0 / (1 << 18));
}

TEST(decode_meshopt, G61_refuses_descriptions_that_break_the_extension) {
  const auto values = some_floats(3 * 100);
  const auto stream = encode_vertices(values, 12);
  struct Case {
    const char* field;
    Json value;
    const char* rule;
    const char* place;
    const char* detail;
  };
  const Case cases[] = {
      {"count", 99, "decode-failed", "", "are not the 1200 bytes of the view"},
      {"count", 0, "json-type", "/count", ""},
      {"count", "x", "json-type", "/count", ""},
      {"mode", "MAGIC", "json-type", "/mode", ""},
      {"mode", "TRIANGLES", "decode-failed", "", "2 or 4 bytes"},
      {"filter", "SEPIA", "json-type", "/filter", ""},
      {"filter", "OCTAHEDRAL", "decode-failed", "", "4 or 8 bytes"},
      {"filter", "QUATERNION", "decode-failed", "", "8 bytes"},
      {"buffer", 7, "reference", "/buffer", "index 7 of 2"},
      {"byteOffset", 1, "buffer-view-range", "", "leave the"},
      {"byteLength", 1e15, "buffer-view-range", "", "leave the"},
      {"filter", "COLOR", "decode-failed", "", "4 or 8 bytes"},
      {"byteLength", 1, "decode-failed", "", "1 bytes cannot hold 1200"},
      {"byteLength", stream.size() - 40, "decode-failed", "", "damaged"},
  };
  for (const Case& c : cases) {
    auto document = compressed(stream, 100, 12, "ATTRIBUTES");
    document.buffer_views[0].extensions["EXT_meshopt_compression"][c.field] = c.value;
    const ImportIssue issue = meshopt_error(document);
    EXPECT_EQ(issue.rule, c.rule) << c.field << " " << c.value;
    EXPECT_EQ(issue.json_pointer, std::string("/bufferViews/0/extensions/EXT_meshopt_compression") + c.place)
        << c.field;
    EXPECT_THAT(issue.detail, HasSubstr(c.detail));
  }
}

TEST(decode_meshopt, G61_refuses_a_view_with_another_stride) {
  auto document = compressed(encode_vertices(some_floats(300), 12), 100, 12, "ATTRIBUTES");
  document.buffer_views[0].byte_stride = 16;
  EXPECT_THAT(meshopt_error(document).detail, HasSubstr("byteStride differs"));
}

/// A stream with a version number that no specification defines.
gltf::Document unknown_stream() {
  std::vector<unsigned char> stream = encode_vertices(some_floats(300), 12);
  stream[0] = 0xa2;
  return compressed(stream, 100, 12, "ATTRIBUTES", nullptr, "KHR_meshopt_compression");
}

TEST(decode_meshopt, G61_refuses_versions_that_it_does_not_know_by_their_rule) {
  const ImportIssue issue = meshopt_error(unknown_stream());
  EXPECT_EQ(issue.rule, "meshopt-version");
  EXPECT_EQ(issue.json_pointer, "/bufferViews/0/extensions/KHR_meshopt_compression");
}

TEST(decode_meshopt, G61_reads_the_uncompressed_copy_of_what_it_does_not_know) {
  gltf::Document document = unknown_stream();
  document.storage.emplace_back(1200, std::byte{7});
  document.buffer_views[0].bytes = document.storage.back();
  IssueLog log;
  DecodeBudget budget(1000);
  decode_meshopt(document, budget, log);
  EXPECT_TRUE(log.ok());
  EXPECT_EQ(document.buffer_views[0].bytes[5], std::byte{7});
  EXPECT_EQ(log.take_warnings().at(0).rule, "meshopt-fallback");
}

/// attribute_stream_test.cpp tests the codec itself.
TEST(decode_meshopt, G61_reads_version_1_and_the_color_filter) {
  const std::vector<unsigned char> version_1{0xa1, 0x55, 0x00, 0x06, 0x00, 0x08, 0x08, 0x00, 0x06, 0x00, 0x08, 0x08,
                                             0x00, 0x06, 0x00, 0x08, 0x08, 0x00, 0x06, 0x00, 0x08, 0x08, 0,    0,
                                             0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,
                                             0,    0,    0,    0,    0,    1,    2,    3,    4,    0};
  EXPECT_EQ(decoded<std::uint8_t>(compressed(version_1, 3, 4, "ATTRIBUTES", nullptr, "KHR_meshopt_compression")),
            (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  const std::vector<std::uint8_t> red{0x40, 0x7f, 0xc1, 0xff};
  EXPECT_EQ(decoded<std::uint8_t>(compressed(encode_vertices(red, 4), 1, 4, "ATTRIBUTES", "COLOR")),
            (std::vector<std::uint8_t>{254, 1, 0, 255}));
  const std::vector<std::uint16_t> wide_red{0x4000, 0x7fff, 0xc001, 0xffff};
  EXPECT_EQ(decoded<std::uint16_t>(compressed(encode_vertices(wide_red, 8), 1, 8, "ATTRIBUTES", "COLOR")),
            (std::vector<std::uint16_t>{65534, 1, 0, 65535}));
}

TEST(decode_meshopt, G61_a_stream_begins_anywhere_in_any_buffer) {
  const std::vector<float> values = some_floats(12);
  gltf::Document document = compressed(encode_vertices(values, 12), 4, 12, "ATTRIBUTES");
  std::vector<std::byte> longer(7, std::byte{0xa0});
  const gltf::Bytes stream = document.buffers[0].bytes;
  longer.insert(longer.end(), stream.begin(), stream.end());
  longer.resize(longer.size() + 5);
  document.storage.push_back(longer);
  document.buffers.resize(3);
  document.buffers[2].bytes = document.storage.back();
  document.buffer_views[0].extensions["EXT_meshopt_compression"].update({{"buffer", 2}, {"byteOffset", 7}});
  EXPECT_EQ(decoded<float>(document), values);
}

TEST(decode_meshopt, refuses_triangles_that_are_not_whole) {
  EXPECT_THAT(meshopt_error(compressed(encode_triangles({0, 1, 2}, 3), 4, 4, "TRIANGLES")).detail,
              HasSubstr("multiple of 3"));
}

TEST(decode_meshopt, G68_a_small_file_cannot_grow_without_end) {
  gltf::Document document =
      compressed(encode_vertices(std::vector<float>(3 * 100'000, 1.0f), 12), 100'000, 12, "ATTRIBUTES");
  for (int i = 0; i < 80; ++i) document.buffer_views.push_back(document.buffer_views[0]);
  const ImportIssue issue = meshopt_error(document, 1000);
  EXPECT_EQ(issue.rule, "memory-budget");
  EXPECT_THAT(issue.json_pointer, testing::StartsWith("/bufferViews/5"));  // 64 MiB are full after 55 views of 1.2 MB
}

TEST(decode_meshopt, survives_any_byte_changed) {
  test::FixedRandom random(8);
  const auto vertices = encode_vertices(some_floats(300), 12);
  const auto triangles = encode_triangles({0, 1, 2, 2, 1, 3, 3, 1, 4}, 5);
  for (int i = 0; i < 2000; ++i) {
    auto a = vertices, b = triangles;
    a[random.below(static_cast<std::uint32_t>(a.size()))] = static_cast<unsigned char>(random.below(256));
    b[random.below(static_cast<std::uint32_t>(b.size()))] = static_cast<unsigned char>(random.below(256));
    for (auto& document : {compressed(a, 100, 12, "ATTRIBUTES"), compressed(b, 9, 4, "TRIANGLES")}) {
      gltf::Document copy = document;
      IssueLog log;
      DecodeBudget budget(1000);
      decode_meshopt(copy, budget, log);
      EXPECT_EQ(log.ok(), !copy.buffer_views[0].bytes.empty());
    }
  }
}

}  // namespace
}  // namespace sinew
