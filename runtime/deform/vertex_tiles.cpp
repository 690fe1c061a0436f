// SPDX-License-Identifier: MIT
#include "runtime/deform/vertex_tiles.h"

#include <algorithm>
#include <span>
#include <utility>

namespace sinew {
namespace {

/// Number of lanes of the most common vectors (AVX2). Leftovers of a run are the vertices that do not fill such a
/// vector.
constexpr std::uint32_t kVector = 8;

/// At least this many consecutive vertices are cut at multiples of 16 vertices, because stores past the caches need
/// aligned tiles.
constexpr std::uint32_t kLongStretch = 64;

/// Number of larger sets that are tried as a place for the leftovers of a set. It bounds the time for meshes with many
/// sets, which have few vertices each.
constexpr std::size_t kMostTried = 64;

struct Influence {
  std::uint16_t joint;
  float weight;
};

/// The influences of all vertices, sorted by joint within each vertex.
class SortedInfluences {
 public:
  explicit SortedInfluences(const VertexInfluences& from) {
    all_.reserve(from.joints.size());
    first_.push_back(0);
    for (const InfluenceGroup& group : from.groups)
      for (std::uint32_t v = 0; v < group.vertex_count; ++v)
        add(from, group.first_influence + std::size_t{v} * group.influence_count, group.influence_count);
  }
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(first_.size() - 1); }
  std::span<const Influence> of(std::uint32_t vertex) const noexcept {
    return std::span(all_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

  /// The number of joints of a vertex and its first three joints, in the order of compare().
  std::uint64_t sort_key(std::uint32_t vertex) const noexcept {
    const auto influences = of(vertex);
    std::uint64_t key = influences.size();
    for (std::size_t i = 0; i < 3; ++i) key = key << 16 | (i < influences.size() ? influences[i].joint : 0u);
    return key;
  }

  /// Orders vertices by number of joints, then by joints, so that vertices with the same set of joints become
  /// neighbours.
  int compare(std::uint32_t a, std::uint32_t b) const noexcept {
    const auto of_a = of(a), of_b = of(b);
    if (of_a.size() != of_b.size()) return of_a.size() < of_b.size() ? -1 : 1;
    for (std::size_t i = 0; i < of_a.size(); ++i)
      if (of_a[i].joint != of_b[i].joint) return of_a[i].joint < of_b[i].joint ? -1 : 1;
    return 0;
  }

 private:
  void add(const VertexInfluences& from, std::size_t at, std::size_t count) {
    double sum = 0;
    for (std::size_t i = at; i < at + count; ++i) sum += double{from.weights[i]};
    for (std::size_t i = at; i < at + count; ++i)
      all_.push_back({from.joints[i], static_cast<float>(double{from.weights[i]} / sum)});
    std::sort(all_.end() - static_cast<std::ptrdiff_t>(count), all_.end(),
              [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
    first_.push_back(all_.size());
  }

  std::vector<Influence> all_;
  std::vector<std::size_t> first_;
};

/// The vertices that follow the same set of joints.
struct JointSet {
  std::vector<std::uint16_t> joints;                           ///< increasing; the weight of joints[0] is not stored
  std::vector<std::uint32_t> lanes;                            ///< vertices in the order of the run
  std::uint32_t in_fours = 0, in_eights = 0, in_sixteens = 0;  ///< as in TileRun

  std::uint32_t leftover() const noexcept { return static_cast<std::uint32_t>(lanes.size() % kVector); }
  std::uint32_t free() const noexcept { return (kVector - leftover()) % kVector; }

  /// True if vertices of `other` may move to this set. Both sets must have the same first joint, because rounding grows
  /// with the size of its matrix. Weights of 0 change no bit, so vertices have the same bits as in their own set.
  bool may_take(const JointSet& other) const noexcept {
    return other.joints[0] == joints[0] && other.joints.size() < joints.size() &&
           std::includes(joints.begin(), joints.end(), other.joints.begin(), other.joints.end());
  }
};

/// `count` consecutive vertices: 16, 8, 4 or 1.
struct Piece {
  std::uint32_t first, count;
};

/// Cuts increasing vertices into pieces of 16, 8, 4 and 1 consecutive vertices, and sorts the pieces by falling size.
std::vector<Piece> pieces_of(std::span<const std::uint32_t> vertices) {
  std::vector<Piece> pieces;
  for (std::size_t begin = 0, end = 0; begin < vertices.size(); begin = end) {
    for (end = begin + 1; end < vertices.size() && vertices[end] == vertices[end - 1] + 1;) ++end;
    std::uint32_t at = vertices[begin];
    const std::uint32_t last = vertices[end - 1] + 1;
    const bool is_long = last - at >= kLongStretch;
    while (at < last) {
      std::uint32_t most = last - at;
      if (is_long && at % VertexTiles::kLanes != 0)
        most = std::min(most, VertexTiles::kLanes - at % VertexTiles::kLanes);
      const std::uint32_t count = most >= 16 ? 16 : most >= 8 ? 8 : most >= 4 ? 4 : 1;
      pieces.push_back({at, count});
      at += count;
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.count > b.count; });
  return pieces;
}

/// Consecutive vertices that follow the same set of joints.
struct Stretch {
  std::uint64_t sort_key;
  std::uint32_t first, count;
};

/// The stretches of a mesh, sorted by their sets and then by their vertices. Sorting stretches is faster than sorting
/// vertices, because importers place vertices with equal joints side by side.
std::vector<Stretch> sorted_stretches(const SortedInfluences& influences) {
  std::vector<Stretch> stretches;
  for (std::uint32_t v = 0; v < influences.vertex_count(); ++v)
    if (v > 0 && influences.compare(v - 1, v) == 0)
      ++stretches.back().count;
    else
      stretches.push_back({influences.sort_key(v), v, 1});
  std::sort(stretches.begin(), stretches.end(), [&](const Stretch& a, const Stretch& b) {
    if (a.sort_key != b.sort_key) return a.sort_key < b.sort_key;
    const int compared = influences.compare(a.first, b.first);
    return compared != 0 ? compared < 0 : a.first < b.first;
  });
  return stretches;
}

std::vector<JointSet> find_sets(const SortedInfluences& influences) {
  const std::vector<Stretch> stretches = sorted_stretches(influences);
  std::vector<JointSet> sets;
  std::vector<std::uint32_t> vertices;
  for (std::size_t begin = 0, end = 0; begin < stretches.size(); begin = end) {
    vertices.clear();
    for (; end < stretches.size() && influences.compare(stretches[begin].first, stretches[end].first) == 0; ++end)
      for (std::uint32_t i = 0; i < stretches[end].count; ++i) vertices.push_back(stretches[end].first + i);
    JointSet& set = sets.emplace_back();
    for (const Influence& influence : influences.of(vertices[0])) set.joints.push_back(influence.joint);
    for (const Piece& piece : pieces_of(vertices)) {
      set.in_sixteens += piece.count == 16 ? 16 : 0;
      set.in_eights += piece.count >= 8 ? piece.count : 0;
      set.in_fours += piece.count >= 4 ? piece.count : 0;
      for (std::uint32_t v = piece.first; v < piece.first + piece.count; ++v) set.lanes.push_back(v);
    }
  }
  return sets;
}

/// Moves the leftovers of each set to free lanes of larger sets, if these have room for all of them.
void move_leftovers(std::vector<JointSet>& sets) {
  std::vector<std::vector<std::size_t>> of_first;  // sets by their first joint
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::uint16_t joint = sets[s].joints[0];
    if (joint >= of_first.size()) of_first.resize(joint + 1u);
    of_first[joint].push_back(s);
  }
  for (auto largest = sets.rbegin(); largest != sets.rend(); ++largest) {  // large sets first: none moves twice
    JointSet& set = *largest;
    if (set.leftover() == 0) continue;
    std::vector<std::size_t> takers;
    std::uint32_t room = 0;
    std::size_t tried = 0;
    for (const std::size_t s : of_first[set.joints[0]]) {
      if (room >= set.leftover() || ++tried > kMostTried) break;
      if (sets[s].free() == 0 || !sets[s].may_take(set)) continue;
      takers.push_back(s);
      room += sets[s].free();
    }
    if (room < set.leftover()) continue;
    for (const std::size_t s : takers)
      for (std::uint32_t left = std::min(sets[s].free(), set.leftover()); left > 0; --left) {
        sets[s].lanes.push_back(set.lanes.back());
        set.lanes.pop_back();
      }
    set.in_fours = std::min(set.in_fours, static_cast<std::uint32_t>(set.lanes.size() / 4 * 4));
  }
}

/// Appends the run of each set to VertexTiles.
class TileWriter {
 public:
  TileWriter(const SortedInfluences& influences, const VertexInput& in, std::span<const glm::vec3> centers,
             VertexTiles& out)
      : influences_(influences), in_(in), centers_(centers), out_(out) {}

  /// Allocates exactly as much as all sets need.
  void reserve(std::span<const JointSet> sets) {
    std::size_t joints = 0, tiles = 0, weights = 0;
    for (const JointSet& set : sets) {
      const std::size_t of_set = (set.lanes.size() + VertexTiles::kLanes - 1) / VertexTiles::kLanes;
      joints += set.joints.size();
      tiles += of_set;
      weights += of_set * (set.joints.size() - 1);
    }
    out_.runs.reserve(sets.size());
    out_.joints.reserve(joints);
    out_.positions.reserve(3 * tiles);
    out_.weights.reserve(weights);
    out_.normals.reserve(in_.normals.empty() ? 0 : 3 * tiles);
    out_.tangents.reserve(in_.tangents.empty() ? 0 : 4 * tiles);
    out_.centers.reserve(centers_.empty() ? 0 : 3 * tiles);
    out_.vertices.reserve(VertexTiles::kLanes * tiles);
    out_.fours.reserve(VertexTiles::kLanes / 4 * tiles);
  }

  void add(const JointSet& set) {
    TileRun run{.first_tile = static_cast<std::uint32_t>(out_.tile_count()),
                .lane_count = static_cast<std::uint32_t>(set.lanes.size()),
                .first_weight = static_cast<std::uint32_t>(out_.weights.size()),
                .first_joint = static_cast<std::uint32_t>(out_.joints.size()),
                .joint_count = static_cast<std::uint32_t>(set.joints.size()),
                .in_fours = set.in_fours,
                .in_eights = set.in_eights,
                .in_sixteens = set.in_sixteens};
    out_.joints.insert(out_.joints.end(), set.joints.begin() + 1, set.joints.end());
    out_.joints.push_back(set.joints[0]);
    out_.joint_count = std::max(out_.joint_count, set.joints.back() + 1u);
    for (std::size_t lane = 0; lane < set.lanes.size(); lane += VertexTiles::kLanes) {
      const std::size_t own = std::min<std::size_t>(set.lanes.size() - lane, VertexTiles::kLanes);
      add_tile(run, std::span(set.lanes).subspan(lane, own));
    }
    out_.runs.push_back(run);
  }

 private:
  void add_tile(const TileRun& run, std::span<const std::uint32_t> own) {
    std::array<std::uint32_t, VertexTiles::kLanes> vertices;
    for (std::size_t lane = 0; lane < vertices.size(); ++lane) vertices[lane] = own[std::min(lane, own.size() - 1)];
    out_.vertices.insert(out_.vertices.end(), vertices.begin(), vertices.end());
    for (std::size_t lane = 0; lane < vertices.size(); lane += 4) {
      bool in_a_row = lane + 4 <= own.size();
      for (std::size_t i = 1; i < 4; ++i) in_a_row &= vertices[lane + i] == vertices[lane] + i;
      out_.fours.push_back(in_a_row ? vertices[lane] : VertexTiles::kNotInARow);
    }
    add_planes(out_.positions, 3, [&](std::size_t lane, int c) { return in_.positions[vertices[lane]][c]; });
    for (std::size_t i = 0; i + 1 < run.joint_count; ++i)
      add_planes(out_.weights, 1,
                 [&](std::size_t lane, int) { return weight(vertices[lane], out_.joints[run.first_joint + i]); });
    if (!in_.normals.empty())
      add_planes(out_.normals, 3, [&](std::size_t lane, int c) { return in_.normals[vertices[lane]][c]; });
    if (!in_.tangents.empty())
      add_planes(out_.tangents, 4, [&](std::size_t lane, int c) { return in_.tangents[vertices[lane]][c]; });
    if (!centers_.empty())
      add_planes(out_.centers, 3, [&](std::size_t lane, int c) { return center(vertices[lane])[c]; });
  }

  template <class Number>
  static void add_planes(std::vector<TilePlane>& to, int count, const Number& number) {
    for (int c = 0; c < count; ++c) {
      TilePlane& plane = to.emplace_back();
      for (std::size_t lane = 0; lane < plane.lane.size(); ++lane) plane.lane[lane] = number(lane, c);
    }
  }

  float weight(std::uint32_t vertex, std::uint16_t joint) const noexcept {
    for (const Influence& influence : influences_.of(vertex))
      if (influence.joint == joint) return influence.weight;
    return 0.0f;
  }

  const glm::vec3& center(std::uint32_t vertex) const noexcept {
    return influences_.of(vertex).size() == 1 ? in_.positions[vertex] : centers_[vertex];
  }

  const SortedInfluences& influences_;
  const VertexInput& in_;
  std::span<const glm::vec3> centers_;
  VertexTiles& out_;
};

}  // namespace

double VertexTiles::relative_cost() const noexcept {
  constexpr double kOfScattered = 1.8, kOfStart = 1.0;
  double vectors = 0;
  for (const TileRun& run : runs) {
    const std::uint32_t in_a_row = run.in_eights / kVector, all = (run.lane_count + kVector - 1) / kVector;
    vectors += kOfStart + in_a_row + kOfScattered * (all - in_a_row);
  }
  return vertex_count == 0 ? 1.0 : vectors * kVector / vertex_count;
}

VertexTiles tile_vertices(const VertexInfluences& influences, const VertexInput& vertices,
                          std::span<const glm::vec3> centers) {
  const SortedInfluences sorted(influences);
  std::vector<JointSet> sets = find_sets(sorted);
  move_leftovers(sets);
  std::erase_if(sets, [](const JointSet& set) { return set.lanes.empty(); });
  std::stable_sort(sets.begin(), sets.end(), [](const JointSet& a, const JointSet& b) {
    return a.joints.size() != b.joints.size() ? a.joints.size() < b.joints.size() : a.lanes[0] < b.lanes[0];
  });
  VertexTiles tiles;
  tiles.vertex_count = sorted.vertex_count();
  TileWriter writer(sorted, vertices, centers, tiles);
  writer.reserve(sets);
  for (const JointSet& set : sets) writer.add(set);
  return tiles;
}

}  // namespace sinew
