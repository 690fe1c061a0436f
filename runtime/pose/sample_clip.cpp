// SPDX-License-Identifier: MIT
#include "runtime/pose/sample_clip.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/pose/sample_clip.cpp"
#include <hwy/foreach_target.h>

#include "runtime/pose/simd/dispatch.h"
#include "runtime/pose/simd/packed_lanes-inl.h"

namespace sinew {
namespace {

/// eq   Shoemake 1987; corners and signs were decided when the clip was compiled. Not in lanes: arcs between arcs need
/// an
///      arc tangent, and squad is asked for by hand only.
void squad_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) noexcept;

}  // namespace
}  // namespace sinew

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {

TrackOutput output_of(const TrackBlock& block, const SampleClipJob& job) {
  if (block.property == Property::weight) return {job.weights.data(), 0};
  if (block.property == Property::number) return {job.properties.data(), 0};
  return {job.pose.planes + first_plane(block.property) * job.pose.stride, job.pose.stride};
}

bool wanted(const TrackBlock& block, const SampleClipJob& job) {
  if (block.property == Property::weight) return !job.weights.empty();
  if (block.property == Property::number) return !job.properties.empty();
  return true;
}

void sample_packed(const TrackBlock& block, const KeyPosition& position, const BetweenKeys& at,
                   const TrackOutput& out) {
  const bool on_key = position.on_key || block.interpolation == Interpolation::step;
  const PackedRows& rows = block.packed;
  const std::uint8_t* begin = rows.bits.data() + at.key * rows.row_bytes;
  const std::size_t power = rows.power.empty() ? 0 : rows.power_at(at.key);
  const PackedKeys keys{begin, on_key ? begin : begin + rows.row_bytes, on_key ? 0.0f : at.s, on_key ? 1.0f : at.r,
                        power};
  if (block.property == Property::rotation)
    slerp_packed(block, keys, out);
  else
    lerp_packed(block, keys, out);
}

void sample_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const bool rotation = block.property == Property::rotation;
  switch (block.interpolation) {
    case Interpolation::step: copy_key(block, at.key, out); break;
    case Interpolation::linear:
      if (rotation)
        slerp_block(block, at, out);
      else
        lerp_block(block, at, out);
      break;
    case Interpolation::cubic_spline:
      if (rotation)
        hermite_rotation_block(block, at, out);
      else
        hermite_block(block, at, out);
      break;
    case Interpolation::squad: squad_block(block, at, out); break;
  }
}

void sample_clip(const SampleClipJob& job) {
  const ClipLayout& clip = job.clip->layout();
  if (!job.holds_clip) clip.base_pose.copy_to(job.pose.planes);
  if (!job.weights.empty()) clip.base_weights.copy_to(job.weights.data());
  if (!job.properties.empty()) clip.base_properties.copy_to(job.properties.data());
  for (const TimeGroup& group : clip.groups) {
    const KeyPosition position = group.times.locate(job.time_s);
    const BetweenKeys at(position);
    for (const TrackBlock& block : group.blocks) {
      if (!wanted(block, job)) continue;
      const TrackOutput out = output_of(block, job);
      if (!block.packed.empty())
        sample_packed(block, position, at, out);
      else if (position.on_key)
        copy_key(block, position.key, out);
      else
        sample_block(block, at, out);
    }
  }
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

static_assert(first_plane(Property::translation) == PoseSpan::tx && first_plane(Property::rotation) == PoseSpan::rx &&
              first_plane(Property::scale) == PoseSpan::sx && PoseSpan::plane_count == 10);

void squad_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) noexcept {
  for (std::size_t i = 0; i < block.lane_count; ++i) {
    const auto corner = [&](std::size_t key, std::size_t plane) {
      const auto component = [&](std::size_t c) { return block.plane(key, plane + c)[i]; };
      return quat_xyzw(component(0), component(1), component(2), component(3));
    };
    const float sign = block.plane(at.key, 12)[i];
    const glm::quat begin = normalised(corner(at.key, 0)), end = normalised(corner(at.key + 1, 0)) * sign;
    const glm::quat unit = squad(begin, corner(at.key, 4), corner(at.key, 8), end, at.s);
    const std::uint32_t joint = block.targets[i];
    out.plane(0)[joint] = unit.x;
    out.plane(1)[joint] = unit.y;
    out.plane(2)[joint] = unit.z;
    out.plane(3)[joint] = unit.w;
  }
}

}  // namespace

ErrorCode check(const SampleClipJob& job) noexcept {
  if (job.clip == nullptr) return ErrorCode::size_mismatch;
  if (!is_pose_of(job.pose, job.clip->joint_count())) return ErrorCode::size_mismatch;
  const auto fits = [](std::span<float> numbers, std::size_t count) {
    return numbers.empty() || (numbers.size() == count && have_memory(numbers));
  };
  const bool numbers_fit =
      fits(job.weights, job.clip->weight_count()) && fits(job.properties, job.clip->property_count());
  return numbers_fit ? ErrorCode::ok : ErrorCode::size_mismatch;
}

SINEW_DISPATCH_RUN(SampleClipJob, sample_clip)

}  // namespace sinew
#endif  // HWY_ONCE
