// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "runtime/clip/clip.h"
#include "runtime/clip/joint_places.h"
#include "runtime/clip/key_times.h"
#include "runtime/clip/packed_keys.h"

/// What a compiled clip is made of. Written by compile_clip, read by sample_clip, of no interest to anybody else.
namespace sinew {

/// `number` is one component of a property that is none of the others.
enum class Property : std::uint8_t { translation, rotation, scale, weight, number };

/// First plane of a property in a pose: translation xyz, rotation xyzw, scale xyz.
constexpr std::size_t first_plane(Property p) noexcept {
  return p == Property::translation ? 0 : p == Property::rotation ? 3 : p == Property::scale ? 7 : 0;
}

/// Components of rotations below this are 0, unless a key is returned as it is stored: they turn by less than 1e-18,
/// their squares are no normal numbers, and real clips have them. Some processors take a hundred times as long for such
/// a product (N26).
inline constexpr float kLeastComponent = 1e-18f;
inline glm::quat without_tiny(const glm::quat& q) noexcept {
  const auto flushed = [](float x) { return std::abs(x) < kLeastComponent ? 0.0f : x; };
  return quat_xyzw(flushed(q.x), flushed(q.y), flushed(q.z), flushed(q.w));
}

/// The pose that a sample starts from, in the planes of PoseSpan (pose/pose.h), so that it is copied as one block.
/// Lanes beyond the last joint hold the identity.
struct BasePose {
  std::size_t stride = 0;
  std::vector<float> planes;

  BasePose() = default;
  explicit BasePose(const std::vector<Transform>& rest)
      : stride((rest.size() + 15) / 16 * 16), planes(10 * stride, 0.0f) {
    for (std::size_t j = 0; j < stride; ++j) {
      const Transform t = j < rest.size() ? rest[j] : Transform{};
      set(0, j, {t.translation.x, t.translation.y, t.translation.z});
      set_rotation(j, t.rotation);
      set(7, j, {t.scale.x, t.scale.y, t.scale.z});
    }
  }
  void set(std::size_t plane, std::size_t joint, std::initializer_list<float> components) noexcept {
    for (const float x : components) planes[plane++ * stride + joint] = x;
  }
  void set_rotation(std::size_t joint, const glm::quat& rotation) noexcept {
    const glm::quat q = without_tiny(rotation);
    set(3, joint, {q.x, q.y, q.z, q.w});
  }
};

/// Tracks of one property and one interpolation that share their key times, side by side: a key is one row of planes,
/// a plane holds one number of every track, so that lanes are joints and a pose reads two neighbouring rows.
///
///     step, linear vectors     x y z
///     cubic vectors            in xyz | value xyz | out xyz
///     step rotations           x y z w
///     linear rotations         x y z w | arc     half the rotation angle to the next key on the short arc, at least
///                                                 kSmallestArc; negative when the next key must be negated (G01)
///     cubic rotations          in xyzw | value xyzw | out xyzw
///     squad rotations          x y z w | control of this key | control of the next | sign of the next key
///     weights, numbers         value, or in | value | out
struct TrackBlock {
  Property property = Property::translation;
  Interpolation interpolation = Interpolation::linear;
  std::uint32_t lane_count = 0;
  std::uint32_t plane_count = 0;       ///< planes per key
  std::uint32_t value_plane = 0;       ///< first plane of the key's own value
  std::vector<std::uint32_t> targets;  ///< [lane_count] joint, or index of the morph weight or number; increasing
  JointPlaces places;                  ///< of the targets that are joints: weights and numbers are neighbours
  std::vector<float> rows;  ///< [key][plane][lane], and kLanePadding more numbers: lanes may read past the end
  PackedRows packed;        ///< of step and linear tracks in place of `rows`, where keys are rounded

  const float* plane(std::size_t key, std::size_t p) const noexcept {
    return rows.data() + (key * plane_count + p) * lane_count;
  }
};

inline constexpr std::size_t kLanePadding = 16;

/// A block without keys; what follows from its kind is filled in.
TrackBlock block_of(Property property, Interpolation interpolation, std::size_t lane_count);

/// Below this arc the ratio of the sines in slerp is that of the fractions to within arc^2 / 6 = 2e-9, so that the arc
/// may be taken for this one: no division by a tiny sine, no branch (N01).
inline constexpr float kSmallestArc = 1e-4f;

struct TimeGroup {
  KeyTimes times;
  std::vector<TrackBlock> blocks;
};

struct ClipLayout {
  std::string name;
  double duration_s = 0.0;
  std::size_t joint_count = 0;
  BasePose base_pose;                  ///< rest values and constant tracks
  std::vector<float> base_weights;     ///< rest values and constant tracks
  std::vector<float> base_properties;  ///< rest values and constant tracks
  std::vector<TimeGroup> groups;
  Clip::Counts counts;
  std::optional<ClipCertificate> certificate;
};

/// Adds the tracks of a block to those evaluated per sample.
void count_tracks(const TrackBlock& block, Clip::Counts& counts) noexcept;

/// The clip that is made of this.
Clip clip_of(ClipLayout layout);

}  // namespace sinew
