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
#include "runtime/clip/clip_certificate.h"
#include "runtime/clip/key_tolerances.h"

namespace sinew {

/// The data of a compiled animation: immutable, as structure of arrays, with constant tracks folded into the base
/// pose. Tracks with the same key times form one group, so sampling searches once per group instead of once per joint.
/// The layout (clip_layout.h) is private to the jobs that sample.
struct ClipLayout;

/// A compiled animation. It is a handle: copies share the data.
class Clip {
 public:
  Clip();

  const std::string& name() const noexcept;
  double duration_s() const noexcept;
  std::size_t joint_count() const noexcept;
  std::size_t weight_count() const noexcept;    ///< of the scene, one mesh instance after another
  std::size_t property_count() const noexcept;  ///< of the scene: components of all animated properties
  std::size_t byte_size() const noexcept;       ///< of key data and tables

  /// Tracks that a sample evaluates, by kind.
  struct Counts {
    std::uint32_t translations = 0, rotations = 0, scales = 0, weights = 0;  ///< animated
    std::uint32_t properties = 0;                                            ///< components of animated properties
    std::uint32_t folded = 0;       ///< constant tracks, which became part of the base pose
    std::uint32_t time_groups = 0;  ///< key searches per sample
  };
  Counts counts() const noexcept;

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
Clip compile_clip(const Animation& animation, const Skeleton& skeleton, std::span<const float> rest_weights,
                  std::span<const std::uint32_t> first_weight, const PropertyTable& properties = {},
                  const KeyTolerances& rounding = {});

/// A copy of the clip with a certificate. It shares the keys.     cost O(tracks), allocates their tables
Clip with_certificate(const Clip& clip, const ClipCertificate& certificate);

}  // namespace sinew
