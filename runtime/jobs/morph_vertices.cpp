// SPDX-License-Identifier: MIT
#include "runtime/jobs/morph_vertices.h"

#include <algorithm>
#include <cmath>

#include "runtime/jobs/vertex_checks.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

bool in_range(const SparseDeltas<glm::vec3>& deltas, std::size_t vertex_count) noexcept {
  // vertices strictly increase, so the last one is the largest
  return deltas.vertices.size() == deltas.deltas.size() && (deltas.empty() || deltas.vertices.back() < vertex_count);
}

/// Displacement sums of one attribute over all active targets. Answers whether there is any.
bool sum_deltas(const MorphVerticesJob& job, SparseDeltas<glm::vec3> MorphTarget::*attribute) noexcept {
  const auto& targets = job.morphs->targets;
  bool any = false;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto& sparse = targets[t].*attribute;
    const float weight = job.weights[t];
    if (sparse.empty() || !is_active_weight(weight)) continue;
    if (!any) std::fill_n(job.scratch.begin(), job.vertices.positions.size(), glm::vec3(0.0f));
    any = true;
    for (std::size_t i = 0; i < sparse.vertices.size(); ++i) job.scratch[sparse.vertices[i]] += weight * sparse.deltas[i];
  }
  return any;
}

/// A direction after its displacement. Most vertices have none, and keep their bits: targets move patches, so the branch is
/// cheaper than normalising.
glm::vec3 moved(const glm::vec3& base, const glm::vec3& displacement, bool normalise) noexcept {
  if (displacement == glm::vec3(0.0f)) return base;
  const glm::vec3 sum = base + displacement;
  return normalise ? normalised_or(sum, base) : sum;
}

void morph_normals(const MorphVerticesJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  const bool any = sum_deltas(job, &MorphTarget::normals);
  for (std::size_t v = 0; v < count; ++v) {
    const glm::vec3 base = job.vertices.normals[v];
    job.out.normals[v] = any ? moved(base, job.scratch[v], job.normalise) : base;
  }
}

void morph_tangents(const MorphVerticesJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  const bool any = sum_deltas(job, &MorphTarget::tangents);
  for (std::size_t v = 0; v < count; ++v) {
    const glm::vec4 base = job.vertices.tangents[v];
    const glm::vec3 t(base);
    job.out.tangents[v] = glm::vec4(any ? moved(t, job.scratch[v], job.normalise) : t, base.w);
  }
}

}  // namespace

ErrorCode check(const MorphVerticesJob& job) noexcept {
  if (!job.morphs || job.weights.size() < job.morphs->targets.size()) return ErrorCode::size_mismatch;
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  const std::size_t count = job.vertices.positions.size();
  if (job.scratch.size() < count) return ErrorCode::size_mismatch;
  for (const float weight : job.weights)
    if (!std::isfinite(weight)) return ErrorCode::not_finite;
  for (const auto& target : job.morphs->targets)
    if (!in_range(target.positions, count) || !in_range(target.normals, count) || !in_range(target.tangents, count))
      return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

void run(const MorphVerticesJob& job) noexcept {
  const std::size_t count = job.vertices.positions.size();
  const bool any = sum_deltas(job, &MorphTarget::positions);
  for (std::size_t v = 0; v < count; ++v)
    job.out.positions[v] = any ? job.vertices.positions[v] + job.scratch[v] : job.vertices.positions[v];
  const auto wanted = present(job.vertices, job.out);
  if (wanted.normals) morph_normals(job);
  if (wanted.tangents) morph_tangents(job);
}

}  // namespace sinew
