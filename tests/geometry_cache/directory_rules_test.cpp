// SPDX-License-Identifier: MIT
// Directories written number by number: each rule is tested on both sides of its limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "importer/geometry_cache/encode_stream.h"
#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"

namespace sinew::test {
namespace {

struct StreamFields {
  std::uint8_t kind = 0;
  float step = 0.5f;
  std::uint32_t points = 2, most_payload = 0;
  double asked = 1.0, measured = 0.75;
  std::vector<std::uint32_t> point_of_vertex = {0, 1, 1};
  std::vector<std::uint8_t> corners = std::vector<std::uint8_t>(kBlockNumbers, kNoCorner);
};

struct MeshFields {
  std::string name = "cloth";
  std::uint32_t vertices = 3;
  std::vector<std::uint32_t> triangles = {0, 1, 2};
  double between_m = -1.0;
  std::array<float, 6> box = {-1, -2, -3, 1, 2, 3};
  std::vector<StreamFields> streams = {{}};
  int stream_count = -1;  // the written number; negative = the true one
};

/// The fields of a file with two frames and no content.
struct FileFields {
  double start_s = 0.5, frame_s = 0.25;
  std::uint32_t frames = 2, segment_frames = 1;
  std::vector<MeshFields> meshes = {{}};
  std::vector<std::uint32_t> sizes = {5, 7};
  std::vector<std::uint64_t> sums = {11, 22};
  std::vector<std::uint16_t> boxes = std::vector<std::uint16_t>(12, 0);
  bool packed = false;                 // tables are packed by zstd
  std::vector<std::byte> behind = {};  // bytes after the directory
  std::int64_t more_file_bytes = 0;    // added to the true file size
};

void add_table(std::span<const std::uint8_t> bytes, bool packed, ByteWriter& out) {
  std::vector<std::byte> stored;
  if (packed) {
    out.add(store_bytes(bytes, stored, kDirectoryZstdLevel));
  } else {
    out.add(static_cast<std::uint32_t>(bytes.size()));
    stored.assign(std::as_bytes(bytes).begin(), std::as_bytes(bytes).end());
  }
  out.bytes().insert(out.bytes().end(), stored.begin(), stored.end());
}

template <class T>
std::span<const std::uint8_t> raw(const std::vector<T>& numbers) {
  return {reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size() * sizeof(T)};
}

void add_mesh(const MeshFields& mesh, bool packed, ByteWriter& out) {
  out.add(std::span<const char>(mesh.name));
  out.add(mesh.vertices);
  out.add(static_cast<std::uint32_t>(mesh.triangles.size()));
  add_table(planes_of_numbers(mesh.triangles), packed, out);
  out.add(mesh.between_m);
  for (const float x : mesh.box) out.add(x);
  out.add(static_cast<std::uint8_t>(mesh.stream_count < 0 ? static_cast<int>(mesh.streams.size()) : mesh.stream_count));
  for (const StreamFields& stream : mesh.streams) {
    out.add(stream.kind);
    out.add(stream.step);
    out.add(stream.points);
    out.add(stream.most_payload);
    out.add(stream.asked);
    out.add(stream.measured);
    add_table(planes_of_numbers(stream.point_of_vertex), packed, out);
    add_table(stream.corners, packed, out);
  }
}

std::vector<std::byte> directory_of(const FileFields& fields) {
  ByteWriter out;
  out.add(fields.start_s);
  out.add(fields.frame_s);
  out.add(fields.frames);
  out.add(fields.segment_frames);
  out.add(static_cast<std::uint32_t>(fields.meshes.size()));
  for (const MeshFields& mesh : fields.meshes) add_mesh(mesh, fields.packed, out);
  add_table(planes_of_numbers(fields.sizes), fields.packed, out);
  add_table(raw(fields.sums), fields.packed, out);
  add_table(raw(fields.boxes), fields.packed, out);
  std::vector<std::byte> bytes = std::move(out.bytes());
  bytes.insert(bytes.end(), fields.behind.begin(), fields.behind.end());
  return bytes;
}

tl::expected<GeometryCache, GeometryCacheError> opened(const FileFields& fields) {
  const std::vector<std::byte> directory = directory_of(fields);
  std::uint64_t size = kGeometryFileHead + directory.size() + static_cast<std::uint64_t>(fields.more_file_bytes);
  for (const std::uint32_t frame : fields.sizes) size += frame;
  ByteWriter out;
  for (const char c : kGeometryMagic) out.add(c);
  out.add(kGeometryFileVersion);
  out.add(std::uint32_t{0});
  out.add(std::uint64_t{kGeometryFileHead + directory.size()});
  out.add(size);
  out.add(checksum(directory));
  std::vector<std::byte> head = std::move(out.bytes());
  head.insert(head.end(), directory.begin(), directory.end());
  return GeometryCache::open(head, size);
}

/// The rule that the file breaks after a change; empty if it opens.
std::string rule_with(const std::function<void(FileFields&)>& change) {
  FileFields fields;
  change(fields);
  const auto cache = opened(fields);
  return cache ? std::string() : cache.error().rule;
}
std::string mesh_rule_with(const std::function<void(MeshFields&)>& change) {
  return rule_with([&](FileFields& f) { change(f.meshes[0]); });
}
std::string stream_rule_with(const std::function<void(StreamFields&)>& change) {
  return mesh_rule_with([&](MeshFields& m) { change(m.streams[0]); });
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(directory_rules, a_sound_directory_is_read_as_it_was_written) {
  for (const bool packed : {false, true}) {
    FileFields fields;
    fields.packed = packed;
    fields.meshes.push_back({.name = "", .vertices = 0, .triangles = {}});
    fields.meshes[1].streams[0] = {.points = 0, .point_of_vertex = {}, .corners = {}};
    fields.meshes[0].streams.push_back({.kind = 2, .step = 2.0f, .points = 3, .point_of_vertex = {2, 0, 1}});
    fields.meshes[0].streams[1].corners[3] = 0;
    fields.meshes[0].streams[1].asked = 3.0;
    fields.boxes.assign(24, 0);
    fields.boxes[12] = 65535;
    const auto cache = opened(fields);
    ASSERT_TRUE(cache.has_value()) << cache.error().detail;
    EXPECT_EQ(cache->start_s(), 0.5);
    EXPECT_EQ(cache->frame_s(), 0.25);
    EXPECT_EQ(cache->duration_s(), 0.25);
    EXPECT_EQ(cache->segment_frames(), 1u);
    EXPECT_EQ(cache->stream_count(), 3u);
    EXPECT_EQ(cache->largest_frame(), 7u);
    ASSERT_EQ(cache->frames().size(), 2u);
    EXPECT_EQ(cache->frames()[1].offset, cache->frames()[0].offset + 5);
    EXPECT_EQ(cache->frames()[0].checksum, 11u);
    EXPECT_EQ(cache->frames()[1].checksum, 22u);
    EXPECT_EQ(cache->frames()[1].size, 7u);
    const GeometryMesh& mesh = cache->meshes()[0];
    EXPECT_EQ(mesh.name, "cloth");
    EXPECT_EQ(mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.certificate.asked_m, 1.0);
    EXPECT_EQ(mesh.certificate.measured_m, 0.75);
    EXPECT_EQ(mesh.certificate.between_m, -1.0);
    EXPECT_EQ(mesh.bounds.lower, glm::vec3(-1, -2, -3));
    EXPECT_EQ(mesh.bounds.upper, glm::vec3(1, 2, 3));
    EXPECT_EQ(mesh.streams[1].kind, GeometryKind::colors);
    EXPECT_EQ(mesh.streams[1].point_of_vertex, (std::vector<std::uint32_t>{2, 0, 1}));
    EXPECT_EQ(mesh.streams[1].corners[3], 0);
    EXPECT_EQ(mesh.streams[1].asked, 3.0);
    EXPECT_EQ(mesh.streams[0].step, 0.5f);
    EXPECT_EQ(cache->bounds(1, 0).lower.x, 1.0f) << "frame 1, mesh 0: the whole size from the left";
    EXPECT_EQ(cache->bounds(0, 0).lower.x, -1.0f);
  }
}

TEST(directory_rules, times_are_finite_and_go_on) {
  for (const double bad : {kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_EQ(rule_with([&](FileFields& f) { f.start_s = bad; }), "cache-value");
    EXPECT_EQ(rule_with([&](FileFields& f) { f.frame_s = bad; }), "cache-value");
  }
  EXPECT_EQ(rule_with([](FileFields& f) { f.start_s = -7.0; }), "");
  EXPECT_EQ(rule_with([](FileFields& f) { f.frame_s = 0.0; }), "cache-value");
  EXPECT_EQ(rule_with([](FileFields& f) { f.frame_s = 1e-300; }), "");
  EXPECT_EQ(rule_with([](FileFields& f) { f.segment_frames = 0; }), "cache-value");
  EXPECT_EQ(rule_with([](FileFields& f) {
              f.frames = 0;
              f.sizes = {};
              f.sums = {};
              f.boxes = {};
            }),
            "cache-value");
}

TEST(directory_rules, triangles_are_whole_and_name_vertices_that_are_there) {
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.triangles = {0, 1}; }), "cache-value");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.triangles = {0, 1, 3}; }), "cache-value");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.triangles = {2, 2, 2, 0, 0, 0}; }), "");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.triangles = {}; }), "");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.vertices = kMaxPoints + 1; }), "cache-value");
}

TEST(directory_rules, boxes_and_certificates_are_finite) {
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(mesh_rule_with([&](MeshFields& m) { m.box[k] = std::numeric_limits<float>::infinity(); }), "cache-value");
    EXPECT_EQ(mesh_rule_with([&](MeshFields& m) { m.box[k] = std::nanf(""); }), "cache-value");
  }
  EXPECT_EQ(mesh_rule_with([&](MeshFields& m) { m.box = {-3e38f, 0, 0, 3e38f, 0, 0}; }), "cache-value")
      << "its size is not finite";
  EXPECT_EQ(mesh_rule_with([&](MeshFields& m) { m.between_m = kInfinity; }), "cache-value");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.asked = kInfinity; }), "cache-value");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.measured = std::nan(""); }), "cache-value");
}

TEST(directory_rules, a_mesh_has_one_to_three_streams_positions_first) {
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.streams.clear(); }), "cache-value");
  for (const std::uint8_t kind : {std::uint8_t{1}, std::uint8_t{2}}) {
    EXPECT_EQ(stream_rule_with([&](StreamFields& s) { s.kind = kind; }), "cache-value") << "no positions";
    EXPECT_EQ(mesh_rule_with([&](MeshFields& m) { m.streams.push_back({.kind = kind}); }), "");
  }
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.streams.push_back({.kind = 0}); }), "cache-value") << "twice";
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.streams.push_back({.kind = 3}); }), "cache-value");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) {
              m.streams.push_back({.kind = 1});
              m.streams.push_back({.kind = 2});
            }),
            "");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) {
              m.streams.push_back({.kind = 2});
              m.streams.push_back({.kind = 1});
            }),
            "cache-value");
  EXPECT_EQ(mesh_rule_with([](MeshFields& m) { m.stream_count = 4; }), "cache-value");
}

TEST(directory_rules, numbers_of_a_stream_are_within_their_limits) {
  for (const float step : {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::nanf("")})
    EXPECT_EQ(stream_rule_with([&](StreamFields& s) { s.step = step; }), "cache-value") << step;
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.points = 3; }), "");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.points = 4; }), "cache-value") << "more than vertices";
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.points = 1; }), "cache-value") << "vertices name point 1";
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.most_payload = 192 * 4; }), "");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.most_payload = 192 * 4 + 1; }), "cache-value");
}

TEST(directory_rules, tables_have_the_size_of_what_they_describe) {
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.point_of_vertex.push_back(0); }), "cache-value");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.point_of_vertex.pop_back(); }), "cache-value");
  EXPECT_EQ(stream_rule_with([](StreamFields& s) { s.corners.pop_back(); }), "cache-value");
  for (const bool packed : {false, true}) {
    EXPECT_EQ(rule_with([&](FileFields& f) {
                f.packed = packed;
                f.sums.push_back(1);
              }),
              "cache-value");
    EXPECT_EQ(rule_with([&](FileFields& f) {
                f.packed = packed;
                f.boxes.resize(11);
              }),
              "cache-value");
  }
  EXPECT_EQ(rule_with([](FileFields& f) { f.sizes.push_back(0); }), "cache-value");
}

TEST(directory_rules, the_directory_ends_where_it_ends_and_the_frames_fill_the_file) {
  EXPECT_EQ(rule_with([](FileFields& f) { f.behind.push_back(std::byte(0)); }), "cache-size");
  EXPECT_EQ(rule_with([](FileFields& f) { f.more_file_bytes = 1; }), "cache-value");
  EXPECT_EQ(rule_with([](FileFields& f) { f.more_file_bytes = -1; }), "cache-value");
  EXPECT_EQ(rule_with([](FileFields& f) { f.sizes[0] = kStoredByZstd; }), "cache-value");
}

TEST(directory_rules, tables_take_up_to_16_MiB_and_64_times_the_head) {
  // All vertices share one point: their table takes 4 bytes of memory each, but nearly none in the file. The other
  // tables take 12 and 192 bytes, and the two frames take 8 + 16 + 24 bytes and their entries.
  FileFields fields;
  fields.packed = true;
  const auto with_vertices = [&](std::size_t count) {
    fields.meshes[0].vertices = static_cast<std::uint32_t>(count);
    fields.meshes[0].streams[0].point_of_vertex.assign(count, 0);
    return opened(fields).has_value();
  };
  const std::size_t others = 12 + 192 + 8 + 16 + 24 + 2 * sizeof(GeometryFrame), limit = std::size_t{16} << 20;
  EXPECT_TRUE(with_vertices(limit / 4)) << "more than 16 MiB with the other tables";
  const std::size_t head = kGeometryFileHead + directory_of(fields).size();
  EXPECT_TRUE(with_vertices((limit + 64 * head - others) / 4 - 100)) << "nearly all that the head gives";
  EXPECT_FALSE(with_vertices((limit + 64 * head - others) / 4 + 100));
}

}  // namespace
}  // namespace sinew::test
