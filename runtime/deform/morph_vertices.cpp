// SPDX-License-Identifier: MIT
#include "runtime/deform/morph_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/morph_vertices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/deform/sparse_range.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

// Multiplications and additions are never fused, so all targets give the same sums.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

/// Vertices are summed and finished in chunks of this size, so that their sums stay in the first-level cache.
constexpr std::size_t kChunk = 1024;

/// Number of sparse entries that one test checks for consecutive vertices.
constexpr std::size_t kRun = 16;

/// eq   sums += weight * deltas, `count` floats
HWY_INLINE void add_products(const float* deltas, Lanes weight, std::size_t count, float* sums) {
  const Floats d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    hn::StoreU(hn::Add(hn::LoadU(d, sums + i), hn::Mul(hn::LoadU(d, deltas + i), weight)), d, sums + i);
}

/// Adds the displacements of one target to the sums of the vertices from `first` on. Targets move patches, so entries
/// are mostly consecutive: sixteen consecutive entries are added as one run of floats.
HWY_INLINE void add_deltas(const SparseDeltas<glm::vec3>& sparse, SparseRange range, float weight, std::size_t first,
                           glm::vec3* sums) {
  const std::uint32_t* vertices = sparse.vertices.data();
  const Lanes weights = hn::Set(Floats(), weight);
  std::size_t i = range.begin;
  for (; i + kRun <= range.end; i += kRun) {
    if (vertices[i + kRun - 1] - vertices[i] == kRun - 1)
      add_products(&sparse.deltas[i].x, weights, 3 * kRun, &sums[vertices[i] - first].x);
    else
      for (std::size_t k = i; k < i + kRun; ++k) sums[vertices[k] - first] += weight * sparse.deltas[k];
  }
  for (; i < range.end; ++i) sums[vertices[i] - first] += weight * sparse.deltas[i];
}

/// eq   out = base + sums
HWY_INLINE void add_base(const float* base, const float* sums, std::size_t count, float* out) {
  const Floats d;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d))
    hn::StoreU(hn::Add(hn::LoadU(d, base + i), hn::LoadU(d, sums + i)), d, out + i);
  for (; i < count; ++i) out[i] = base[i] + sums[i];
}

/// Adds displacements to the normals or tangents of one vector of vertices, in place. Vertices without displacement
/// keep their bits.
HWY_INLINE void move_directions(const Lanes (&sum)[3], Lanes (&direction)[3], bool normalise,
                                hn::Mask<Floats>& careful) {
  const Floats d;
  const Lanes zero = hn::Zero(d);
  const auto still = hn::And(hn::Eq(sum[0], zero), hn::And(hn::Eq(sum[1], zero), hn::Eq(sum[2], zero)));
  const Lanes x = hn::Add(direction[0], sum[0]), y = hn::Add(direction[1], sum[1]), z = hn::Add(direction[2], sum[2]);
  Lanes scale = hn::Set(d, 1.0f);
  if (normalise) {
    const Lanes squared = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    const auto sound = hn::And(hn::Gt(squared, hn::Set(d, 1e-30f)), hn::Lt(squared, hn::Set(d, 1e30f)));
    careful = hn::AndNot(hn::Or(sound, still), hn::Eq(zero, zero));
    scale = hn::Div(scale, hn::Sqrt(squared));
  }
  direction[0] = hn::IfThenElse(still, direction[0], hn::Mul(x, scale));
  direction[1] = hn::IfThenElse(still, direction[1], hn::Mul(y, scale));
  direction[2] = hn::IfThenElse(still, direction[2], hn::Mul(z, scale));
}

/// Loads, moves and stores one vector of vertices. Directions that vanish, or leave the range in which float keeps its
/// digits, are computed again vertex by vertex.
template <class V>
HWY_INLINE void move_vector(const V* base, const glm::vec3* sums, bool normalise, V* out) {
  const Floats d;
  Lanes sum[3], direction[3], handedness;
  hn::LoadInterleaved3(d, &sums->x, sum[0], sum[1], sum[2]);
  if constexpr (sizeof(V) == sizeof(glm::vec4))
    hn::LoadInterleaved4(d, &base->x, direction[0], direction[1], direction[2], handedness);
  else
    hn::LoadInterleaved3(d, &base->x, direction[0], direction[1], direction[2]);
  auto careful = hn::Lt(hn::Zero(d), hn::Zero(d));
  move_directions(sum, direction, normalise, careful);
  if constexpr (sizeof(V) == sizeof(glm::vec4))
    hn::StoreInterleaved4(direction[0], direction[1], direction[2], handedness, d, &out->x);
  else
    hn::StoreInterleaved3(direction[0], direction[1], direction[2], d, &out->x);
  if (HWY_LIKELY(hn::AllFalse(d, careful))) return;
  HWY_ALIGN float flags[kRun];
  hn::Store(hn::IfThenElseZero(careful, hn::Set(d, 1.0f)), d, flags);
  for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
    if (flags[k] == 0.0f) continue;
    const glm::vec3 unit = normalised_or(glm::vec3(base[k]) + sums[k], glm::vec3(base[k]));
    out[k].x = unit.x;
    out[k].y = unit.y;
    out[k].z = unit.z;
  }
}

template <class V>
HWY_INLINE void move_all(const V* base, const glm::vec3* sums, std::size_t count, bool normalise, V* out) {
  const std::size_t lanes = hn::Lanes(Floats());
  std::size_t v = 0;
  for (; v + lanes <= count; v += lanes) move_vector(base + v, sums + v, normalise, out + v);
  if (v == count) return;
  V rest[kRun] = {}, moved[kRun];
  glm::vec3 rest_sums[kRun] = {};
  std::copy_n(base + v, count - v, rest);
  std::copy_n(sums + v, count - v, rest_sums);
  move_vector(rest, rest_sums, normalise, moved);
  std::copy_n(moved, count - v, out + v);
}

/// Sums the displacements of one attribute chunk by chunk and calls `finish(first, count)` for each chunk. Returns
/// false, with nothing done, if no active target moves the attribute.
template <class Finish>
bool for_each_chunk(const MorphVerticesJob& job, SparseDeltas<glm::vec3> MorphTarget::*attribute,
                    const Finish& finish) {
  const auto& targets = job.morphs->targets;
  const auto moves = [&](std::size_t t) {
    return !(targets[t].*attribute).empty() && is_active_weight(job.weights[t]);
  };
  bool any = false;
  for (std::size_t t = 0; t < targets.size(); ++t) any |= moves(t);
  if (!any) return false;
  const std::size_t vertices = job.vertices.positions.size();
  for (std::size_t first = 0; first < vertices; first += kChunk) {
    const std::size_t count = std::min(kChunk, vertices - first);
    std::fill_n(job.scratch.begin(), count, glm::vec3(0.0f));
    for (std::size_t t = 0; t < targets.size(); ++t)
      if (moves(t))
        add_deltas(targets[t].*attribute, sparse_range((targets[t].*attribute).vertices, first, count), job.weights[t],
                   first, job.scratch.data());
    finish(first, count);
  }
  return true;
}

void morph_vertices(const MorphVerticesJob& job) {
  const VertexInput& in = job.vertices;
  const VertexOutput& out = job.out;
  const glm::vec3* sums = job.scratch.data();
  const auto positions = [&](std::size_t v, std::size_t count)
                             HWY_ATTR { add_base(&in.positions[v].x, &sums->x, 3 * count, &out.positions[v].x); };
  const auto normals = [&](std::size_t v, std::size_t count)
                           HWY_ATTR { move_all(&in.normals[v], sums, count, job.normalise, &out.normals[v]); };
  const auto tangents = [&](std::size_t v, std::size_t count)
                            HWY_ATTR { move_all(&in.tangents[v], sums, count, job.normalise, &out.tangents[v]); };
  const auto wanted = present(in, out);
  if (!for_each_chunk(job, &MorphTarget::positions, positions))
    std::copy(in.positions.begin(), in.positions.end(), out.positions.begin());
  if (wanted.normals && !for_each_chunk(job, &MorphTarget::normals, normals))
    std::copy(in.normals.begin(), in.normals.end(), out.normals.begin());
  if (wanted.tangents && !for_each_chunk(job, &MorphTarget::tangents, tangents))
    std::copy(in.tangents.begin(), in.tangents.end(), out.tangents.begin());
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

bool in_range(const SparseDeltas<glm::vec3>& deltas, std::size_t vertex_count) noexcept {
  // vertices strictly increase, so the last one is the largest
  return deltas.vertices.size() == deltas.deltas.size() && (deltas.empty() || deltas.vertices.back() < vertex_count);
}

}  // namespace

ErrorCode check(const MorphVerticesJob& job) noexcept {
  if (!job.morphs || job.weights.size() < job.morphs->targets.size()) return ErrorCode::size_mismatch;
  if (const auto error = check_streams(job.vertices, job.out); error != ErrorCode::ok) return error;
  const std::size_t count = job.vertices.positions.size();
  if (job.scratch.size() < count || !have_memory(job.scratch, job.weights)) return ErrorCode::size_mismatch;
  for (const float weight : job.weights)
    if (!std::isfinite(weight)) return ErrorCode::not_finite;
  for (const auto& target : job.morphs->targets)
    if (!in_range(target.positions, count) || !in_range(target.normals, count) || !in_range(target.tangents, count))
      return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

SINEW_DISPATCH_RUN(MorphVerticesJob, morph_vertices)

void morph_colors(const MorphSet& morphs, std::span<const float> weights, std::span<const glm::vec4> colors,
                  std::span<glm::vec4> out) noexcept {
  std::fill(out.begin(), out.end(), glm::vec4(0.0f));
  for (std::size_t t = 0; t < morphs.targets.size(); ++t) {
    if (!is_active_weight(weights[t])) continue;
    const SparseDeltas<glm::vec4>& moved = morphs.targets[t].colors;
    for (std::size_t i = 0; i < moved.vertices.size(); ++i) out[moved.vertices[i]] += weights[t] * moved.deltas[i];
  }
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = glm::clamp(colors[v] + out[v], 0.0f, 1.0f);
}

}  // namespace sinew
#endif
