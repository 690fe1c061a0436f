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

/// An animation compiled for playing: immutable, structure of arrays, constant and rest tracks folded away. Tracks that
/// share key times form one group, so that a pose needs one key search per group, not per joint (P02, P03).
/// Read by the jobs sample_clip and sample_weights only; its layout is theirs to change (clip_layout.h).
struct ClipLayout;

/// A clip is a handle: copies share the tracks.
class Clip {
 public:
  Clip();

  const std::string& name() const noexcept;
  double duration_s() const noexcept;
  std::size_t joint_count() const noexcept;
  std::size_t weight_count() const noexcept;    ///< all morph weights of the scene, one instance after another
  std::size_t property_count() const noexcept;  ///< numbers of all animated properties of the scene
  std::size_t byte_size() const noexcept;       ///< of key data and tables

  /// Tracks evaluated per sample, by kind; folded tracks do not count.
  struct Counts {
    std::uint32_t translations = 0, rotations = 0, scales = 0, weights = 0;  ///< animated
    std::uint32_t properties = 0;                                            ///< animated numbers of properties
    std::uint32_t folded = 0;                                                ///< constant, now part of the base pose
    std::uint32_t time_groups = 0;                                           ///< key searches per sample
  };
  Counts counts() const noexcept;

  /// Of clips that were compiled within a budget (compress/compile_clip_within.h).
  const std::optional<ClipCertificate>& certificate() const noexcept;

  const ClipLayout& layout() const noexcept { return *layout_; }

 private:
  explicit Clip(ClipLayout&& layout);
  friend Clip clip_of(ClipLayout layout);

  std::shared_ptr<const ClipLayout> layout_;
};

/// Compiles the authoring form. The animation must have passed check(Track) for each track.
/// in   rest_weights[W]        morph weights of all mesh instances at rest, one after another
///      first_weight[I + 1]    where the weights of each instance begin
///      properties             has every property that the animation moves
///      rounding               by how much keys may be rounded, so that they take fewer bits
/// cost O(total keys), allocates the clip
Clip compile_clip(const Animation& animation, const Skeleton& skeleton, std::span<const float> rest_weights,
                  std::span<const std::uint32_t> first_weight, const PropertyTable& properties = {},
                  const KeyTolerances& rounding = {});

/// The same clip, with what was measured of it. It shares the keys.     cost O(tracks), allocates their tables
Clip with_certificate(const Clip& clip, const ClipCertificate& certificate);

}  // namespace sinew
