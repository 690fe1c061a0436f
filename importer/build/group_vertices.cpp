// SPDX-License-Identifier: MIT
#include "importer/build/group_vertices.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "importer/topology/gather_vertices.h"
#include "runtime/base/bit_hash.h"
#include "runtime/base/same_bits.h"

namespace sinew {
namespace {

std::uint32_t count_of(const MergedInfluences& merged, std::uint32_t vertex) {
  return merged.first[vertex + 1] - merged.first[vertex];
}

void add_group(VertexInfluences& out, std::uint32_t count, std::uint32_t position, std::uint32_t first_entry) {
  if (out.groups.empty() || out.groups.back().influence_count != count)
    out.groups.push_back({position, 0, count, first_entry});
  ++out.groups.back().vertex_count;
}

/// Moves the lists when the vertices are in order already, else copies them vertex by vertex.
void fill_influences(VertexInfluences& out, MergedInfluences merged, const std::vector<std::uint32_t>& source,
                     bool in_order) {
  std::uint32_t entry = 0;
  for (std::uint32_t v = 0; v < source.size(); ++v) {
    const std::uint32_t count = count_of(merged, source[v]);
    add_group(out, count, v, entry);
    entry += count;
  }
  if (in_order) {
    out.joints = std::move(merged.joints);
    out.weights = std::move(merged.weights);
    return;
  }
  out.joints.resize(merged.joints.size());
  out.weights.resize(merged.weights.size());
  auto joint = out.joints.begin();
  auto weight = out.weights.begin();
  for (const std::uint32_t old : source)
    for (std::uint32_t i = merged.first[old]; i < merged.first[old + 1]; ++i) {
      *joint++ = merged.joints[i];
      *weight++ = merged.weights[i];
    }
}

/// The joints and weights of a vertex.
struct InfluencesOf {
  std::span<const std::uint16_t> joints;
  std::span<const float> weights;

  InfluencesOf(const MergedInfluences& merged, std::uint32_t vertex)
      : joints(std::span(merged.joints).subspan(merged.first[vertex], count_of(merged, vertex))),
        weights(std::span(merged.weights).subspan(merged.first[vertex], count_of(merged, vertex))) {}

  std::uint64_t hash() const {
    BitHash hash;
    for (const std::uint16_t joint : joints) hash.add(std::span<const std::uint32_t, 1>({joint}));
    return hash.add(weights).value();
  }
  friend bool operator==(const InfluencesOf& a, const InfluencesOf& b) {
    return same_bits(a.joints, b.joints) && same_bits(a.weights, b.weights);
  }
};

/// Numbers the influences of vertices in the order in which they come: the same ones have the same number.
class InfluenceNumbers {
 public:
  InfluenceNumbers(const MergedInfluences& merged, std::size_t most)
      : merged_(merged), slots_(std::bit_ceil(2 * most + 1), kNone) {}

  std::uint32_t of(std::uint32_t vertex) {
    const InfluencesOf own(merged_, vertex);
    const std::uint64_t hash = own.hash();
    for (std::size_t at = hash ^ hash >> 32;; ++at) {
      std::uint32_t& number = slots_[at & (slots_.size() - 1)];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(first_vertex_.size());
        first_vertex_.push_back(vertex);
        return number;
      }
      if (InfluencesOf(merged_, first_vertex_[number]) == own) return number;
    }
  }
  std::size_t count() const { return first_vertex_.size(); }

 private:
  const MergedInfluences& merged_;
  std::vector<std::uint32_t> slots_;         ///< an open hash table of numbers
  std::vector<std::uint32_t> first_vertex_;  ///< of each number
};

/// Brings vertices with the same influences together, at the place of the first of them, by a stable counting sort.
void gather_equal(const MergedInfluences& merged, std::span<std::uint32_t> vertices) {
  InfluenceNumbers numbers(merged, vertices.size());
  std::vector<std::uint32_t> number_of;
  number_of.reserve(vertices.size());
  for (const std::uint32_t v : vertices) number_of.push_back(numbers.of(v));
  if (numbers.count() == vertices.size()) return;
  std::vector<std::uint32_t> next(numbers.count() + 1, 0);  // per number: where its next vertex goes
  for (const std::uint32_t number : number_of) ++next[number + 1];
  for (std::size_t n = 1; n < next.size(); ++n) next[n] += next[n - 1];
  const std::vector<std::uint32_t> before(vertices.begin(), vertices.end());
  for (std::size_t i = 0; i < before.size(); ++i) vertices[next[number_of[i]]++] = before[i];
}

/// Sorts vertices by their number of influences with a stable counting sort.
std::vector<std::uint32_t> sorted_by_count(const MergedInfluences& merged, std::size_t vertex_count) {
  std::vector<std::uint32_t> end;  // per number of influences: where its next vertex goes
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t count = count_of(merged, v);
    if (end.size() < count + 2) end.resize(count + 2, 0);
    ++end[count + 1];
  }
  for (std::size_t c = 1; c < end.size(); ++c) end[c] += end[c - 1];
  std::vector<std::uint32_t> source(vertex_count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) source[end[count_of(merged, v)]++] = v;
  for (std::size_t c = 1; c < end.size(); ++c)
    gather_equal(merged, std::span(source).subspan(end[c - 1], end[c] - end[c - 1]));
  return source;
}

}  // namespace

void group_vertices(Primitive& primitive, MergedInfluences merged) {
  const std::size_t vertices = primitive.vertex_count();
  if (merged.first.size() != vertices + 1 || vertices == 0) return;
  const std::vector<std::uint32_t> source = sorted_by_count(merged, vertices);
  const bool in_order = std::is_sorted(source.begin(), source.end());
  if (!in_order) permute_vertices(primitive, source);
  fill_influences(primitive.influences, std::move(merged), source, in_order);
}

}  // namespace sinew
