// SPDX-License-Identifier: MIT
#include "runtime/deform/combine_influences.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "runtime/base/bit_hash.h"
#include "runtime/base/same_bits.h"

namespace sinew {
namespace {

/// Most joints and combinations of a skin: their matrices fill half a second-level cache. With more, combining was up
/// to twice as slow as not combining.
constexpr std::size_t kMaxMatrices = 8192;

/// Influences are combined if this saves the vertices at least so many matrix reads for each matrix that combinations
/// read. Measured on surfaces of 200 to 10,000 vertices with 2, 3 and 4 influences, in random order, with 1.5 to 16
/// vertices per combination.
constexpr std::size_t kCostOfBlend = 3;

/// The joints and weights of the vertices of a group.
class GroupVertices {
 public:
  GroupVertices(const VertexInfluences& influences, const InfluenceGroup& group)
      : influences_(influences), group_(group) {}

  std::span<const std::uint16_t> joints(std::size_t v) const {
    return {&influences_.joints[at(v)], group_.influence_count};
  }
  std::span<const float> weights(std::size_t v) const { return {&influences_.weights[at(v)], group_.influence_count}; }
  bool same(std::size_t a, std::size_t b) const {
    return same_bits(joints(a), joints(b)) && same_bits(weights(a), weights(b));
  }
  std::uint64_t hash(std::size_t v) const {
    BitHash hash;
    for (const std::uint16_t joint : joints(v)) hash.add(std::span<const std::uint32_t, 1>({joint}));
    return hash.add(weights(v)).value();
  }

 private:
  std::size_t at(std::size_t v) const { return group_.first_influence + v * group_.influence_count; }
  const VertexInfluences& influences_;
  const InfluenceGroup& group_;
};

/// For each vertex, the first vertex with the same combination. If the hashes of two combinations collide, a
/// combination may be listed and blended several times. The result is the same.
std::vector<std::uint32_t> first_of_combination(const GroupVertices& vertices, std::size_t count) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_hash;
  for (std::uint32_t v = 0; v < count; ++v) by_hash.emplace_back(vertices.hash(v), v);
  std::sort(by_hash.begin(), by_hash.end());
  std::vector<std::uint32_t> first_of(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [hash, v] = by_hash[i];
    const std::uint32_t last = i > 0 && by_hash[i - 1].first == hash ? first_of[by_hash[i - 1].second] : v;
    first_of[v] = vertices.same(last, v) ? last : v;
  }
  return first_of;
}

/// Adds the combinations of a group in order of appearance, and sets the matrix index of each vertex.
void combine_group(const VertexInfluences& influences, const InfluenceGroup& group, CombinedInfluences& combined) {
  const GroupVertices vertices(influences, group);
  const std::vector<std::uint32_t> first_of = first_of_combination(vertices, group.vertex_count);
  VertexInfluences& all = combined.combinations;
  InfluenceGroup blends{combined.combination_count, 0, group.influence_count,
                        static_cast<std::uint32_t>(all.joints.size())};
  std::vector<std::uint32_t> combination_of(group.vertex_count);
  for (std::uint32_t v = 0; v < group.vertex_count; ++v) {
    if (first_of[v] == v) {
      combination_of[v] = combined.combination_count + blends.vertex_count++;
      all.joints.insert(all.joints.end(), vertices.joints(v).begin(), vertices.joints(v).end());
      all.weights.insert(all.weights.end(), vertices.weights(v).begin(), vertices.weights(v).end());
    }
    combined.vertices.joints.push_back(static_cast<std::uint16_t>(combined.first_matrix + combination_of[first_of[v]]));
  }
  combined.blended_vertices += group.vertex_count;
  combined.combination_count += blends.vertex_count;
  all.groups.push_back(blends);
}

}  // namespace

CombinedInfluences combine_influences(const VertexInfluences& influences, std::size_t first_matrix) {
  CombinedInfluences combined;
  combined.first_matrix = first_matrix;
  for (const InfluenceGroup& group : influences.groups) {
    const auto at = influences.joints.begin() + group.first_influence;
    if (group.influence_count == 1)
      combined.vertices.joints.insert(combined.vertices.joints.end(), at, at + group.vertex_count);
    else
      combine_group(influences, group, combined);
  }
  const std::size_t vertex_count = combined.vertices.joints.size(), spared = influences.joints.size() - vertex_count;
  const bool wins = spared > 0 && spared >= kCostOfBlend * combined.combinations.joints.size();
  if (wins && first_matrix + combined.combination_count <= kMaxMatrices) {
    combined.vertices.groups = {{0, static_cast<std::uint32_t>(vertex_count), 1, 0}};
    combined.vertices.weights.assign(vertex_count, 1.0f);
  } else {
    combined.combinations = {};
    combined.vertices = {};
  }
  return combined;
}

}  // namespace sinew
