// SPDX-License-Identifier: MIT
#include "runtime/clip/decompile_clip.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "runtime/animation/track_sample.h"
#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/move_lanes.h"

namespace sinew {
namespace {

/// Number of parts of a key: 3 with tangents (in-tangent, value, out-tangent), else 1.
std::size_t parts_of(Interpolation interpolation) noexcept {
  return interpolation == Interpolation::cubic_spline ? 3 : 1;
}

std::size_t components_of(Property property) noexcept {
  return property == Property::rotation ? 4 : property < Property::weight ? 3 : 1;
}

/// Reads a value whose components are `stride` numbers apart.
void read_value(const float* first, std::size_t stride, glm::vec3& out) {
  out = {first[0], first[stride], first[2 * stride]};
}

void read_value(const float* first, std::size_t stride, glm::quat& out) {
  out = quat_xyzw(first[0], first[stride], first[2 * stride], first[3 * stride]);
}

void read_value(const PackedTrack& packed, std::size_t key, glm::vec3& out) {
  const std::array<float, 4> v = unpack_key(packed, key);
  out = {v[0], v[1], v[2]};
}

void read_value(const PackedTrack& packed, std::size_t key, glm::quat& out) { out = unpack_rotation(packed, key); }

/// The track of one lane of a block with a single key. It is a step track, since tangents have no effect.
template <class V>
Track<V> key_of(const TrackBlock& block, float time_s, std::size_t lane) {
  Track<V> track{Interpolation::step, {time_s}, {V{}}};
  if (block.packed.empty())
    read_value(block.plane(0, block.value_plane) + lane, block.lane_count, track.values[0]);
  else
    read_value(packed_lane(block.packed, block.lane_count, lane, 1), 0, track.values[0]);
  return track;
}

/// The track of one lane of a block.
template <class V>
Track<V> track_of(const TrackBlock& block, std::span<const float> times_s, std::size_t lane) {
  const std::size_t parts = parts_of(block.interpolation), components = components_of(block.property);
  if (times_s.size() == 1) return key_of<V>(block, times_s.front(), lane);
  Track<V> track{block.interpolation, {times_s.begin(), times_s.end()}, std::vector<V>(times_s.size() * parts)};
  if (block.packed.empty()) {
    auto value = track.values.begin();
    for (std::size_t k = 0; k < times_s.size(); ++k)
      for (std::size_t part = 0; part < parts; ++part)
        read_value(block.plane(k, part * components) + lane, block.lane_count, *value++);
    return track;
  }
  const PackedTrack packed = packed_lane(block.packed, block.lane_count, lane, times_s.size());
  for (std::size_t k = 0; k < times_s.size(); ++k) read_value(packed, k, track.values[k]);
  return track;
}

void set_track(const TrackBlock& block, std::span<const float> times_s, std::size_t lane, BoneAnimation& bone) {
  if (block.property == Property::rotation)
    bone.rotation = track_of<glm::quat>(block, times_s, lane);
  else
    (block.property == Property::scale ? bone.scale : bone.translation) = track_of<glm::vec3>(block, times_s, lane);
}

/// All lanes of a block of weights or numbers. They have the layout of a WeightTrack.
WeightTrack weights_of(const TrackBlock& block, std::span<const float> times_s) {
  const std::size_t lanes = block.lane_count, count = times_s.size() * parts_of(block.interpolation) * lanes;
  if (times_s.size() == 1 && block.packed.empty()) {
    const float* value = block.plane(0, block.value_plane);
    return {Interpolation::step, {times_s.front()}, {value, value + lanes}, block.lane_count};
  }
  WeightTrack track{block.interpolation, {times_s.begin(), times_s.end()}, std::vector<float>(count), block.lane_count};
  if (block.packed.empty()) {
    std::copy_n(block.rows.begin(), count, track.values.begin());
    return track;
  }
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const PackedTrack packed = packed_lane(block.packed, lanes, lane, times_s.size());
    for (std::size_t k = 0; k < times_s.size(); ++k) track.values[k * lanes + lane] = unpack_key(packed, k)[0];
  }
  return track;
}

/// A track with one key.
WeightTrack constant(std::span<const float> values) {
  return {Interpolation::step, {0.0f}, {values.begin(), values.end()}, static_cast<std::uint32_t>(values.size())};
}

class Decompiler {
 public:
  Decompiler(const ClipLayout& clip, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
             const PropertyTable& properties)
      : clip_(clip),
        rest_(rest),
        first_weight_(first_weight),
        properties_(properties),
        bone_of_(clip.joint_count, kNone),
        weight_moves_(rest.weights->size(), false),
        entry_moves_(properties.entries.size(), false) {}

  Result<Animation> run() {
    out_.name = clip_.name;
    out_.duration_s = clip_.duration_s;
    out_.annotations = clip_.annotations;
    for (const TimeGroup& group : clip_.groups)
      for (const TrackBlock& block : group.blocks) add_block(block, group.times.times_s());
    add_constant_joints();
    add_constant_weights();
    add_constant_properties();
    if (!splits_well_) return tl::unexpected(ErrorCode::unsupported);
    std::sort(out_.bones.begin(), out_.bones.end(),
              [](const BoneAnimation& a, const BoneAnimation& b) { return a.joint < b.joint; });
    return std::move(out_);
  }

 private:
  BoneAnimation& bone(std::uint32_t joint) {
    if (bone_of_[joint] == kNone) {
      bone_of_[joint] = static_cast<std::uint32_t>(out_.bones.size());
      out_.bones.emplace_back().joint = joint;
    }
    return out_.bones[bone_of_[joint]];
  }

  void add_block(const TrackBlock& block, std::span<const float> times_s) {
    if (block.property == Property::weight) return add_weights(block, times_s);
    if (block.property == Property::number) return add_numbers(block, times_s);
    for (std::size_t lane = 0; lane < block.lane_count; ++lane)
      set_track(block, times_s, lane, bone(block.targets[lane]));
  }

  /// The mesh instance that a weight belongs to.
  std::uint32_t instance_of(std::uint32_t weight) const noexcept {
    const auto after = std::upper_bound(first_weight_.begin(), first_weight_.end(), weight);
    return static_cast<std::uint32_t>(after - first_weight_.begin()) - 1;
  }

  void add_weights(const TrackBlock& block, std::span<const float> times_s) {
    const std::uint32_t first = block.targets.front(), instance = instance_of(first);
    if (block.targets.back() >= first_weight_[instance + 1]) {
      splits_well_ = false;
      return;
    }
    out_.weights.push_back({instance, weights_of(block, times_s), first - first_weight_[instance]});
    for (const std::uint32_t weight : block.targets) weight_moves_[weight] = true;
  }

  void add_numbers(const TrackBlock& block, std::span<const float> times_s) {
    const auto& entries = properties_.entries;
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const PropertyTable::Entry& e) {
      return e.first == block.targets.front() && e.count == block.lane_count;
    });
    if (entry == entries.end()) {
      splits_well_ = false;
      return;
    }
    out_.properties.push_back({entry->target, weights_of(block, times_s)});
    entry_moves_[static_cast<std::size_t>(entry - entries.begin())] = true;
  }

  void add_constant_joints() {
    const std::vector<float> base = clip_.base_pose.all(), &rest = *rest_.pose;
    const std::size_t stride = BasePose::stride_for(clip_.joint_count);
    const auto differs = [&](Property property, std::size_t joint) {
      bool any = false;
      for (std::size_t c = 0; c < components_of(property); ++c) {
        const std::size_t at = (first_plane(property) + c) * stride + joint;
        any = any || !same_bits(base[at], rest[at]);
      }
      return any;
    };
    const auto number = [&](Property property, std::size_t c, std::size_t joint) {
      return base[(first_plane(property) + c) * stride + joint];
    };
    for (std::uint32_t j = 0; j < clip_.joint_count; ++j) {
      for (const Property property : {Property::translation, Property::scale}) {
        if (!differs(property, j)) continue;
        Vec3Track& track = property == Property::scale ? bone(j).scale : bone(j).translation;
        const glm::vec3 v(number(property, 0, j), number(property, 1, j), number(property, 2, j));
        if (track.empty()) track = {Interpolation::step, {0.0f}, {v}};
      }
      if (!differs(Property::rotation, j) || !bone(j).rotation.empty()) continue;
      const auto q = [&](std::size_t c) { return number(Property::rotation, c, j); };
      bone(j).rotation = {Interpolation::step, {0.0f}, {quat_xyzw(q(0), q(1), q(2), q(3))}};
    }
  }

  /// Adds constant tracks for runs of weights whose constant value in the clip differs from the rest value.
  void add_constant_weights() {
    const std::vector<float> base = clip_.base_weights.all();
    const auto is_held = [&](std::uint32_t w) { return !weight_moves_[w] && !same_bits(base[w], (*rest_.weights)[w]); };
    for (std::uint32_t i = 0; i + 1 < first_weight_.size(); ++i)
      for (std::uint32_t first = first_weight_[i]; first < first_weight_[i + 1]; ++first) {
        if (!is_held(first)) continue;
        std::uint32_t end = first + 1;
        while (end < first_weight_[i + 1] && is_held(end)) ++end;
        out_.weights.push_back({i, constant(std::span(base).subspan(first, end - first)), first - first_weight_[i]});
        first = end;
      }
  }

  void add_constant_properties() {
    const std::vector<float> base = clip_.base_properties.all();
    for (std::size_t e = 0; e < properties_.entries.size(); ++e) {
      const PropertyTable::Entry& entry = properties_.entries[e];
      const auto held = std::span<const float>(base).subspan(entry.first, entry.count);
      if (!entry_moves_[e] && !same_bits(held, std::span(rest_.properties->data() + entry.first, entry.count)))
        out_.properties.push_back({entry.target, constant(held)});
    }
  }

  const ClipLayout& clip_;
  const ClipRest& rest_;
  std::span<const std::uint32_t> first_weight_;
  const PropertyTable& properties_;
  std::vector<std::uint32_t> bone_of_;  ///< [J] index into out_.bones
  std::vector<bool> weight_moves_, entry_moves_;
  bool splits_well_ = true;
  Animation out_;
};

}  // namespace

Result<Animation> decompile_clip(const Clip& clip, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
                                 const PropertyTable& properties) {
  return Decompiler(clip.layout(), rest, first_weight, properties).run();
}

BoneAnimation decompile_joint(const Clip& clip, std::uint32_t joint) {
  const ClipLayout& layout = clip.layout();
  CONTRACT(joint < layout.joint_count);
  const std::size_t stride = BasePose::stride_for(layout.joint_count);
  const auto held = [&](std::size_t plane) { return layout.base_pose[plane * stride + joint]; };
  const auto constant = [](auto value) { return Track<decltype(value)>{Interpolation::step, {0.0f}, {value}}; };
  BoneAnimation bone{.joint = joint,
                     .translation = constant(glm::vec3(held(0), held(1), held(2))),
                     .rotation = constant(quat_xyzw(held(3), held(4), held(5), held(6))),
                     .scale = constant(glm::vec3(held(7), held(8), held(9)))};
  for (const TimeGroup& group : layout.groups)
    for (const TrackBlock& block : group.blocks) {
      const auto found = std::lower_bound(block.targets.begin(), block.targets.end(), joint);
      if (!is_of_joints(block) || found == block.targets.end() || *found != joint) continue;
      set_track(block, group.times.times_s(), static_cast<std::size_t>(found - block.targets.begin()), bone);
    }
  return bone;
}

std::uint64_t decompiled_bytes(const Clip& clip) noexcept {
  std::uint64_t bytes = clip.joint_count() * (sizeof(std::uint32_t) + 10 * sizeof(float));
  for (const TimeGroup& group : clip.layout().groups)
    for (const TrackBlock& block : group.blocks) {
      const std::uint64_t numbers = parts_of(block.interpolation) * components_of(block.property) + 1;
      bytes += block.lane_count * (sizeof(BoneAnimation) + group.times.key_count() * numbers * sizeof(float));
    }
  return bytes;
}

}  // namespace sinew
