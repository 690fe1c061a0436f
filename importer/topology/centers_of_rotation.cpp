// SPDX-License-Identifier: MIT
#include "importer/topology/centers_of_rotation.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "importer/topology/centers_cache.h"

namespace sinew {
namespace {

/// Joints with their weights, joints rising.
using Weights = std::vector<std::pair<std::uint16_t, double>>;

struct Triangle {
  Weights weights;
  glm::dvec3 centroid;
  double area;
};

std::uint32_t pair_key(std::uint32_t j, std::uint32_t k) { return j << 16 | k; }

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

/// For every pair of joints, the triangles that both of them move: no other triangle is similar to a vertex of that pair.
std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> triangles_by_pair(const std::vector<Triangle>& triangles) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_pair;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Weights& w = triangles[t].weights;
    for (std::size_t j = 0; j < w.size(); ++j)
      for (std::size_t k = j + 1; k < w.size(); ++k) by_pair[pair_key(w[j].first, w[k].first)].push_back(t);
  }
  return by_pair;
}

double weight_of(const Weights& weights, std::uint16_t joint) {
  const auto found = std::lower_bound(weights.begin(), weights.end(), joint, [](const auto& w, std::uint16_t j) { return w.first < j; });
  return found != weights.end() && found->first == joint ? found->second : 0.0;
}

/// Each unordered pair counts twice in the paper's sum over j != k.
double similarity(const Weights& u, const Weights& v, double sigma) {
  double sum = 0.0;
  for (std::size_t j = 0; j < u.size(); ++j)
    for (std::size_t k = j + 1; k < u.size(); ++k) {
      const double vj = weight_of(v, u[j].first), vk = weight_of(v, u[k].first);
      if (vj == 0.0 || vk == 0.0) continue;
      const double difference = (u[j].second * vk - u[k].second * vj) / sigma;
      sum += 2.0 * u[j].second * u[k].second * vj * vk * std::exp(-difference * difference);
    }
  return sum;
}

class CenterSearch {
 public:
  CenterSearch(const Primitive& primitive, const CentersOptions& options)
      : options_(options),
        weights_(weights_of_vertices(primitive)),
        triangles_(triangles_of(primitive, weights_)),
        by_pair_(triangles_by_pair(triangles_)) {}

  std::vector<glm::vec3> run(const Primitive& primitive) {
    std::map<Weights, std::vector<std::uint32_t>> vertices_of;  // vertices of equal weights share their center
    for (std::uint32_t v = 0; v < weights_.size(); ++v) vertices_of[weights_[v]].push_back(v);
    std::vector<const std::pair<const Weights, std::vector<std::uint32_t>>*> work;
    for (const auto& entry : vertices_of)
      if (entry.first.size() > 1) work.push_back(&entry);

    std::vector<glm::vec3> centers = primitive.positions;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, work.size()), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        glm::dvec3 center;
        if (find(work[i]->first, center))
          for (const std::uint32_t v : work[i]->second) centers[v] = glm::vec3(center);
        report(work.size());
      }
    });
    return centers;
  }

 private:
  struct Seen {
    std::vector<std::uint32_t> stamp;
    std::uint32_t now = 0;
  };

  /// Triangles are visited in one fixed order per weight vector, so that results do not depend on threads.
  bool find(const Weights& weights, glm::dvec3& center) {
    Seen& seen = seen_.local();
    seen.stamp.resize(triangles_.size(), 0);
    ++seen.now;
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j)
      for (std::size_t k = j + 1; k < weights.size(); ++k) {
        const auto candidates = by_pair_.find(pair_key(weights[j].first, weights[k].first));
        if (candidates == by_pair_.end()) continue;
        for (const std::uint32_t t : candidates->second) {
          if (std::exchange(seen.stamp[t], seen.now) == seen.now) continue;
          const double share = similarity(weights, triangles_[t].weights, options_.sigma) * triangles_[t].area;
          sum += share * triangles_[t].centroid;
          total += share;
        }
      }
    center = sum / total;
    return total > 0.0 && std::isfinite(center.x + center.y + center.z);
  }

  void report(std::size_t count) {
    const std::size_t done = ++done_;
    if (!options_.progress || (done % 256 != 0 && done != count)) return;
    const std::lock_guard lock(progress_mutex_);
    reported_ = std::max(reported_, static_cast<double>(done) / static_cast<double>(count));
    options_.progress(reported_);
  }

  const CentersOptions& options_;
  std::vector<Weights> weights_;
  std::vector<Triangle> triangles_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_pair_;
  tbb::enumerable_thread_specific<Seen> seen_;
  std::atomic<std::size_t> done_{0};
  std::mutex progress_mutex_;
  double reported_ = 0.0;
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
