// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"

namespace sinew {

/// The measured error and size of a clip that was compiled within an error budget. The error is the difference between
/// the compiled clip and the authoring form in double precision, at and between all keys. The clip is measured both
/// packed and unpacked (unpack_clip.h). Lengths are in the units of the file, which are metres by glTF's convention.
///
/// Each joint has a box of virtual vertices (compress/virtual_vertices.h). Its error is the largest model-space
/// distance between a corner of the box as the clip places it and the true position. Linear skinning averages over
/// joints, so no vertex has a larger error.
struct ClipCertificate {
  double asked_m = 0.0;               ///< the error budget
  double measured_m = 0.0;            ///< largest sum of joint error and morph weight error at one time
  double weights_m = 0.0;             ///< largest morph weight error over the clip, as the displacement of vertices
  double worst_time_s = 0.0;          ///< time of `measured_m`
  std::uint32_t worst_joint = kNone;  ///< kNone if no joint has an error
  std::uint32_t times_checked = 0;
  std::uint32_t animated_joints = 0;             ///< joints with tracks in the authoring form
  std::uint64_t source_keys = 0, kept_keys = 0;  ///< keys of all tracks; a folded track has one.
  /// Size in a file (clip_file.h): with every key in full float, and as this clip is stored.
  std::uint64_t source_bytes = 0, bytes = 0;

  /// False only if the budget is below the error of float arithmetic itself. Then the clip keeps every key in full
  /// float.
  bool is_met() const noexcept { return measured_m <= asked_m; }

  double bytes_per_joint_second(double duration_s) const noexcept {
    const double joint_seconds = animated_joints * duration_s;
    return joint_seconds > 0.0 ? static_cast<double>(bytes) / joint_seconds : 0.0;
  }

  friend bool operator==(const ClipCertificate&, const ClipCertificate&) = default;
};

/// How far compile_clip may round keys, so that they take fewer bits. A tolerance of 0, or no entry, keeps the full
/// float. Only step and linear tracks are rounded.
struct KeyTolerances {
  struct OfBone {
    double translation = 0.0;  ///< a length in metres
    double rotation = 0.0;  ///< the distance by which a point one unit from the axis moves; for small angles, radians
    double scale = 0.0;
  };
  std::vector<OfBone> bones;                 ///< parallel to Animation::bones, or empty
  std::vector<std::vector<double>> weights;  ///< [target_count] parallel to Animation::weights, or empty
};

/// The data of a compiled animation: immutable, as structure of arrays, with constant tracks folded into the base
/// pose. Tracks with the same key times form one group, so sampling searches once per group instead of once per joint.
/// The layout (clip_layout.h) is private to the jobs that sample.
struct ClipLayout;

/// A compiled animation. It is a handle: copies share the data.
class SINEW_API Clip {
 public:
  Clip();

  const std::string& name() const noexcept;
  double duration_s() const noexcept;
  std::size_t joint_count() const noexcept;
  std::size_t weight_count() const noexcept;    ///< morph weights of the scene, one mesh instance after another
  std::size_t property_count() const noexcept;  ///< components of all animated properties of the scene
  std::size_t byte_size() const noexcept;       ///< bytes of key data and tables

  /// Tracks that a sample evaluates, by kind.
  struct Counts {
    std::uint32_t translations = 0, rotations = 0, scales = 0, weights = 0;  ///< numbers of animated tracks
    std::uint32_t properties = 0;                                            ///< components of animated properties
    std::uint32_t folded = 0;       ///< constant tracks, which became part of the base pose
    std::uint32_t time_groups = 0;  ///< key searches per sample
  };
  Counts counts() const noexcept;

  /// Events and curves of the animation from which the clip was compiled. All clips made from this one have them, too.
  const Annotations& annotations() const noexcept;

  /// Present if the clip was compiled within an error budget (compress/compile_clip_within.h).
  const std::optional<ClipCertificate>& certificate() const noexcept;

  const ClipLayout& layout() const noexcept { return *layout_; }

 private:
  explicit Clip(ClipLayout&& layout);
  friend Clip clip_of(ClipLayout layout);

  std::shared_ptr<const ClipLayout> layout_;
};

/// Compiles the authoring form. Every track must have passed check(Track).
/// in   rest_weights[W]        rest morph weights of all mesh instances, one after another
///      first_weight[I + 1]    where the weights of each instance begin
///      properties             contains every property that the animation moves
///      rounding               how far keys may be rounded, so that they take fewer bits
/// cost O(total keys), allocates the clip
SINEW_API Clip compile_clip(const Animation& animation, const Skeleton& skeleton, std::span<const float> rest_weights,
                            std::span<const std::uint32_t> first_weight, const PropertyTable& properties = {},
                            const KeyTolerances& rounding = {});

/// A copy of the clip with other events and curves. It shares the keys.
/// in   annotations  that check(Annotations) accepts      cost O(tracks), allocates their tables
SINEW_API Clip with_annotations(const Clip& clip, Annotations annotations);

/// A copy of the clip with a certificate. It shares the keys.     cost O(tracks), allocates their tables
SINEW_API Clip with_certificate(const Clip& clip, const ClipCertificate& certificate);

}  // namespace sinew
