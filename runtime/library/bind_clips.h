// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/clip/clip.h"
#include "runtime/library/clip_channels.h"

namespace sinew {

/// What clips move and has no place where they were bound. A name stands once, whatever the number of clips.
struct Unbound {
  std::vector<std::string> missing;    ///< by name; what has none is described: "joint 3 without a name"
  std::vector<std::string> ambiguous;  ///< several have the name, here or there: none of them was taken

  bool empty() const noexcept { return missing.empty() && ambiguous.empty(); }
  /// Adds the names that are not yet listed.     cost O(names of both), expected
  void add(const Unbound& more);
};

struct BoundClips {
  std::vector<Clip> clips;
  Unbound unbound;
};

/// The clips for another skeleton and model, by names. Skeletons of equal signature bind joint by joint, whatever their
/// names; weights and numbers bind one by one where all have names and both lists are the same.
/// Local transforms are copied as they are (rebind_clip). Joints that a clip does not move rest as `to` rests.
/// A clip for which nothing differs is the same handle. Others share what keys they can.
/// in   clips  compiled for `from`
/// cost O(names + clips * (joints + weights + numbers)), allocates
BoundClips bind_clips(std::span<const Clip> clips, const ClipChannels& from, const ClipChannels& to);

}  // namespace sinew
