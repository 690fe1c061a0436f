// SPDX-License-Identifier: MIT
#include "runtime/jobs/sample_clip.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/assets/clip_layout.h"

namespace sinew {
namespace {

static_assert(first_plane(Property::translation) == PoseSpan::tx && first_plane(Property::rotation) == PoseSpan::rx &&
              first_plane(Property::scale) == PoseSpan::sx && PoseSpan::plane_count == 10);

constexpr std::size_t kChunk = 64;  ///< lanes worked on at once, so that intermediate values stay on the stack

/// Where the values of a block go.
struct Output {
  float* first_plane;
  std::size_t plane_stride;
  const std::uint32_t* targets;
};

Output output_of(const TrackBlock& block, const SampleClipJob& job) noexcept {
  if (block.property == Property::weight) return {job.weights.data(), 0, block.targets.data()};
  return {job.pose.planes + first_plane(block.property) * job.pose.stride, job.pose.stride, block.targets.data()};
}

std::size_t component_count(Property property) noexcept {
  return property == Property::weight ? 1 : property == Property::rotation ? 4 : 3;
}

void scatter(const Output& out, std::size_t component, std::size_t first, std::size_t count, const float* values) noexcept {
  float* plane = out.first_plane + component * out.plane_stride;
  for (std::size_t i = 0; i < count; ++i) plane[out.targets[first + i]] = values[i];
}

/// The stored values of a key, bit for bit (G06).
void copy_key(const TrackBlock& block, std::size_t key, const Output& out) noexcept {
  for (std::size_t c = 0; c < component_count(block.property); ++c)
    scatter(out, c, 0, block.lane_count, block.plane(key, block.value_plane + c));
}

/// Everything that all tracks of a group share at one time: fractions and Hermite weights, from double (N24).
struct Between {
  std::size_t key;
  float s, r;                        ///< fraction of the interval, and 1 - s
  float value0, out0, value1, in1;   ///< weights of the Hermite form, tangent weights times the interval

  explicit Between(const KeyPosition& at) noexcept
      : key(at.key), s(static_cast<float>(at.fraction)), r(static_cast<float>(1.0 - at.fraction)) {
    const double t = at.fraction, u = 1.0 - t;
    value0 = static_cast<float>((1.0 + 2.0 * t) * (u * u));
    out0 = static_cast<float>(at.interval_s * (t * (u * u)));
    value1 = static_cast<float>(t * t * (3.0 - 2.0 * t));
    in1 = static_cast<float>(-at.interval_s * (t * t * u));
  }
};

/// eq   (1 - s) v0 + s v1
void lerp_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  float values[kChunk];
  for (std::size_t c = 0; c < component_count(block.property); ++c)
    for (std::size_t first = 0; first < block.lane_count; first += kChunk) {
      const std::size_t count = std::min<std::size_t>(kChunk, block.lane_count - first);
      const float *v0 = block.plane(at.key, c) + first, *v1 = block.plane(at.key + 1, c) + first;
      for (std::size_t i = 0; i < count; ++i) values[i] = v0[i] * at.r + v1[i] * at.s;
      scatter(out, c, first, count, values);
    }
}

/// One component of the Hermite form for `count` lanes.
void hermite_lanes(const TrackBlock& block, const Between& at, std::size_t component, std::size_t first, std::size_t count,
                   float* values) noexcept {
  const std::size_t components = block.value_plane;
  const float* v0 = block.plane(at.key, components + component) + first;
  const float* out0 = block.plane(at.key, 2 * components + component) + first;
  const float* in1 = block.plane(at.key + 1, component) + first;
  const float* v1 = block.plane(at.key + 1, components + component) + first;
  for (std::size_t i = 0; i < count; ++i)
    values[i] = (v0[i] * at.value0 + out0[i] * at.out0) + (v1[i] * at.value1 + in1[i] * at.in1);
}

void hermite_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  float values[kChunk];
  for (std::size_t c = 0; c < component_count(block.property); ++c)
    for (std::size_t first = 0; first < block.lane_count; first += kChunk) {
      const std::size_t count = std::min<std::size_t>(kChunk, block.lane_count - first);
      hermite_lanes(block, at, c, first, count, values);
      scatter(out, c, first, count, values);
    }
}

/// eq   sin x for 0 <= |x| <= pi / 2: odd polynomial of degree 9, least largest relative error 5.4e-9 (Remez)
float sine(float x) noexcept {
  const float z = x * x;
  return x * (0.999999994686f + z * (-0.16666656684f + z * (0.00833302513895f + z * (-0.000198074187248f + z * 2.60190306065e-6f))));
}

/// Rotations of a chunk of lanes.
struct QuatLanes {
  float x[kChunk], y[kChunk], z[kChunk], w[kChunk];
};

void scatter(const Output& out, std::size_t first, std::size_t count, const QuatLanes& q) noexcept {
  scatter(out, 0, first, count, q.x), scatter(out, 1, first, count, q.y);
  scatter(out, 2, first, count, q.z), scatter(out, 3, first, count, q.w);
}

/// eq   slerp: normalise(q0 sin(r a) + q1 sin(s a)); a is the stored arc, whose sign turns q1 to the short side (G01)
void slerp_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  QuatLanes q;
  for (std::size_t first = 0; first < block.lane_count; first += kChunk) {
    const std::size_t count = std::min<std::size_t>(kChunk, block.lane_count - first);
    const auto plane = [&](std::size_t key, std::size_t p) { return block.plane(key, p) + first; };
    const float *x0 = plane(at.key, 0), *y0 = plane(at.key, 1), *z0 = plane(at.key, 2), *w0 = plane(at.key, 3);
    const float *x1 = plane(at.key + 1, 0), *y1 = plane(at.key + 1, 1), *z1 = plane(at.key + 1, 2), *w1 = plane(at.key + 1, 3);
    const float* arc = plane(at.key, 4);
    for (std::size_t i = 0; i < count; ++i) {
      const float a0 = sine(at.r * std::abs(arc[i])), a1 = sine(at.s * arc[i]);
      const float x = x0[i] * a0 + x1[i] * a1, y = y0[i] * a0 + y1[i] * a1;
      const float z = z0[i] * a0 + z1[i] * a1, w = w0[i] * a0 + w1[i] * a1;
      const float scale = 1.0f / std::sqrt((x * x + y * y) + (z * z + w * w));
      q.x[i] = x * scale, q.y[i] = y * scale, q.z[i] = z * scale, q.w[i] = w * scale;
    }
    scatter(out, first, count, q);
  }
}

/// eq   Hermite form of four components, then normalised without sign flip (G04, G05); a sum without direction falls back to
///      the nearer key
void hermite_rotation_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  QuatLanes q;
  for (std::size_t first = 0; first < block.lane_count; first += kChunk) {
    const std::size_t count = std::min<std::size_t>(kChunk, block.lane_count - first);
    float* const components[] = {q.x, q.y, q.z, q.w};
    for (std::size_t c = 0; c < 4; ++c) hermite_lanes(block, at, c, first, count, components[c]);
    const std::size_t nearer = at.s < 0.5f ? at.key : at.key + 1;
    for (std::size_t i = 0; i < count; ++i) {
      const auto key = [&](std::size_t c) { return block.plane(nearer, 4 + c)[first + i]; };
      const glm::quat unit = normalised_or(quat_xyzw(q.x[i], q.y[i], q.z[i], q.w[i]), quat_xyzw(key(0), key(1), key(2), key(3)));
      q.x[i] = unit.x, q.y[i] = unit.y, q.z[i] = unit.z, q.w[i] = unit.w;
    }
    scatter(out, first, count, q);
  }
}

/// eq   Shoemake 1987; corners and signs were decided when the clip was compiled
void squad_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  QuatLanes q;
  for (std::size_t first = 0; first < block.lane_count; first += kChunk) {
    const std::size_t count = std::min<std::size_t>(kChunk, block.lane_count - first);
    for (std::size_t i = 0; i < count; ++i) {
      const auto corner = [&](std::size_t key, std::size_t p) {
        const auto at_plane = [&](std::size_t c) { return block.plane(key, p + c)[first + i]; };
        return quat_xyzw(at_plane(0), at_plane(1), at_plane(2), at_plane(3));
      };
      const float sign = block.plane(at.key, 12)[first + i];
      const glm::quat begin = normalised(corner(at.key, 0)), end = normalised(corner(at.key + 1, 0)) * sign;
      const glm::quat unit = squad(begin, corner(at.key, 4), corner(at.key, 8), end, at.s);
      q.x[i] = unit.x, q.y[i] = unit.y, q.z[i] = unit.z, q.w[i] = unit.w;
    }
    scatter(out, first, count, q);
  }
}

void sample_block(const TrackBlock& block, const Between& at, const Output& out) noexcept {
  const bool rotation = block.property == Property::rotation;
  switch (block.interpolation) {
    case Interpolation::step: copy_key(block, at.key, out); break;
    case Interpolation::linear: rotation ? slerp_block(block, at, out) : lerp_block(block, at, out); break;
    case Interpolation::cubic_spline: rotation ? hermite_rotation_block(block, at, out) : hermite_block(block, at, out); break;
    case Interpolation::squad: squad_block(block, at, out); break;
  }
}

}  // namespace

ErrorCode check(const SampleClipJob& job) noexcept {
  if (job.clip == nullptr) return ErrorCode::size_mismatch;
  const std::size_t joints = job.clip->joint_count();
  if (job.pose.joint_count != joints || job.pose.stride != PoseSpan::stride_for(joints)) return ErrorCode::size_mismatch;
  if (joints > 0 && job.pose.planes == nullptr) return ErrorCode::size_mismatch;
  const bool weights_fit = job.weights.empty() || job.weights.size() == job.clip->weight_count();
  return weights_fit ? ErrorCode::ok : ErrorCode::size_mismatch;
}

void run(const SampleClipJob& job) noexcept {
  const ClipLayout& clip = job.clip->layout();
  std::copy(clip.base_pose.planes.begin(), clip.base_pose.planes.end(), job.pose.planes);
  if (!job.weights.empty()) std::copy(clip.base_weights.begin(), clip.base_weights.end(), job.weights.begin());
  for (const TimeGroup& group : clip.groups) {
    const KeyPosition position = group.times.locate(job.time_s);
    const Between at(position);
    for (const TrackBlock& block : group.blocks) {
      if (block.property == Property::weight && job.weights.empty()) continue;
      const Output out = output_of(block, job);
      if (position.on_key) copy_key(block, position.key, out);
      else sample_block(block, at, out);
    }
  }
}

}  // namespace sinew
