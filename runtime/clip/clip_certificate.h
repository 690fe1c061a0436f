// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// What is known of a clip that was compiled within a budget: measured on the compiled clip, as it is and unpacked
/// (unpack_clip.h), against the authoring form in double precision, at and between all keys. Lengths are in the units
/// of the file, which are metres by glTF's convention.
///
/// A joint's error is the largest distance between where the clip and the truth put a corner of its box of virtual
/// vertices (compress/virtual_vertices.h), in model space. Linear skinning averages the joints of a vertex, so that no
/// vertex of a skin is farther from its true place.
struct ClipCertificate {
  double asked_m = 0.0;
  double measured_m = 0.0;    ///< largest sum of the errors of joints and of morph weights at one time
  double weights_m = 0.0;     ///< the part of the weights: what they displace vertices by, largest over the clip
  double worst_time_s = 0.0;  ///< where `measured_m` was found
  std::uint32_t worst_joint = kNone;  ///< kNone: no joint is off
  std::uint32_t times_checked = 0;
  std::uint32_t animated_joints = 0;             ///< with tracks in the authoring form
  std::uint64_t source_keys = 0, kept_keys = 0;  ///< of all tracks; folded tracks keep one
  std::uint64_t source_bytes = 0, bytes = 0;     ///< saved (clip_file.h): with every key in full float, and this one

  /// False only where the budget is below what float arithmetic itself is off by: such clips keep everything.
  bool is_met() const noexcept { return measured_m <= asked_m; }

  double bytes_per_joint_second(double duration_s) const noexcept {
    const double joint_seconds = animated_joints * duration_s;
    return joint_seconds > 0.0 ? static_cast<double>(bytes) / joint_seconds : 0.0;
  }

  friend bool operator==(const ClipCertificate&, const ClipCertificate&) = default;
};

}  // namespace sinew
