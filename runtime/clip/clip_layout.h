// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/shared_array.h"
#include "runtime/clip/clip.h"
#include "runtime/clip/clip_rest.h"
#include "runtime/clip/key_times.h"
#include "runtime/clip/packed_rows.h"

/// The data of a compiled clip, private to the library: compile_clip and load_clips write it, sample_clip reads it.
namespace sinew {

/// `number` is one component of an animated property (PropertyTable).
enum class Property : std::uint8_t { translation, rotation, scale, weight, number };

/// First plane of a property in a pose, whose planes are translation xyz, rotation xyzw, scale xyz.
constexpr std::size_t first_plane(Property p) noexcept {
  return p == Property::translation ? 0 : p == Property::rotation ? 3 : p == Property::scale ? 7 : 0;
}

/// Components of rotations below this become 0, except where a stored key is returned. They turn by less than 1e-18,
/// but their squares are denormal numbers, on which some processors are a hundred times slower. Real clips have them.
inline constexpr float kLeastComponent = 1e-18f;
inline glm::quat without_tiny(const glm::quat& q) noexcept {
  const auto flushed = [](float x) { return std::abs(x) < kLeastComponent ? 0.0f : x; };
  return quat_xyzw(flushed(q.x), flushed(q.y), flushed(q.z), flushed(q.w));
}

/// A pose in the planes of PoseSpan (pose/pose.h), as BaseNumbers stores it. Lanes beyond the last joint are the
/// identity.
struct BasePose {
  std::size_t stride = 0;
  std::vector<float> planes;

  BasePose() = default;
  explicit BasePose(const std::vector<Transform>& rest);
  static constexpr std::size_t stride_for(std::size_t joint_count) noexcept { return (joint_count + 15) / 16 * 16; }
  void set(std::size_t plane, std::size_t joint, std::initializer_list<float> components) noexcept {
    for (const float x : components) planes[plane++ * stride + joint] = x;
  }
  void set_rotation(std::size_t joint, const glm::quat& rotation) noexcept {
    const glm::quat q = without_tiny(rotation);
    set(3, joint, {q.x, q.y, q.z, q.w});
  }
};

/// Maps joints to the lanes of a block. With it, a vector of consecutive joints is gathered from consecutive lanes and
/// stored at once, instead of scattering the lanes one by one.
struct JointPlaces {
  static constexpr std::size_t kStep = 16, kPart = 4;  ///< joints in the widest and in the narrowest vector

  std::uint32_t first_joint = 0;      ///< a multiple of kStep
  std::vector<std::int32_t> lane_of;  ///< [multiple of kStep] lane of joint first_joint + i, -1 = none
  /// [lane_of.size() / kPart + 1] number of lanes whose joint is below first_joint + i * kPart
  std::vector<std::uint32_t> lanes_before;

  JointPlaces() = default;
  /// Makes the map of a block's joints.
  /// in   joints  joint of each lane, increasing, at least one
  explicit JointPlaces(std::span<const std::uint32_t> joints);

  std::size_t byte_size() const noexcept {
    return lane_of.size() * sizeof(std::int32_t) + lanes_before.size() * sizeof(std::uint32_t);
  }
};

/// Tracks with the same property, interpolation and key times. Each track is a lane. Each key is a row of planes, and
/// a plane holds one component of all lanes. A sample reads two consecutive rows. Planes by kind of track:
///
///     step, linear vectors     x y z
///     cubic vectors            in xyz | value xyz | out xyz
///     step rotations           x y z w
///     linear rotations         x y z w | arc
///     cubic rotations          in xyzw | value xyzw | out xyzw
///     squad rotations          x y z w | control of this key | control of the next | sign of the next key
///     weights, numbers         value, or in | value | out
///
/// `arc` is half the rotation angle to the next key on the short arc, at least kSmallestArc. It is negative if the next
/// key must be negated for that arc. The sign of squad, 1 or -1, aligns the next key.
struct TrackBlock {
  Property property = Property::translation;
  Interpolation interpolation = Interpolation::linear;
  std::uint32_t lane_count = 0;
  std::uint32_t plane_count = 0;       ///< number of planes per key
  std::uint32_t value_plane = 0;       ///< first plane of the key's own value
  std::vector<std::uint32_t> targets;  ///< [lane_count] joint, or index of the weight or number; increasing
  JointPlaces places;                  ///< only if targets are joints; targets of weights and numbers are consecutive
  SharedArray<float> rows;  ///< [key][plane][lane], plus kLanePadding numbers: vectors may read past the last lane
  PackedRows packed;        ///< used instead of `rows` for step and linear tracks with rounded keys

  const float* plane(std::size_t key, std::size_t p) const noexcept {
    return rows.data() + (key * plane_count + p) * lane_count;
  }
};

inline constexpr std::size_t kLanePadding = 16;

/// Largest gap between the joints of a block. JointPlaces has entries for all joints from the first to the last, so a
/// larger gap starts a new block.
inline constexpr std::uint32_t kWidestGap = 256;

/// A block without keys, with the members that follow from its kind.
TrackBlock block_of(Property property, Interpolation interpolation, std::size_t lane_count);

/// Smaller arcs are replaced by this one, so that slerp neither divides by a tiny sine nor branches. For arcs up to
/// this the ratio of the sines equals that of the fractions within arc^2 / 6 = 2e-9.
inline constexpr float kSmallestArc = 1e-4f;

struct TimeGroup {
  KeyTimes times;
  std::vector<TrackBlock> blocks;
};

struct ClipLayout {
  std::string name;
  double duration_s = 0.0;
  std::size_t joint_count = 0;
  BaseNumbers base_pose;  ///< rest values and constant tracks, in the order of BasePose::planes
  BaseNumbers base_weights, base_properties;
  std::vector<TimeGroup> groups;
  Clip::Counts counts;
  std::optional<ClipCertificate> certificate;
  Annotations annotations;
};

/// Adds the tracks of a block to the counts of tracks that a sample evaluates.
void count_tracks(const TrackBlock& block, Clip::Counts& counts) noexcept;

/// Makes a clip of this layout.
Clip clip_of(ClipLayout layout);

}  // namespace sinew
