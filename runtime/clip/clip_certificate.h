// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// The measured error and size of a clip that was compiled within an error budget. The error is the difference between
/// the compiled clip and the authoring form in double precision, at and between all keys. The clip is measured both
/// packed and unpacked (unpack_clip.h). Lengths are in the units of the file, which are metres by glTF's convention.
///
/// Each joint has a box of virtual vertices (compress/virtual_vertices.h). Its error is the largest model-space
/// distance between a corner of the box as the clip places it and the true position. Linear skinning averages over
/// joints, so no vertex has a larger error.
struct ClipCertificate {
  double asked_m = 0.0;
  double measured_m = 0.0;            ///< largest sum of joint error and morph weight error at one time
  double weights_m = 0.0;             ///< largest morph weight error over the clip, as the displacement of vertices
  double worst_time_s = 0.0;          ///< time of `measured_m`
  std::uint32_t worst_joint = kNone;  ///< kNone if no joint has an error
  std::uint32_t times_checked = 0;
  std::uint32_t animated_joints = 0;             ///< joints with tracks in the authoring form
  std::uint64_t source_keys = 0, kept_keys = 0;  ///< of all tracks; a folded track counts one
  /// In a file (clip_file.h): of the clip with every key in full float, and of this clip.
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

}  // namespace sinew
