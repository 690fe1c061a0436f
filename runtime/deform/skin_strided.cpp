// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_strided.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>

#include "runtime/deform/vertex_checks.h"

namespace sinew {
namespace {

/// Vertices of a block. Their input and output fit into the first-level cache.
constexpr std::uint32_t kBlockVertices = 256;

/// The attributes of a block, packed.
struct PackedBlock {
  glm::vec3 positions[kBlockVertices], normals[kBlockVertices];
  glm::vec4 tangents[kBlockVertices];
};

/// The elements as an array: their own memory if they are packed, or else `copy`.
template <class V>
std::span<const V> packed_elements(const StridedSpan<const V>& from, V* copy) noexcept {
  if (from.stride == sizeof(V) && reinterpret_cast<std::uintptr_t>(from.first) % alignof(V) == 0)
    return {reinterpret_cast<const V*>(from.first), from.count};
  for (std::size_t i = 0; i < from.count; ++i) copy[i] = from.load(i);
  return {copy, from.count};
}

template <class V>
void store_elements(const V* from, const StridedSpan<V>& to) noexcept {
  for (std::size_t i = 0; i < to.count; ++i) to.store(i, from[i]);
}

template <class T>
bool is_sound(const StridedSpan<T>& span) noexcept {
  return span.empty() || (span.first != nullptr && span.stride >= sizeof(T));
}

template <class Job>
constexpr bool kHasTiles = requires(const Job& job) {
  job.tiles;
};
template <class Job>
constexpr bool kHasCenters = requires(const Job& job) {
  job.centers;
};

/// The influences of `count` consecutive vertices of a group, as a group of their own.
InfluenceStreams influences_of_block(const InfluenceStreams& all, const InfluenceGroup& group, std::uint32_t first,
                                     const InfluenceGroup& block) noexcept {
  const std::size_t from = group.first_influence + std::size_t{first} * group.influence_count,
                    count = std::size_t{block.vertex_count} * block.influence_count;
  InfluenceStreams influences;
  influences.groups = {&block, 1};
  std::visit([&](auto joints) { influences.joints = joints.subspan(from, count); }, all.joints);
  std::visit([&](auto weights) { influences.weights = weights.subspan(from, count); }, all.weights);
  return influences;
}

template <class Job>
void skin_block(Job& job, const StridedInput& in, const StridedOutput& out) noexcept {
  PackedBlock from, to;
  const std::size_t count = in.positions.count;
  job.vertices = {packed_elements(in.positions, from.positions), packed_elements(in.normals, from.normals),
                  packed_elements(in.tangents, from.tangents)};
  job.out.positions = {to.positions, count};
  if (!out.normals.empty()) job.out.normals = {to.normals, count};
  if (!out.tangents.empty()) job.out.tangents = {to.tangents, count};
  run_unchecked(job);
  store_elements(to.positions, out.positions);
  if (!in.normals.empty()) store_elements(to.normals, out.normals);
  if (!in.tangents.empty()) store_elements(to.tangents, out.tangents);
}

template <class Job>
void skin_strided(const StridedSkinJob<Job>& strided) noexcept {
  assert(check(strided) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const StridedInput& in = strided.vertices;
  const StridedOutput& out = strided.out;
  for (const InfluenceGroup& group : strided.skin.influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; v += kBlockVertices) {
      const InfluenceGroup block{0, std::min(kBlockVertices, group.vertex_count - v), group.influence_count, 0};
      const std::size_t first = group.first_vertex + std::size_t{v}, count = block.vertex_count;
      Job job = strided.skin;
      job.influences = influences_of_block(strided.skin.influences, group, v, block);
      if constexpr (kHasCenters<Job>) job.centers = job.centers.subspan(first, count);
      skin_block<Job>(
          job, {in.positions.part(first, count), in.normals.part(first, count), in.tangents.part(first, count)},
          {out.positions.part(first, count), out.normals.part(first, count), out.tangents.part(first, count)});
    }
}

ErrorCode check_strides(const StridedInput& in, const StridedOutput& out) noexcept {
  const std::size_t count = in.positions.count;
  const auto fits = [count](std::size_t input, std::size_t output) {
    return input == 0 || output == 0 || (input == count && output >= count);
  };
  const bool is_ok = is_sound(in.positions) && is_sound(in.normals) && is_sound(in.tangents) &&
                     is_sound(out.positions) && is_sound(out.normals) && is_sound(out.tangents) &&
                     out.positions.count >= count && fits(in.normals.count, out.normals.count) &&
                     fits(in.tangents.count, out.tangents.count);
  return is_ok ? ErrorCode::ok : ErrorCode::size_mismatch;
}

template <class Job>
ErrorCode check_strided(const StridedSkinJob<Job>& strided) noexcept {
  Job job = strided.skin;
  const auto are_empty = [](const auto& v) { return v.positions.empty() && v.normals.empty() && v.tangents.empty(); };
  if (!are_empty(job.vertices) || !are_empty(job.out)) return ErrorCode::unsupported;
  if constexpr (kHasTiles<Job>)
    if (job.tiles != nullptr) return ErrorCode::unsupported;
  if (const ErrorCode error = check_strides(strided.vertices, strided.out); error != ErrorCode::ok) return error;
  const std::size_t count = strided.vertices.positions.count;
  constexpr std::size_t kAnyJoint = std::numeric_limits<std::size_t>::max();
  if (const ErrorCode error = check_influences(job.influences, count, kAnyJoint); error != ErrorCode::ok) return error;
  if constexpr (kHasCenters<Job>) {
    if (job.centers.size() != count || !have_memory(job.centers)) return ErrorCode::size_mismatch;
    job.centers = {};
  }
  job.influences.groups = {};
  return check(job);
}

}  // namespace

ErrorCode check(const StridedSkinJob<SkinLinearJob>& job) noexcept { return check_strided(job); }
ErrorCode check(const StridedSkinJob<SkinDualQuaternionJob>& job) noexcept { return check_strided(job); }
ErrorCode check(const StridedSkinJob<SkinCenterOfRotationJob>& job) noexcept { return check_strided(job); }
void run_unchecked(const StridedSkinJob<SkinLinearJob>& job) noexcept { skin_strided(job); }
void run_unchecked(const StridedSkinJob<SkinDualQuaternionJob>& job) noexcept { skin_strided(job); }
void run_unchecked(const StridedSkinJob<SkinCenterOfRotationJob>& job) noexcept { skin_strided(job); }

}  // namespace sinew
