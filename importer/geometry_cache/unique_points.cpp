// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/unique_points.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "runtime/base/checksum.h"

namespace sinew {
namespace {

bool same_in_all(std::span<const std::vector<glm::vec3>> frames, std::uint32_t a, std::uint32_t b) {
  return std::all_of(frames.begin(), frames.end(), [&](const std::vector<glm::vec3>& frame) {
    return std::memcmp(&frame[a], &frame[b], sizeof(glm::vec3)) == 0;
  });
}

}  // namespace

UniquePoints find_unique_points(std::span<const std::vector<glm::vec3>> frames) {
  const std::size_t count = frames.empty() ? 0 : frames[0].size();
  std::vector<std::uint64_t> sums(count, 0);
  for (const std::vector<glm::vec3>& frame : frames)
    for (std::size_t v = 0; v < count; ++v) sums[v] = checksum(std::as_bytes(std::span(&frame[v], 1)), sums[v]);
  UniquePoints out;
  std::unordered_multimap<std::uint64_t, std::uint32_t> points_of_sum;
  for (std::uint32_t v = 0; v < count; ++v) {
    const auto [first, last] = points_of_sum.equal_range(sums[v]);
    const auto same = std::find_if(
        first, last, [&](const auto& entry) { return same_in_all(frames, out.vertex_of_point[entry.second], v); });
    if (same != last) {
      out.point_of_vertex.push_back(same->second);
      continue;
    }
    const auto point = static_cast<std::uint32_t>(out.vertex_of_point.size());
    points_of_sum.emplace(sums[v], point);
    out.point_of_vertex.push_back(point);
    out.vertex_of_point.push_back(v);
  }
  return out;
}

}  // namespace sinew
