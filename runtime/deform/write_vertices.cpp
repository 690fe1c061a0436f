// SPDX-License-Identifier: MIT
#include "runtime/deform/write_vertices.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

namespace sinew {
namespace {

constexpr float kLargestOfDirection = 32767.0f, kLargestOfPosition = 65535.0f;

// Without branches, which random vertices would mispredict.

/// The nearest integer of `unit * largest`. NaN gives the smallest.
std::uint16_t quantized_position(float unit) noexcept {
  const float inside = std::min(std::max(0.0f, unit), 1.0f);
  return static_cast<std::uint16_t>(static_cast<int>(inside * kLargestOfPosition + 0.5f));
}
std::int16_t quantized_direction(float unit) noexcept {
  const float inside = std::min(std::max(-1.0f, unit), 1.0f);
  return static_cast<std::int16_t>(static_cast<int>(inside * kLargestOfDirection + std::copysign(0.5f, inside)));
}

/// A direction of any length, projected to the octahedron |x| + |y| + |z| = 1, whose lower half is folded outwards.
glm::vec2 octahedral(const glm::vec3& direction) noexcept {
  const float length = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z),
              scale = length > 0.0f ? 1.0f / length : 0.0f, x = direction.x * scale, y = direction.y * scale,
              folded_x = std::copysign(1.0f - std::abs(y), x), folded_y = std::copysign(1.0f - std::abs(x), y);
  const bool is_lower = direction.z < 0.0f;
  return {is_lower ? folded_x : x, is_lower ? folded_y : y};
}

std::array<std::int16_t, 2> quantized_octahedral(const glm::vec3& direction) noexcept {
  const glm::vec2 o = octahedral(direction);
  return {quantized_direction(o.x), quantized_direction(o.y)};
}

template <class From, class To>
bool fits_in(std::span<const From> from, const StridedSpan<To>& to) noexcept {
  return from.empty() || to.empty() ||
         (from.data() != nullptr && to.first != nullptr && to.count >= from.size() && to.stride >= sizeof(To));
}

template <class Output>
ErrorCode check_output(const VertexInput& in, const Output& out) noexcept {
  const bool is_ok =
      fits_in(in.positions, out.positions) && fits_in(in.normals, out.normals) && fits_in(in.tangents, out.tangents);
  return is_ok ? ErrorCode::ok : ErrorCode::size_mismatch;
}

template <class From, class To, class Convert>
void convert_all(std::span<const From> from, const StridedSpan<To>& to, const Convert& convert) noexcept {
  if (to.empty()) return;
  for (std::size_t i = 0; i < from.size(); ++i) to.store(i, convert(from[i]));
}

}  // namespace

ErrorCode check(const WriteVerticesJob& job) noexcept { return check_output(job.vertices, job.out); }

void run_unchecked(const WriteVerticesJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const auto same = [](const auto& v) { return v; };
  convert_all(job.vertices.positions, job.out.positions, same);
  convert_all(job.vertices.normals, job.out.normals, same);
  convert_all(job.vertices.tangents, job.out.tangents, same);
}

ErrorCode check(const QuantizeVerticesJob& job) noexcept {
  if (!job.out.positions.empty())
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(job.box.upper[c] - job.box.lower[c]) || !(job.box.lower[c] <= job.box.upper[c]))
        return ErrorCode::not_finite;
  return check_output(job.vertices, job.out);
}

void run_unchecked(const QuantizeVerticesJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  glm::vec3 per_unit;
  for (int c = 0; c < 3; ++c) {
    const float side = job.box.upper[c] - job.box.lower[c];
    per_unit[c] = side > 0.0f ? 1.0f / side : 0.0f;
  }
  convert_all(job.vertices.positions, job.out.positions, [&](const glm::vec3& p) {
    std::array<std::uint16_t, 3> quantized;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto axis = static_cast<int>(c);
      quantized[c] = quantized_position((p[axis] - job.box.lower[axis]) * per_unit[axis]);
    }
    return quantized;
  });
  convert_all(job.vertices.normals, job.out.normals, quantized_octahedral);
  convert_all(job.vertices.tangents, job.out.tangents, [](const glm::vec4& t) {
    const auto [x, y] = quantized_octahedral(glm::vec3(t));
    return std::array<std::int16_t, 3>{x, y, static_cast<std::int16_t>(t.w < 0.0f ? -32767 : 32767)};
  });
}

}  // namespace sinew
