// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/clip/clip.h"
#include "runtime/library/clip_channels.h"

namespace sinew {

/// Channels that clips move, but that could not be bound. Each name is listed once, for any number of clips.
struct SINEW_API Unbound {
  std::vector<std::string> missing;    ///< names that `to` lacks, or descriptions: "joint 3 without a name"
  std::vector<std::string> ambiguous;  ///< several channels have the name, in `from` or in `to`, so none was bound

  bool empty() const noexcept { return missing.empty() && ambiguous.empty(); }
  /// Adds the names that are not yet listed.     cost O(names of both), expected
  void add(const Unbound& more);
};

struct BoundClips {
  std::vector<Clip> clips;
  Unbound unbound;
};

/// The clips for another skeleton and model, bound by the names of channels. If both skeletons have the same
/// signature, joints bind by index. Weights and property components bind by index if both lists of names are equal and
/// none is empty. Local transforms do not change (rebind_clip). Joints that a clip does not move have the rest values
/// in `to`. If nothing differs, the result is the same clip handle; otherwise it shares keys where possible.
/// in   clips  compiled for `from`
/// cost O(names + clips * (joints + weights + numbers)), allocates
SINEW_API BoundClips bind_clips(std::span<const Clip> clips, const ClipChannels& from, const ClipChannels& to);

}  // namespace sinew
