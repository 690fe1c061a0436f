// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/lod/update_rate.h"

namespace sinew {

/// Number of frames until the next update of a character at this level: 1 at the finest level.
SINEW_API std::uint32_t frames_to_update(UpdateLevel level, std::uint64_t frame, std::uint32_t phase) noexcept;

/// Evaluates a character in the frames of its level and interpolates in between. A clip is known in advance, so the
/// pose of the next update is evaluated one interval early. Frames between the two updates are interpolated without lag
/// (interpolate_poses.h). At level k, sampling and blending of layers then cost 2^-k of their full cost. Interpolation,
/// model matrices, palettes and skinning still run in every frame for meshes in view. It pays where layers are many, or
/// where vertices are skinned elsewhere. HeldInput (update_rate.h) saves the rest as well, but its motion is jerky.
///
/// A change of clip, weight or speed shows at the next update, up to 2^k - 1 frames late and without a jump. The root,
/// given morph weights, vertex sources and visibility are always those of the current frame. Pose programs are
/// evaluated in every frame, since their next pose is not known in advance.
/// err  of second order: under an acceleration a, the pose is off by at most a h^2 / 8, h the time between updates.
///      Under a constant turn by an angle x per interval it is off by less than 0.0041 x^3 rad (rotations are
///      interpolated on the chord). A sudden step between two updates is smeared over the interval.
class SINEW_API InterpolatedInput {
 public:
  /// in   plan  with Needs::in.between_updates
  explicit InterpolatedInput(const Plan& plan);

  /// The input to run in this frame.
  /// in   ahead  layers of the frame that is frames_to_update from now; read when an interval starts
  ///      phase  any number per character; consecutive numbers spread the work of many characters over frames
  /// out  views into this object, or into `now` at the finest level; valid until the next call
  /// cost O(layers), no allocation for layers within the room of the plan (Needs::in.layer_room)
  FrameInput next(const FrameInput& now, std::span<const ClipLayer> ahead, UpdateLevel level, std::uint64_t frame,
                  std::uint32_t phase);

  /// Starts anew in the next frame. Call it after a cut, where interpolating from the previous pose would be wrong.
  void restart() noexcept { moves_ = false; }

 private:
  std::vector<ClipLayer> from_, to_;
  std::uint64_t start_ = 0, end_ = 0;  // frame numbers of from_ and to_
  bool moves_ = false;
};

}  // namespace sinew
