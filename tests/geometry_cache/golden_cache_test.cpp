// SPDX-License-Identifier: MIT
// The encoder must still produce the content of tests/golden/cloth.sgeo. Sections and tables are compared unpacked,
// because versions of zstd pack differently. After a deliberate change of the encoder or the format:
//     SINEW_RECORD=1 build/release/bin/sinew-test-geometry-cache --gtest_filter='golden_cache.*'
// writes the file and the hash of what it decodes to. As long as files of version 1 are to be read, the old file stays
// beside the new one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <ios>
#include <vector>

#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"
#include "tests/geometry_cache/takes.h"
#include "tests/golden/decoded_hash.h"

namespace sinew::test {
namespace {

const std::string kFolder = SINEW_SOURCE_DIR "/tests/golden/";

/// A flag, and coloured points that a matrix moves: blocks of all kinds, computed with the same bits on every machine.
GeometryTake golden_take() {
  showcase::ClothFrames cloth = showcase::fly_flag({.columns = 7, .rows = 5, .spacing_m = 0.1, .frame_count = 10});
  GeometryTake take = take_of(std::move(cloth.frames), std::move(cloth.triangles), 1e-3);
  take.start_s = 0.5;
  take.meshes.push_back(noise_take(70, 10, 1e-3).meshes[0]);
  TakeMesh& mesh = take.meshes[1];
  TakeStream colors{GeometryKind::colors, {}, 0.01};
  const std::vector<glm::vec3> rest = mesh.streams[0].frames[0];
  for (std::size_t f = 0; f < 10; ++f) {
    const auto t = 0.125f * static_cast<float>(f);
    auto& color = colors.frames.emplace_back();
    for (std::size_t v = 0; v < rest.size(); ++v) {
      mesh.streams[0].frames[f][v] = {rest[v].x - t * rest[v].y, rest[v].y + t * rest[v].x, rest[v].z + t * t};
      color.emplace_back(0.5f, 0.25f * t, v % 2 == 0 ? 0.0f : 1.0f);
    }
  }
  mesh.streams.push_back(std::move(colors));
  return take;
}

std::vector<std::byte> encoded() {
  const auto file = encode_geometry_cache(golden_take(), {.segment_frames = 6});
  EXPECT_TRUE(file.has_value());
  return *file;
}

/// All sections of all frames, unpacked; each is preceded by its size.
std::vector<std::uint8_t> unpacked_frames(const GeometryCache& cache, std::span<const std::byte> file) {
  std::vector<std::uint8_t> out, section(1 << 16);
  Unpacker unpacker;
  for (const GeometryFrame& frame : cache.frames()) {
    auto bytes = file.subspan(frame.offset, frame.size);
    while (!bytes.empty()) {
      std::uint32_t heads[kSections];
      std::memcpy(heads, bytes.data(), sizeof(heads));
      bytes = bytes.subspan(sizeof(heads));
      for (const std::uint32_t head : heads) {
        const std::uint32_t stored = head & ~kStoredByZstd;
        const std::size_t size = unpacker.unpack(bytes.first(stored), head != stored, section);
        EXPECT_LE(size, section.size());
        for (unsigned byte = 0; byte < 4; ++byte) out.push_back(static_cast<std::uint8_t>(size >> (8 * byte)));
        out.insert(out.end(), section.begin(), section.begin() + static_cast<std::ptrdiff_t>(size));
        bytes = bytes.subspan(stored);
      }
    }
  }
  return out;
}

TEST(golden_cache, the_encoder_makes_the_stored_file) {
  const std::vector<std::byte> file = encoded();
  if (std::getenv("SINEW_RECORD") != nullptr) {
    std::ofstream(kFolder + "cloth.sgeo", std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    std::ofstream(kFolder + "cloth.sgeo.txt") << std::hex << decoded_hash(file) << "\n";
  }
  const std::vector<std::byte> stored = bytes_of_file(kFolder + "cloth.sgeo");
  const auto now = GeometryCache::open(file), golden = GeometryCache::open(stored);
  ASSERT_TRUE(now.has_value() && golden.has_value());
  EXPECT_LT(stored.size(), 16'000u);
  EXPECT_EQ(now->start_s(), golden->start_s());
  EXPECT_EQ(now->frame_s(), golden->frame_s());
  EXPECT_EQ(now->segment_frames(), golden->segment_frames());
  ASSERT_EQ(now->frame_count(), golden->frame_count());
  ASSERT_EQ(now->meshes().size(), golden->meshes().size());
  for (std::size_t m = 0; m < now->meshes().size(); ++m) {
    const GeometryMesh &a = now->meshes()[m], &b = golden->meshes()[m];
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(a.streams.size(), b.streams.size());
    for (std::size_t s = 0; s < a.streams.size(); ++s) {
      EXPECT_EQ(a.streams[s].kind, b.streams[s].kind);
      EXPECT_EQ(a.streams[s].step, b.streams[s].step);
      EXPECT_EQ(a.streams[s].point_of_vertex, b.streams[s].point_of_vertex);
      EXPECT_EQ(a.streams[s].corners, b.streams[s].corners);
      EXPECT_EQ(a.streams[s].measured, b.streams[s].measured);
    }
  }
  EXPECT_EQ(unpacked_frames(*now, file), unpacked_frames(*golden, stored));
}

TEST(golden_cache, the_stored_file_has_blocks_of_all_kinds) {
  const std::vector<std::byte> file = bytes_of_file(kFolder + "cloth.sgeo");
  const auto cache = GeometryCache::open(file);
  ASSERT_TRUE(cache.has_value());
  const std::vector<std::uint8_t> sections = unpacked_frames(*cache, file);
  std::uint32_t kinds = 0;
  std::size_t at = 0;
  for (std::uint32_t f = 0; f < cache->frame_count(); ++f)
    for (const GeometryMesh& mesh : cache->meshes())
      for (const GeometryStream& stream : mesh.streams)
        for (std::size_t s = 0; s < kSections; ++s) {
          std::uint32_t size;
          std::memcpy(&size, sections.data() + at, sizeof(size));
          at += sizeof(size);
          for (std::size_t b = 0; s == 0 && b < stream.block_count(); ++b) kinds |= 1u << sections[at + 1 + b];
          at += size;
        }
  const auto has = [&](BlockBase base, unsigned bits) {
    return (kinds >> (static_cast<unsigned>(base) | bits) & 1u) != 0;
  };
  EXPECT_TRUE(has(BlockBase::space, 0));
  EXPECT_TRUE(has(BlockBase::last, kTurnsBit) || has(BlockBase::last, kTurnsBit | kSpreadsBit));
  EXPECT_TRUE(has(BlockBase::linear, 0) || has(BlockBase::linear, kTurnsBit));
  EXPECT_TRUE((kinds >> kSpreadsBit) != 0) << "residuals that spread";
}

}  // namespace
}  // namespace sinew::test
