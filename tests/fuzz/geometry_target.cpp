// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {
namespace {

/// Larger caches take long and reveal nothing new.
constexpr std::size_t kMostVertices = 1024;
constexpr std::uint32_t kMostFrames = 64;

bool is_small(const GeometryCache& cache) {
  std::size_t vertices = 0;
  for (const GeometryMesh& mesh : cache.meshes()) vertices += mesh.streams.size() * mesh.vertex_count;
  return cache.frame_count() <= kMostFrames && vertices <= kMostVertices;
}

void show(const GeometryCache& cache, GeometryDecoder& decoder) {
  static std::array<glm::vec3, kMostVertices> out;
  std::size_t stream = 0;
  for (const GeometryMesh& mesh : cache.meshes())
    for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
      const GeometryStatus status = decoder.write_vertices(stream++, std::span(out).first(mesh.vertex_count));
      require(status == GeometryStatus::ok, "a frame that is held can be written");
    }
}

/// Plays forward to the end, backward, and between frames.
void play(const GeometryCache& cache, Bytes file) {
  GeometryDecoder decoder(cache);
  MappedFrames source{cache, file};
  const std::uint32_t last = cache.frame_count() - 1;
  for (const std::uint32_t frame : {0u, 1u, 2u, 3u, last, last / 2}) {
    const GeometryStatus status = decoder.decode(std::min(frame, last), source);
    require(status == GeometryStatus::ok || status == GeometryStatus::damaged, "the whole file is there");
    if (status == GeometryStatus::ok) show(cache, decoder);
  }
  if (decoder.decode_time(cache.start_s() + 0.5 * cache.frame_s(), source) == GeometryStatus::ok) show(cache, decoder);
}

}  // namespace

void play_geometry(Bytes input) {
  const auto cache = GeometryCache::open(input);
  if (!cache)
    require(!cache.error().rule.empty(), "an error names its rule");
  else if (is_small(*cache))
    play(*cache, input);
}

}  // namespace sinew::fuzz
