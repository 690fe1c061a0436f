// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"

namespace sinew::viewer {

/// How a layer joins the pose below it.
enum class LayerUse : std::uint8_t {
  cover,         ///< it takes the place of the pose below, by weight and mask
  add_to_rest,   ///< its difference from the rest pose is added
  add_to_start,  ///< its difference from its own first pose is added
};

/// A clip that plays on top of the chosen one. It plays in step: both are at the same part of their duration.
struct LayerSetting {
  std::uint32_t clip = 0;
  float weight = 1.0f;
  std::uint32_t mask = kNone;  ///< the layer moves this joint and all joints below it; kNone = all joints
  bool mirrored = false;
  LayerUse use = LayerUse::cover;

  friend bool operator==(const LayerSetting&, const LayerSetting&) = default;
};

/// Where the motion of the root joint takes the character.
enum class RootPlay : std::uint8_t {
  as_in_clip,  ///< there and, at the end of each round, back to the start
  in_place,    ///< nowhere
  moving,      ///< on and on: each round begins where the last one ended
};

/// Everything besides the chosen clip that moves a character.
struct MotionSettings {
  bool mirrored = false;  ///< the chosen clip plays with left and right exchanged
  std::vector<LayerSetting> layers;
  RootPlay root = RootPlay::as_in_clip;
  float fade_s = 0.0f;               ///< duration of the cross-fade after another clip is chosen
  bool springs = true;               ///< springs and constraints of a VRM file move
  std::vector<float> morph_weights;  ///< [W] replace all morph weights; empty = those of the clip
  std::vector<float> expressions;    ///< values of the expressions of a VRM file; missing ones are 0

  friend bool operator==(const MotionSettings&, const MotionSettings&) = default;
};

}  // namespace sinew::viewer
