// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/lod/update_rate.h"

namespace sinew {

/// Frames from this one to the next in which a character of the level is due: 1 at the finest.
std::uint32_t frames_to_update(UpdateLevel level, std::uint64_t frame, std::uint32_t phase) noexcept;

/// Evaluates a character at the frames of its level and lets it move in between. A clip is known before it is played,
/// so the pose of the next update is evaluated at the last one, and frames between the two are interpolated
/// (interpolate_poses.h) without lag. Sampling and blending of layers cost 2^-k of what they cost in every frame;
/// interpolation, model matrices, palettes and skinning run in every frame for what is in view. Worth it where layers
/// are many, or where vertices are skinned elsewhere. HeldInput (update_rate.h) saves the rest as well, and moves in
/// jerks.
///
/// Another clip, weight or speed shows from the next update on, up to 2^k - 1 frames late and without a jump. The root,
/// given morph weights, sources of vertices and what is out of view are always of this frame.
/// err  of second order: under an acceleration a the pose is off by at most a h^2 / 8, h the time between updates.
///      Under an even turn by an angle x per interval it is off by less than 0.0041 x^3 rad (rotations are
///      interpolated on the chord). A step between two updates is smeared
class InterpolatedInput {
 public:
  /// in   plan  with Needs::between_updates
  explicit InterpolatedInput(const Plan& plan);

  /// The input to run in this frame.
  /// in   ahead  layers of the frame that is frames_to_update from now; read when an interval starts
  ///      phase  of the character, any number: characters that count up spread their work over frames
  /// out  views of this object, of `now` at the finest level; valid until the next call
  /// cost O(layers), no allocation for layers within the room of the plan (Needs::layer_room)
  FrameInput next(const FrameInput& now, std::span<const ClipLayer> ahead, UpdateLevel level, std::uint64_t frame,
                  std::uint32_t phase);

  /// The next frame starts anew: after a cut, where moving on from the pose before would be wrong.
  void restart() noexcept { moves_ = false; }

 private:
  std::vector<ClipLayer> from_, to_;
  std::uint64_t start_ = 0, end_ = 0;  // frames of these
  bool moves_ = false;
};

}  // namespace sinew
