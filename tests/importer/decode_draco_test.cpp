// SPDX-License-Identifier: MIT
#include "importer/decode/decode_draco.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#pragma GCC diagnostic pop
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "importer/decode/draco_stream.h"
#include "importer/read/accessor.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using gltf::Json;
using testing::HasSubstr;

constexpr std::uint32_t kSide = 4;  ///< squares along each side of the grid
constexpr std::uint32_t kFaces = 2 * kSide * kSide;
constexpr std::uint32_t kVertices = (kSide + 1) * (kSide + 1);

/// A grid in z = x * y with positions (float) and joints (u8), not quantised; `method` is the Draco encoding method.
std::vector<std::byte> encode_grid(int method, bool with_metadata = false) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(kFaces);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  std::uint32_t face = 0;
  const auto add = [&](std::array<std::array<std::uint32_t, 2>, 3> corners) {
    std::array<std::array<float, 3>, 3> p;
    std::array<std::array<std::uint8_t, 4>, 3> j;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto x = corners[k][0], y = corners[k][1];
      p[k] = {float(x), float(y), float(x * y)};
      j[k] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0, 255};
    }
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(face), &p[0], &p[1], &p[2]);
    builder.SetAttributeValuesForFace(joints, draco::FaceIndex(face), &j[0], &j[1], &j[2]);
    ++face;
  };
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      add({{{x, y}, {x + 1, y}, {x + 1, y + 1}}});
      add({{{x, y}, {x + 1, y + 1}, {x, y + 1}}});
    }
  const auto mesh = builder.Finalize();
  if (with_metadata) {
    auto metadata = std::make_unique<draco::GeometryMetadata>();
    metadata->AddEntryString("made by", "hand");
    mesh->AddMetadata(std::move(metadata));
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  std::vector<std::byte> out(buffer.size());
  std::memcpy(out.data(), buffer.data(), buffer.size());
  return out;
}

/// A document of one primitive with its accessors: 0 indices, 1 positions, 2 joints.
gltf::Document grid_document(const std::vector<std::byte>& stream,
                             gltf::ComponentType joint_type = gltf::ComponentType::u8) {
  gltf::Document document;
  document.storage.push_back(stream);
  document.buffer_views.resize(1);
  document.buffer_views[0].bytes = document.storage.back();
  document.accessors.resize(3);
  document.accessors[0].count = 3 * kFaces;
  document.accessors[0].component_type = gltf::ComponentType::u16;
  document.accessors[1].count = document.accessors[2].count = kVertices;
  document.accessors[1].type = gltf::ElementType::vec3;
  document.accessors[2].type = gltf::ElementType::vec4;
  document.accessors[2].component_type = joint_type;
  gltf::Primitive primitive;
  primitive.indices = 0;
  primitive.attributes = {{"POSITION", 1}, {"JOINTS_0", 2}};
  primitive.extensions["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                        {"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}}}};
  document.meshes.resize(1);
  document.meshes[0].primitives.push_back(primitive);
  return document;
}

Json& extension_of(gltf::Document& document) {
  return document.meshes[0].primitives[0].extensions["KHR_draco_mesh_compression"];
}

void expect_decodes(gltf::Document document) {
  IssueLog log;
  DecodeBudget budget(1000);
  decode_draco(document, budget, log);
  ASSERT_TRUE(log.ok()) << log.take_error("").issue.detail;
  const auto indices = read_unsigned(document, 0), joints = read_unsigned(document, 2);
  const auto positions = read_floats(document, 1);
  ASSERT_EQ(positions.size(), 3 * kVertices);
  std::set<std::tuple<float, float>> places;
  for (std::size_t v = 0; v < kVertices; ++v) {
    const float x = positions[3 * v], y = positions[3 * v + 1];
    EXPECT_EQ(positions[3 * v + 2], x * y);
    EXPECT_EQ(joints[4 * v], static_cast<std::uint32_t>(x));
    EXPECT_EQ(joints[4 * v + 1], static_cast<std::uint32_t>(y));
    EXPECT_EQ(joints[4 * v + 3], 255u);
    places.insert({x, y});
  }
  EXPECT_EQ(places.size(), kVertices);
  double area = 0;  // seen from above, every face is half a square and has the same winding
  for (std::size_t f = 0; f < kFaces; ++f) {
    const auto at = [&](std::size_t k, std::size_t c) { return double(positions[3 * indices[3 * f + k] + c]); };
    const double twice = (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1));
    EXPECT_EQ(twice, 1.0);
    area += twice / 2;
  }
  EXPECT_EQ(area, double(kSide * kSide));
}

ImportIssue draco_error(gltf::Document document) {
  IssueLog log;
  DecodeBudget budget(1000);
  decode_draco(document, budget, log);
  EXPECT_FALSE(log.ok());
  return log.ok() ? ImportIssue{} : log.take_error("").issue;
}

constexpr const char* kPlace = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

TEST(decode_draco, G62_gives_a_mesh_back_from_both_encodings) {
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
    expect_decodes(grid_document(encode_grid(method)));
}

TEST(decode_draco, G62_joints_take_the_type_of_the_accessor) {
  const auto stream = encode_grid(draco::MESH_EDGEBREAKER_ENCODING);
  expect_decodes(grid_document(stream, gltf::ComponentType::u16));
}

TEST(decode_draco, numbers_take_every_type_that_holds_them) {
  using Type = gltf::ComponentType;
  const auto stream = encode_grid(draco::MESH_EDGEBREAKER_ENCODING);
  for (const Type type : {Type::u8, Type::i16, Type::u16, Type::u32, Type::f32}) {
    auto document = grid_document(stream, type);
    IssueLog log;
    DecodeBudget budget(1000);
    decode_draco(document, budget, log);
    ASSERT_TRUE(log.ok()) << static_cast<int>(type);
    EXPECT_EQ(document.accessors[2].component_type, type);
    const auto positions = read_floats(document, 1);
    const auto joints = read_stored(document, 2);
    ASSERT_EQ(joints.size(), 4 * kVertices);
    for (std::size_t v = 0; v < kVertices; ++v) {
      EXPECT_EQ(joints[4 * v], double(positions[3 * v])) << static_cast<int>(type);
      EXPECT_EQ(joints[4 * v + 3], 255.0) << static_cast<int>(type);
    }
  }
  const ImportIssue issue = draco_error(grid_document(stream, Type::i8));
  EXPECT_EQ(issue.rule, "decode-failed");
  EXPECT_THAT(issue.detail, HasSubstr("JOINTS_0 does not fit the accessor's type")) << "255 in a signed byte";
}

TEST(decode_draco, G68_each_part_is_taken_from_the_budget_before_it_is_made) {
  const auto stream = encode_grid(draco::MESH_SEQUENTIAL_ENCODING);
  const std::uint64_t mesh = 12 * kFaces + 32 * kVertices, indices = 4 * 3 * kFaces, joints = 4 * kVertices,
                      positions = 12 * kVertices, all = mesh + indices + joints + positions;
  for (const std::uint64_t too_little : {mesh - 1, mesh + indices - 1, mesh + indices + joints - 1, all - 1}) {
    auto document = grid_document(stream);
    IssueLog log;
    DecodeBudget budget(1000, too_little);
    decode_draco(document, budget, log);
    ASSERT_FALSE(log.ok()) << too_little;
    const ImportIssue issue = log.take_error("").issue;
    EXPECT_EQ(issue.rule, "memory-budget") << too_little;
    EXPECT_EQ(issue.json_pointer, kPlace);
  }
  auto document = grid_document(stream);
  IssueLog log;
  DecodeBudget budget(1000, all);
  decode_draco(document, budget, log);
  EXPECT_TRUE(log.ok());
}

TEST(decode_draco, G62_accessor_views_are_ignored) {
  auto document = grid_document(encode_grid(draco::MESH_EDGEBREAKER_ENCODING));
  for (auto& accessor : document.accessors) {
    accessor.buffer_view = 0;
    accessor.byte_offset = 99;
  }
  expect_decodes(document);
}

TEST(decode_draco, compressed_strips_become_triangles) {
  auto document = grid_document(encode_grid(draco::MESH_EDGEBREAKER_ENCODING));
  document.meshes[0].primitives[0].mode = TINYGLTF_MODE_TRIANGLE_STRIP;
  document.accessors[0].count = 34;
  expect_decodes(document);
}

TEST(decode_draco, primitives_may_share_a_stream) {
  auto document = grid_document(encode_grid(draco::MESH_EDGEBREAKER_ENCODING));
  document.meshes[0].primitives.push_back(document.meshes[0].primitives[0]);
  expect_decodes(document);
}

TEST(decode_draco, G62_the_stream_knows_how_many_elements_there_are) {
  const auto stream = encode_grid(draco::MESH_EDGEBREAKER_ENCODING);
  for (const int more : {-3, 3}) {
    auto document = grid_document(stream);
    for (auto& accessor : document.accessors) accessor.count += static_cast<std::uint64_t>(more);
    IssueLog log;
    DecodeBudget budget(1000);
    decode_draco(document, budget, log);
    ASSERT_TRUE(log.ok());
    const auto warnings = log.take_warnings();
    ASSERT_EQ(warnings.size(), 3u);
    for (const ImportIssue& warning : warnings) {
      EXPECT_EQ(warning.rule, "draco-count");
      EXPECT_EQ(warning.json_pointer, kPlace);
    }
    EXPECT_EQ(document.accessors[0].count, 3 * kFaces);
    EXPECT_EQ(document.accessors[1].count, kVertices);
    EXPECT_EQ(read_floats(document, 1).size(), 3 * kVertices);
  }
}

TEST(decode_draco, an_accessor_that_two_streams_fill_is_two_accessors) {
  auto document = grid_document(encode_grid(draco::MESH_EDGEBREAKER_ENCODING));
  document.storage.push_back(encode_grid(draco::MESH_SEQUENTIAL_ENCODING));
  document.buffer_views.resize(2);
  document.buffer_views[1].bytes = document.storage.back();
  auto& primitives = document.meshes[0].primitives;
  primitives.push_back(primitives[0]);
  primitives[1].extensions["KHR_draco_mesh_compression"]["bufferView"] = 1;
  primitives.push_back(primitives[0]);
  IssueLog log;
  DecodeBudget budget(1000);
  decode_draco(document, budget, log);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(primitives[0].attributes, (std::map<std::string, int>{{"JOINTS_0", 2}, {"POSITION", 1}}));
  EXPECT_EQ(primitives[2].attributes, primitives[0].attributes) << "the same stream is decoded once";
  EXPECT_GE(primitives[1].attributes.at("POSITION"), 3u);
  EXPECT_GE(primitives[1].indices, 3u);
  EXPECT_NE(read_floats(document, 1), read_floats(document, primitives[1].attributes.at("POSITION")))
      << "the methods store vertices in different orders";
}

TEST(decode_draco, what_could_not_be_decoded_has_no_bounds_to_compare) {
  auto document = grid_document(encode_grid(draco::MESH_EDGEBREAKER_ENCODING));
  for (gltf::Accessor& accessor : document.accessors) accessor.min = accessor.max = {1, 2, 3};
  document.buffer_views[0].bytes = document.buffer_views[0].bytes.first(40);
  IssueLog log;
  DecodeBudget budget(1000);
  decode_draco(document, budget, log);
  EXPECT_FALSE(log.ok());
  for (const gltf::Accessor& accessor : document.accessors)
    EXPECT_TRUE(accessor.min.empty() && accessor.max.empty()) << &accessor - document.accessors.data();
}

TEST(decode_draco, G62_refuses_what_does_not_match_the_document) {
  const auto stream = encode_grid(draco::MESH_EDGEBREAKER_ENCODING);
  const auto refuse = [&](const char* rule, const std::string& place, const char* detail, auto change) {
    auto document = grid_document(stream);
    change(document);
    const ImportIssue issue = draco_error(document);
    EXPECT_EQ(issue.rule, rule) << detail;
    EXPECT_EQ(issue.json_pointer, kPlace + place);
    EXPECT_THAT(issue.detail, HasSubstr(detail));
  };
  refuse("decode-failed", "", "3 components", [](auto& d) { d.accessors[1].type = gltf::ElementType::vec4; });
  refuse("decode-failed", "", "no attribute 9", [](auto& d) { extension_of(d)["attributes"]["POSITION"] = 9; });
  refuse("decode-failed", "", "COLOR_0 is no attribute", [](auto& d) { extension_of(d)["attributes"]["COLOR_0"] = 0; });
  refuse("decode-failed", "", "no indices", [](auto& d) { d.meshes[0].primitives[0].indices = kNone; });
  refuse("decode-failed", "", "only triangles", [](auto& d) { d.meshes[0].primitives[0].mode = TINYGLTF_MODE_LINE; });
  refuse("decode-failed", "", "ends early",
         [](auto& d) { d.buffer_views[0].bytes = d.buffer_views[0].bytes.first(12); });
  refuse("decode-failed", "", "damaged", [](auto& d) { d.buffer_views[0].bytes = d.buffer_views[0].bytes.first(40); });
  refuse("decode-failed", "", "no Draco stream", [](auto& d) { d.buffer_views[0].bytes = {}; });
  refuse("reference", "/bufferView", "index 5 of 1", [](auto& d) { extension_of(d)["bufferView"] = 5; });
  refuse("json-missing", "", "attributes", [](auto& d) { extension_of(d).erase("attributes"); });
  refuse("json-type", "", "", [](auto& d) { extension_of(d) = 3; });
}

TEST(decode_draco, G62_metadata_are_read_past) {
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    const auto stream = encode_grid(method, true), plain = encode_grid(method);
    ASSERT_GT(stream.size(), plain.size());
    const auto size = probe_draco(stream);
    ASSERT_TRUE(size) << size.error();
    EXPECT_EQ(size->faces, kFaces);
    EXPECT_EQ(size->vertices, probe_draco(plain)->vertices);
    const auto cut = probe_draco(gltf::Bytes(stream).first(14));
    ASSERT_FALSE(cut);
    EXPECT_THAT(cut.error(), HasSubstr("ends early"));
  }
}

TEST(decode_draco, a_head_that_ends_before_both_counts_is_refused) {
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    const auto stream = encode_grid(method);
    const std::size_t head = method == draco::MESH_EDGEBREAKER_ENCODING ? 12 : 11;
    ASSERT_TRUE(probe_draco(gltf::Bytes(stream).first(head + 2)));
    for (const std::size_t counts : {0, 1}) {
      const auto cut = probe_draco(gltf::Bytes(stream).first(head + counts));
      ASSERT_FALSE(cut) << counts;
      EXPECT_EQ(cut.error(), "the Draco stream ends early");
    }
  }
}

TEST(decode_draco, G68_a_head_that_claims_millions_is_refused_before_decoding) {
  auto stream = encode_grid(draco::MESH_SEQUENTIAL_ENCODING);
  // DRACO, version, type, method, flags: 11 bytes, then the face count as a varint.
  stream.erase(stream.begin() + 11);
  for (const int byte : {0x3f, 0xff, 0xff, 0xff}) stream.insert(stream.begin() + 11, static_cast<std::byte>(byte));
  const auto size = probe_draco(stream);
  ASSERT_FALSE(size);
  EXPECT_THAT(size.error(), HasSubstr("claims 134217727 faces"));
}

TEST(decode_draco, survives_any_byte_changed) {
  test::FixedRandom random(21);
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    const auto stream = encode_grid(method);
    for (int i = 0; i < 1500; ++i) {
      auto damaged = stream;
      damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] = static_cast<std::byte>(random.below(256));
      auto document = grid_document(damaged);
      IssueLog log;
      DecodeBudget budget(1000);
      decode_draco(document, budget, log);
      if (log.ok()) {
        EXPECT_EQ(read_floats(document, 1).size(), 3 * document.accessors[1].count);
      }
    }
  }
}

}  // namespace
}  // namespace sinew
