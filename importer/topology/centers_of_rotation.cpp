// SPDX-License-Identifier: MIT
#include "importer/topology/centers_of_rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "importer/topology/centers_cache.h"
#include "runtime/threads/default_executor.h"

namespace sinew {
namespace {

/// Joints and their weights, sorted by joint.
using Weights = std::vector<std::pair<std::uint16_t, double>>;

struct Triangle {
  Weights weights;
  glm::dvec3 centroid;
  double area;
};

std::vector<Weights> weights_of_vertices(const Primitive& primitive) {
  std::vector<Weights> all(primitive.vertex_count());
  const auto& influences = primitive.influences;
  for (const auto& group : influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; ++v) {
      Weights& weights = all[group.first_vertex + v];
      for (std::uint32_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + std::size_t{v} * group.influence_count + i;
        weights.emplace_back(influences.joints[at], influences.weights[at]);
      }
      std::sort(weights.begin(), weights.end());
    }
  return all;
}

Weights mean_of_three(const Weights& a, const Weights& b, const Weights& c) {
  std::map<std::uint16_t, double> sum;
  for (const Weights* weights : {&a, &b, &c})
    for (const auto& [joint, weight] : *weights) sum[joint] += weight / 3.0;
  return {sum.begin(), sum.end()};
}

std::vector<Triangle> triangles_of(const Primitive& primitive, const std::vector<Weights>& weights) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t a = primitive.indices[i], b = primitive.indices[i + 1], c = primitive.indices[i + 2];
    const glm::dvec3 p(primitive.positions[a]), q(primitive.positions[b]), r(primitive.positions[c]);
    const double area = 0.5 * glm::length(glm::cross(q - p, r - p));
    if (area > 0.0) triangles.push_back({mean_of_three(weights[a], weights[b], weights[c]), (p + q + r) / 3.0, area});
  }
  return triangles;
}

/// The weight of one joint in a vertex or triangle (`owner`).
struct Share {
  std::uint32_t owner;
  double weight;
};

/// For each joint, its weights sorted by owner.
class SharesByJoint {
 public:
  void add(std::uint32_t owner, const Weights& weights) {
    for (const auto& [joint, weight] : weights) {
      if (joint >= shares_.size()) shares_.resize(joint + std::size_t{1});
      shares_[joint].push_back({owner, weight});
    }
  }

  /// Calls `take(owner, weight of j, weight of k)` for every owner influenced by both joints.
  template <class Take>
  void for_each_of_both(std::uint16_t j, std::uint16_t k, const Take& take) const {
    if (std::max(j, k) >= shares_.size()) return;
    auto b = shares_[k].begin();
    for (const Share& a : shares_[j]) {
      while (b != shares_[k].end() && b->owner < a.owner) ++b;
      if (b == shares_[k].end()) return;
      if (b->owner == a.owner) take(a.owner, a.weight, b->weight);
    }
  }

 private:
  std::vector<std::vector<Share>> shares_;
};

/// A weighted sum of points and the sum of their weights.
struct WeightedSum {
  glm::dvec3 points{0.0};
  double weight = 0.0;

  void add(const glm::dvec3& weighted_points, double w) {
    points += weighted_points;
    weight += w;
  }
};

/// Merged triangles on which two joints have the weights j and k.
struct PairSurface {
  double j, k;
  WeightedSum area;

  friend bool operator<(const PairSurface& a, const PairSurface& b) {
    return std::pair(a.j, a.k) < std::pair(b.j, b.k);
  }
  bool has_weights_of(const PairSurface& other) const { return j == other.j && k == other.k; }
};

struct PairVertex {
  std::uint32_t vertex;
  double j, k;
};

/// Evaluates the equation for each pair of joints: a pair contributes only to vertices and triangles influenced by
/// both.
class CenterSearch {
 public:
  CenterSearch(const Primitive& primitive, const CentersOptions& options) : options_(options) {
    const std::vector<Weights> weights = weights_of_vertices(primitive);
    triangles_ = triangles_of(primitive, weights);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) triangle_shares_.add(t, triangles_[t].weights);
    std::map<Weights, std::vector<std::uint32_t>> by_weights;  // vertices with equal weights share their center
    for (std::uint32_t v = 0; v < weights.size(); ++v) by_weights[weights[v]].push_back(v);
    for (auto& [of_all, vertices] : by_weights) {
      vertex_shares_.add(static_cast<std::uint32_t>(vertices_.size()), of_all);
      for (std::size_t j = 0; j < of_all.size(); ++j)
        for (std::size_t k = j + 1; k < of_all.size(); ++k) pairs_.emplace(of_all[j].first, of_all[k].first);
      vertices_.push_back(std::move(vertices));
    }
    sums_.resize(vertices_.size());
  }

  std::vector<glm::vec3> run(const Primitive& primitive) {
    std::size_t done = 0;
    for (const auto& [j, k] : pairs_) {
      add_pair(j, k, static_cast<double>(done) / static_cast<double>(pairs_.size()));
      ++done;
    }
    if (options_.progress) options_.progress(1.0);
    std::vector<glm::vec3> centers = primitive.positions;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const glm::dvec3 center = sums_[i].points / sums_[i].weight;
      if (!(sums_[i].weight > 0.0) || !std::isfinite(center.x + center.y + center.z)) continue;
      for (const std::uint32_t v : vertices_[i]) centers[v] = glm::vec3(center);
    }
    return centers;
  }

 private:
  void add_pair(std::uint16_t j, std::uint16_t k, double done_before) {
    std::vector<PairVertex> vertices;
    vertex_shares_.for_each_of_both(j, k, [&](std::uint32_t v, double wj, double wk) {
      vertices.push_back({v, wj, wk});
    });
    const std::vector<PairSurface> surface = surface_of(j, k);
    constexpr std::size_t kBlock = 1024;  // vertices between two progress reports
    for (std::size_t first = 0; first < vertices.size(); first += kBlock) {
      const std::size_t end = std::min(vertices.size(), first + kBlock);
      if (options_.progress) {
        const double part = static_cast<double>(first) / static_cast<double>(vertices.size());
        options_.progress(done_before + part / static_cast<double>(pairs_.size()));
      }
      run_in_parallel(end - first, [&](std::size_t i) {
        const PairVertex& vertex = vertices[first + i];
        add(surface, vertex, sums_[vertex.vertex]);
      });
    }
  }

  std::vector<PairSurface> surface_of(std::uint16_t j, std::uint16_t k) const {
    std::vector<PairSurface> all;
    triangle_shares_.for_each_of_both(j, k, [&](std::uint32_t t, double wj, double wk) {
      all.push_back({wj, wk, {triangles_[t].centroid * triangles_[t].area, triangles_[t].area}});
    });
    std::stable_sort(all.begin(), all.end());
    std::size_t count = 0;
    for (const PairSurface& next : all) {
      if (count > 0 && all[count - 1].has_weights_of(next))
        all[count - 1].area.add(next.area.points, next.area.weight);
      else
        all[count++] = next;
    }
    all.resize(count);
    return all;
  }

  /// Adds the terms of one pair of joints to one vertex. The paper sums over ordered pairs, so each unordered pair
  /// counts twice.
  void add(const std::vector<PairSurface>& surface, const PairVertex& v, WeightedSum& sum) const {
    for (const PairSurface& s : surface) {
      const double difference = (v.j * s.k - v.k * s.j) / options_.sigma;
      const double similarity = 2.0 * v.j * v.k * s.j * s.k * std::exp(-difference * difference);
      sum.add(similarity * s.area.points, similarity * s.area.weight);
    }
  }

  const CentersOptions& options_;
  std::vector<Triangle> triangles_;
  SharesByJoint triangle_shares_, vertex_shares_;     // owners of vertex shares are distinct lists of weights
  std::vector<std::vector<std::uint32_t>> vertices_;  // [distinct lists of weights] the vertices that have them
  std::set<std::pair<std::uint16_t, std::uint16_t>> pairs_;
  std::vector<WeightedSum> sums_;
};

}  // namespace

std::vector<glm::vec3> centers_of_rotation(const Primitive& primitive, const CentersOptions& options) {
  if (primitive.influences.empty() || primitive.topology != Topology::triangles) return primitive.positions;
  const CentersCache cache(options.cache_folder, primitive, options.sigma);
  if (auto stored = cache.load()) return *std::move(stored);
  std::vector<glm::vec3> centers = CenterSearch(primitive, options).run(primitive);
  cache.store(centers);
  return centers;
}

}  // namespace sinew
