// SPDX-License-Identifier: MIT
#include "runtime/clip/clip.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <map>
#include <numeric>

#include "runtime/base/contract.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/clip/track_rows.h"

namespace sinew {
namespace {

template <class TrackType>
struct Lane {
  std::uint32_t target;
  const TrackType* track;
  double tolerance = 0.0;  ///< how far keys may be rounded; 0 = full float
};

/// A track of weights or property components. Its targets are consecutive.
template <>
struct Lane<WeightTrack> {
  std::uint32_t target;  ///< the first target
  const WeightTrack* track;
  std::span<const double> tolerances = {};  ///< [target_count] or empty = full float
};

/// Tracks with the same key times, which become a TimeGroup.
struct Draft {
  std::vector<float> times_s;
  std::vector<Lane<Vec3Track>> vectors[2];  // translation tracks, scale tracks
  std::vector<Lane<QuatTrack>> rotations;
  std::vector<Lane<WeightTrack>> weights, numbers;
};

/// The drafts of a clip, one for each distinct array of key times.
class Drafts {
 public:
  Draft& with_times(const std::vector<float>& times_s) {
    const auto [found, is_new] = by_times_.try_emplace(times_s, all_.size());
    if (is_new) all_.emplace_back().times_s = times_s;
    return all_[found->second];
  }
  const std::vector<Draft>& all() const noexcept { return all_; }

 private:
  std::vector<Draft> all_;
  std::map<std::vector<float>, std::size_t> by_times_;
};

bool is_cubic(Interpolation i) noexcept { return i == Interpolation::cubic_spline; }

/// True if the track has the value of its first key at all times. Compares bits, so that folding it into the base pose
/// changes no result.
template <class V>
bool is_constant(const Track<V>& track) noexcept {
  const auto same = [](const V& a, const V& b) { return std::memcmp(&a, &b, sizeof(V)) == 0; };
  const bool cubic = is_cubic(track.interpolation);
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    if (cubic && i % 3 != 1) {
      const bool unused = i == 0 || i + 1 == track.values.size();
      if (!unused && track.values[i] != V{} * 0.0f) return false;
    } else if (!same(track.values[i], track.values[cubic ? 1 : 0])) {
      return false;
    }
  }
  return true;
}

/// True if samples are always stored keys, so that they are never normalised.
bool holds_keys(const QuatTrack& track) noexcept {
  return track.interpolation == Interpolation::step || track.key_count() == 1;
}

/// True if the length is 1 within the rounding of four components, so that normalising changes nothing.
bool is_rounded_unit(const glm::quat& q) noexcept {
  return std::abs(safe_length(quat_cast<double>(q)) - 1.0) <= 0x1p-23;
}

/// True if no weight of the track ever changes. Compares bits.
bool is_constant(const WeightTrack& track) noexcept {
  const std::size_t n = track.target_count, rows = n == 0 ? 0 : track.values.size() / n;
  const bool cubic = is_cubic(track.interpolation);
  for (std::size_t row = 0; row < rows; ++row) {
    const float* values = track.values.data() + row * n;
    if (!cubic || row % 3 == 1) {
      if (std::memcmp(values, track.values.data() + (cubic ? n : 0), n * sizeof(float)) != 0) return false;
      continue;
    }
    const bool unused = row == 0 || row + 1 == rows;
    for (std::size_t i = 0; i < n && !unused; ++i)
      if (values[i] != 0.0f) return false;
  }
  return true;
}

constexpr Interpolation kInterpolations[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline,
                                             Interpolation::squad};

std::uint32_t target_of(std::uint32_t target) noexcept { return target; }
template <class TrackType>
std::uint32_t target_of(const Lane<TrackType>& lane) noexcept {
  return lane.target;
}

/// Calls `add(first, count)` for each run of targets without a gap above kWidestGap.
template <class Targets, class Add>
void each_run(const Targets& targets, const Add& add) {
  for (std::size_t first = 0, end = 0; first < targets.size(); first = end) {
    for (end = first + 1; end < targets.size(); ++end)
      if (target_of(targets[end]) - target_of(targets[end - 1]) > kWidestGap) break;
    add(first, end - first);
  }
}

template <class TrackType>
void add_full_block(TimeGroup& group, Property property, std::span<const Lane<TrackType>> lanes) {
  TrackBlock block = block_of(property, lanes.front().track->interpolation, lanes.size());
  make_room(block, group.times.key_count());
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    block.targets.push_back(lanes[i].target);
    fill_lane(block, *lanes[i].track, i);
  }
  block.places = JointPlaces(block.targets);
  group.blocks.push_back(std::move(block));
}

/// Appends blocks of at most kMostPackedLanes lanes.
void add_packed_blocks(TimeGroup& group, Property property, Interpolation interpolation,
                       std::span<const std::uint32_t> targets, std::span<const PackedTrack> tracks) {
  for (std::size_t first = 0; first < tracks.size(); first += kMostPackedLanes) {
    const std::size_t count = std::min(kMostPackedLanes, tracks.size() - first);
    TrackBlock block = block_of(property, interpolation, count);
    block.targets.assign(targets.begin() + static_cast<std::ptrdiff_t>(first),
                         targets.begin() + static_cast<std::ptrdiff_t>(first + count));
    block.packed = packed_rows(tracks.subspan(first, count), group.times.key_count());
    if (property < Property::weight) block.places = JointPlaces(block.targets);
    group.blocks.push_back(std::move(block));
  }
}

template <class TrackType>
void add_blocks(TimeGroup& group, Property property, const std::vector<Lane<TrackType>>& lanes) {
  for (const Interpolation interpolation : kInterpolations) {
    std::vector<Lane<TrackType>> full;
    std::vector<std::uint32_t> targets;
    std::vector<PackedTrack> packed;
    for (const auto& lane : lanes) {
      if (lane.track->interpolation != interpolation) continue;
      std::optional<PackedTrack> keys = lane.tolerance > 0.0 ? pack_keys(*lane.track, lane.tolerance) : std::nullopt;
      if (!keys) {
        full.push_back(lane);
        continue;
      }
      targets.push_back(lane.target);
      packed.push_back(*std::move(keys));
    }
    each_run(full, [&](std::size_t first, std::size_t count) {
      add_full_block(group, property, std::span<const Lane<TrackType>>(full).subspan(first, count));
    });
    each_run(targets, [&](std::size_t first, std::size_t count) {
      add_packed_blocks(group, property, interpolation, std::span(targets).subspan(first, count),
                        std::span(packed).subspan(first, count));
    });
  }
}

/// All weights of a track in packed form; empty if one of them cannot be packed.
std::vector<PackedTrack> packed_weights(const Lane<WeightTrack>& lane) {
  std::vector<PackedTrack> packed;
  for (std::uint32_t i = 0; i < lane.tolerances.size(); ++i) {
    auto keys = lane.tolerances[i] > 0.0 ? pack_keys(*lane.track, i, lane.tolerances[i]) : std::nullopt;
    if (!keys) return {};
    packed.push_back(*std::move(keys));
  }
  return packed;
}

/// Weight tracks have the layout of a block already: their targets become the lanes.
void add_block(TimeGroup& group, Property property, const Lane<WeightTrack>& lane) {
  const std::size_t n = lane.track->target_count;
  std::vector<std::uint32_t> targets(n);
  std::iota(targets.begin(), targets.end(), lane.target);
  if (const std::vector<PackedTrack> packed = packed_weights(lane); !packed.empty())
    return add_packed_blocks(group, property, lane.track->interpolation, targets, packed);
  TrackBlock block = block_of(property, lane.track->interpolation, n);
  make_room(block, group.times.key_count());
  std::copy(lane.track->values.begin(), lane.track->values.end(), block.rows.writable());
  block.targets = std::move(targets);
  group.blocks.push_back(std::move(block));
}

/// Compiles one animation: constant tracks become part of the base pose, others are grouped by key times.
class Compiler {
 public:
  Compiler(ClipLayout& layout, const ClipRest& rest, const PropertyTable& properties)
      : layout_(layout), rest_(rest), properties_(properties), stride_(BasePose::stride_for(rest.joint_count)) {
    layout.joint_count = rest.joint_count;
  }

  void add(const Animation& animation, std::span<const std::uint32_t> first_weight, const KeyTolerances& rounding) {
    add_bones(animation, rounding);
    add_weights(animation, first_weight, rounding);
    add_properties(animation);
    for (const Draft& draft : drafts_.all()) add_group(draft);
    layout_.base_pose = BaseNumbers(rest_.pose, std::move(pose_overrides_));
    layout_.base_weights = BaseNumbers(rest_.weights, std::move(weights_overrides_));
    layout_.base_properties = BaseNumbers(rest_.properties, std::move(properties_overrides_));
  }

 private:
  /// If an animation has several tracks for one property of a joint, the last one counts.
  void add_bones(const Animation& animation, const KeyTolerances& rounding) {
    const std::vector<BoneAnimation>& bones = animation.bones;
    std::vector<std::size_t> order(bones.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bones[a].joint < bones[b].joint; });
    for (std::size_t i = 0; i < order.size();) {
      const std::uint32_t joint = bones[order[i]].joint;
      CONTRACT(joint < layout_.joint_count);
      Lane<Vec3Track> translation{joint, nullptr}, scale{joint, nullptr};
      Lane<QuatTrack> rotation{joint, nullptr};
      for (; i < order.size() && bones[order[i]].joint == joint; ++i) {
        const BoneAnimation& bone = bones[order[i]];
        const KeyTolerances::OfBone tolerance =
            rounding.bones.empty() ? KeyTolerances::OfBone() : rounding.bones[order[i]];
        if (!bone.translation.empty()) translation = {joint, &bone.translation, tolerance.translation};
        if (!bone.rotation.empty()) rotation = {joint, &bone.rotation, tolerance.rotation};
        if (!bone.scale.empty()) scale = {joint, &bone.scale, tolerance.scale};
      }
      add_vector(Property::translation, translation);
      add_rotation(rotation);
      add_vector(Property::scale, scale);
    }
  }

  void set_constant(std::size_t plane, std::uint32_t joint, std::initializer_list<float> components) {
    for (const float x : components)
      pose_overrides_.push_back({static_cast<std::uint32_t>(plane++ * stride_ + joint), x});
  }

  void add_vector(Property property, const Lane<Vec3Track>& lane) {
    if (lane.track == nullptr) return;
    const bool scale = property == Property::scale;
    if (is_constant(*lane.track)) {
      const glm::vec3& v = lane.track->values[value_row(lane.track->interpolation, 0)];
      set_constant(first_plane(property), lane.target, {v.x, v.y, v.z});
      ++layout_.counts.folded;
      return;
    }
    drafts_.with_times(lane.track->times_s).vectors[scale ? 1 : 0].push_back(lane);
  }

  void add_rotation(const Lane<QuatTrack>& lane) {
    if (lane.track == nullptr) return;
    const glm::quat& q = lane.track->values[value_row(lane.track->interpolation, 0)];
    if (is_constant(*lane.track) && (holds_keys(*lane.track) || is_rounded_unit(q)) &&
        same_bits(without_tiny(q), q)) {  // the base pose would change tiny components
      set_constant(first_plane(Property::rotation), lane.target, {q.x, q.y, q.z, q.w});
      ++layout_.counts.folded;
      return;
    }
    drafts_.with_times(lane.track->times_s).rotations.push_back(lane);
  }

  void add_weights(const Animation& animation, std::span<const std::uint32_t> first_weight,
                   const KeyTolerances& rounding) {
    // If an animation has several tracks for the same weights, the last one counts.
    std::map<std::uint32_t, Lane<WeightTrack>> tracks;
    for (std::size_t i = 0; i < animation.weights.size(); ++i) {
      const WeightAnimation& a = animation.weights[i];
      CONTRACT(std::size_t{a.instance} + 1 < first_weight.size());
      const std::uint32_t first = first_weight[a.instance] + a.first_target;
      CONTRACT(first + a.weights.target_count <= first_weight[a.instance + 1]);
      if (a.weights.empty() || a.weights.target_count == 0) continue;
      tracks[first] = {first, &a.weights, rounding.weights.empty() ? std::span<const double>() : rounding.weights[i]};
    }
    for (const auto& [first, lane] : tracks)
      if (!fold(*lane.track, first, weights_overrides_))
        drafts_.with_times(lane.track->times_s).weights.push_back(lane);
  }

  void add_properties(const Animation& animation) {
    for (const PropertyTrack& track : animation.properties) {
      const PropertyTable::Entry* entry = properties_.find(track.target);
      CONTRACT(entry != nullptr && entry->count == track.values.target_count);
      if (track.values.empty() || fold(track.values, entry->first, properties_overrides_)) continue;
      drafts_.with_times(track.values.times_s).numbers.push_back({entry->first, &track.values});
    }
  }

  /// Makes a constant track part of the base values; false if the track is not constant.
  bool fold(const WeightTrack& track, std::uint32_t first, std::vector<BaseNumbers::Override>& overrides) {
    if (!is_constant(track)) return false;
    const std::uint32_t n = track.target_count;
    const float* values = track.values.data() + (is_cubic(track.interpolation) ? n : 0);
    for (std::uint32_t i = 0; i < n; ++i) overrides.push_back({first + i, values[i]});
    layout_.counts.folded += n;
    return true;
  }

  void add_group(const Draft& draft) {
    TimeGroup group{KeyTimes(draft.times_s), {}};
    add_blocks(group, Property::translation, draft.vectors[0]);
    add_blocks(group, Property::rotation, draft.rotations);
    add_blocks(group, Property::scale, draft.vectors[1]);
    for (const auto& lane : draft.weights) add_block(group, Property::weight, lane);
    for (const auto& lane : draft.numbers) add_block(group, Property::number, lane);
    for (const TrackBlock& block : group.blocks) count_tracks(block, layout_.counts);
    layout_.groups.push_back(std::move(group));
    ++layout_.counts.time_groups;
  }

  ClipLayout& layout_;
  const ClipRest& rest_;
  const PropertyTable& properties_;
  std::size_t stride_;
  Drafts drafts_;
  std::vector<BaseNumbers::Override> pose_overrides_, weights_overrides_, properties_overrides_;
};

}  // namespace

Clip compile_clip(const Animation& animation, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
                  const PropertyTable& properties, const KeyTolerances& rounding) {
  CONTRACT(rounding.bones.empty() || rounding.bones.size() == animation.bones.size());
  CONTRACT(rounding.weights.empty() || rounding.weights.size() == animation.weights.size());
  CONTRACT(first_weight.empty() ? rest.weights->empty() : first_weight.back() == rest.weights->size());
  ClipLayout layout;
  layout.name = animation.name;
  layout.duration_s = animation.duration_s;
  layout.annotations = animation.annotations;
  Compiler(layout, rest, properties).add(animation, first_weight, rounding);
  return clip_of(std::move(layout));
}

Clip compile_clip(const Animation& animation, const Skeleton& skeleton, std::span<const float> rest_weights,
                  std::span<const std::uint32_t> first_weight, const PropertyTable& properties,
                  const KeyTolerances& rounding) {
  return compile_clip(animation, clip_rest(skeleton, rest_weights, properties), first_weight, properties, rounding);
}

}  // namespace sinew
