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

/// Fills the influences in the new vertex order. Moves the lists if the order is unchanged, else copies them vertex by
/// vertex.
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

  /// A key with the joints only.
  InfluencesOf without_weights() const { return InfluencesOf(joints); }

  std::uint64_t hash() const {
    BitHash hash;
    for (const std::uint16_t joint : joints) hash.add(std::span<const std::uint32_t, 1>({joint}));
    return hash.add(weights).value();
  }
  friend bool operator==(const InfluencesOf& a, const InfluencesOf& b) {
    return same_bits(a.joints, b.joints) && same_bits(a.weights, b.weights);
  }

 private:
  explicit InfluencesOf(std::span<const std::uint16_t> only) : joints(only) {}
};

/// Numbers the distinct values of `of(vertex)` in order of first occurrence, and returns the number of each vertex.
template <class Of>
std::vector<std::uint32_t> number_equal(std::span<const std::uint32_t> vertices, const Of& of, std::size_t& count) {
  // Hash table with open addressing, holds numbers.
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * vertices.size() + 1), kNone);
  std::vector<std::uint32_t> first_vertex, numbers;  // first vertex of each number; number of each vertex
  numbers.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices) {
    const InfluencesOf own = of(vertex);
    const std::uint64_t hash = own.hash();
    for (std::size_t at = hash ^ hash >> 32;; ++at) {
      std::uint32_t& number = slots[at & (slots.size() - 1)];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(first_vertex.size());
        first_vertex.push_back(vertex);
      } else if (of(first_vertex[number]) != own) {
        continue;
      }
      numbers.push_back(number);
      break;
    }
  }
  count = first_vertex.size();
  return numbers;
}

/// A range of consecutive vertices with equal influences (or equal joints).
struct Run {
  std::uint32_t begin, end;

  /// The largest of kMultiples that is not larger than the run.
  std::uint32_t level() const {
    return *std::find_if(std::begin(kMultiples), std::end(kMultiples), [&](auto m) { return m <= end - begin; });
  }
  static constexpr std::uint32_t kMultiples[] = {16, 8, 4, 1};
};

/// Moves vertices with equal `of` next to the first of them, by a stable counting sort. Returns the runs.
template <class Of>
std::vector<Run> gather_equal(std::span<std::uint32_t> vertices, const Of& of) {
  std::size_t count = 0;
  const std::vector<std::uint32_t> numbers = number_equal(vertices, of, count);
  std::vector<Run> runs(count);
  for (const std::uint32_t number : numbers) ++runs[number].end;
  std::uint32_t begin = 0;
  for (Run& run : runs) {
    run = {begin, begin + run.end};
    begin = run.end;
  }
  std::vector<std::uint32_t> next;
  for (const Run& run : runs) next.push_back(run.begin);
  const std::vector<std::uint32_t> before(vertices.begin(), vertices.end());
  for (std::size_t i = 0; i < before.size(); ++i) vertices[next[numbers[i]]++] = before[i];
  return runs;
}

/// Splits runs so that vector-sized blocks are aligned. Whole multiples of 16 vertices of every run come first, then
/// multiples of 8 and 4 of the remainders, then the rest. Sorting long runs first makes the operation idempotent.
void align_runs(std::vector<Run> runs, std::span<std::uint32_t> vertices) {
  const std::vector<std::uint32_t> before(vertices.begin(), vertices.end());
  std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.level() > b.level(); });
  auto out = vertices.begin();
  for (const std::uint32_t multiple : Run::kMultiples)
    for (Run& run : runs) {
      const std::uint32_t count = (run.end - run.begin) / multiple * multiple;
      out = std::copy_n(before.begin() + run.begin, count, out);
      run.begin += count;
    }
}

/// Orders the vertices within a group of equal influence count.
void order_group(const MergedInfluences& merged, std::span<std::uint32_t> vertices) {
  gather_equal(vertices, [&](std::uint32_t v) { return InfluencesOf(merged, v); });
  align_runs(gather_equal(vertices, [&](std::uint32_t v) { return InfluencesOf(merged, v).without_weights(); }),
             vertices);
}

/// Sorts vertices by their number of influences with a stable counting sort.
std::vector<std::uint32_t> sorted_by_count(const MergedInfluences& merged, std::size_t vertex_count) {
  std::vector<std::uint32_t> end;  // for each influence count: position of its next vertex
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t count = count_of(merged, v);
    if (end.size() < count + 2) end.resize(count + 2, 0);
    ++end[count + 1];
  }
  for (std::size_t c = 1; c < end.size(); ++c) end[c] += end[c - 1];
  std::vector<std::uint32_t> source(vertex_count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) source[end[count_of(merged, v)]++] = v;
  for (std::size_t c = 1; c < end.size(); ++c)
    order_group(merged, std::span(source).subspan(end[c - 1], end[c] - end[c - 1]));
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
