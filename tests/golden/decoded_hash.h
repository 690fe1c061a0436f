// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/bit_hash.h"
#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew::test {

inline std::vector<std::byte> bytes_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  const auto view = std::as_bytes(std::span(bytes));
  return {view.begin(), view.end()};
}

/// Hash of the bits of all vertices of all streams, at each frame and half way between it and the frame before.
inline std::uint64_t decoded_hash(std::span<const std::byte> file) {
  const auto cache = GeometryCache::open(file);
  EXPECT_TRUE(cache.has_value());
  if (!cache) return 0;
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, file};
  BitHash hash;
  std::vector<glm::vec3> out;
  for (std::uint32_t half = 0; half + 1 < 2 * cache->frame_count(); ++half) {
    EXPECT_EQ(decoder.decode_time(cache->start_s() + 0.5 * half * cache->frame_s(), source), GeometryStatus::ok);
    std::size_t stream = 0;
    for (const GeometryMesh& mesh : cache->meshes())
      for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
        out.resize(mesh.vertex_count);
        EXPECT_EQ(decoder.write_vertices(stream++, out), GeometryStatus::ok);
        hash.add(std::span(out));
      }
  }
  return hash.value();
}

}  // namespace sinew::test
