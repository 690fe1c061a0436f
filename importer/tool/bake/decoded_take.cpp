// SPDX-License-Identifier: MIT
#include "importer/tool/bake/decoded_take.h"

#include <algorithm>

#include <fmt/core.h>

#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew::tool {

tl::expected<GeometryTake, std::string> decoded_take(const CacheFile& file, std::size_t most_frames) {
  GeometryTake out;
  out.frame_s = file.cache.frame_s();
  for (const GeometryMesh& mesh : file.cache.meshes()) {
    TakeMesh& taken = out.meshes.emplace_back();
    taken.name = mesh.name;
    taken.vertex_count = mesh.vertex_count;
    taken.triangles = mesh.triangles;
    taken.streams.push_back({GeometryKind::positions, {}, mesh.certificate.asked_m});
  }
  GeometryDecoder decoder(file.cache);
  MappedFrames source{file.cache, file.bytes};
  for (std::uint32_t f = 0; f < std::min<std::size_t>(most_frames, file.cache.frame_count()); ++f) {
    if (decoder.decode(f, source) != GeometryStatus::ok)
      return tl::unexpected(fmt::format("frame {} is not as it was written", f));
    std::size_t stream = 0;
    for (std::size_t m = 0; m < out.meshes.size(); stream += file.cache.meshes()[m++].streams.size())
      decoder.write_vertices(stream, out.meshes[m].streams[0].frames.emplace_back(file.cache.meshes()[m].vertex_count));
  }
  return out;
}

}  // namespace sinew::tool
