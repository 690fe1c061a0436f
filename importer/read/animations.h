// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/animation/property_track.h"
#include "runtime/animation/track.h"

namespace sinew {

/// The property that a channel animates. `mesh_weights`: default weights of a mesh, used by all nodes without own
/// weights. `pointed`: any other property, through KHR_animation_pointer.
enum class AnimatedProperty : std::uint8_t { translation, rotation, scale, weights, mesh_weights, pointed };

/// Target of a channel.
struct ChannelTarget {
  AnimatedProperty property = AnimatedProperty::translation;
  std::uint32_t node = kNone;     ///< index of the node; for mesh_weights, that of the mesh
  std::uint32_t element = kNone;  ///< index of a single weight; kNone = all weights
  PropertyTarget pointed = {};    ///< for AnimatedProperty::pointed, with the file's index

  friend auto operator<=>(const ChannelTarget&, const ChannelTarget&) = default;

  bool moves_joint() const noexcept { return property < AnimatedProperty::weights; }
  bool moves_weights() const noexcept {
    return property == AnimatedProperty::weights || property == AnimatedProperty::mesh_weights;
  }
};

/// Finds the target of a channel.
/// out      empty for ignored channels: no node, an unknown path, or a pointer to something that the runtime does not
///          animate or the file does not define
/// err      reference (a pointer with an index out of range; survived)
/// warning  animation-no-target, animation-path, animation-pointer
std::optional<ChannelTarget> read_channel_target(const gltf::Document& document, std::uint32_t animation,
                                                 std::uint32_t channel, IssueLog& log);

/// Times and values of one sampler, as in the file.
struct SamplerData {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;  ///< [K * components], or [K * 3 * components] for cubic_spline, with tangents
};

/// Reads the sampler of a channel and checks it against the animated property.
/// in       components   3, 4, the number of morph targets, or that of a pointed property
/// out      empty if the channel must be dropped; the rest of the animation stays. A single key of a cubic spline
///          becomes a step key
/// err      survived: animation-input, animation-output, animation-times (also where keys before 0 are cut),
///          animation-values
/// warning  animation-interpolation, animation-no-keys, animation-cubic-keys, animation-time-repeated, animation-flag,
///          animation-stride, animation-bounds
std::optional<SamplerData> read_sampler(const gltf::Document& document, std::uint32_t animation, std::uint32_t sampler,
                                        const ChannelTarget& target, std::uint32_t components, IssueLog& log);

}  // namespace sinew
