// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

/// Work of pose operations. A kind that a program does not contain counts zero.
struct PoseProgramWork {
  std::uint64_t clips_sampled = 0;
  std::uint64_t tracks_sampled = 0, properties_sampled = 0;  ///< counted only with PoseProgramAssets::clip_tracks
  std::uint64_t poses_copied = 0;                            ///< external poses of the caller
  std::uint64_t poses_mirrored = 0;
  std::uint64_t poses_blended = 0;
  std::uint64_t poses_overlaid = 0;
  std::uint64_t poses_added = 0;
  std::uint64_t joints_overridden = 0;
  std::uint64_t procedures_run = 0;
  std::uint64_t transitions_started = 0;  ///< counted when the start is evaluated, not in later frames
  std::uint64_t poses_in_transition = 0;

  friend bool operator==(const PoseProgramWork&, const PoseProgramWork&) = default;
};

}  // namespace sinew
