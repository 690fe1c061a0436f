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

/// Which property a channel animates. `mesh_weights` are the default weights of a mesh, which all nodes without weights
/// of their own use. `pointed` is any other property that KHR_animation_pointer names.
enum class AnimatedProperty : std::uint8_t { translation, rotation, scale, weights, mesh_weights, pointed };

/// What a channel animates.
struct ChannelTarget {
  AnimatedProperty property = AnimatedProperty::translation;
  std::uint32_t node = kNone;     ///< for mesh_weights: the mesh
  std::uint32_t element = kNone;  ///< one of the weights; kNone = all of them
  PropertyTarget pointed = {};    ///< for a pointed property, with the file's index

  friend auto operator<=>(const ChannelTarget&, const ChannelTarget&) = default;

  bool moves_joint() const noexcept { return property < AnimatedProperty::weights; }
  bool moves_weights() const noexcept {
    return property == AnimatedProperty::weights || property == AnimatedProperty::mesh_weights;
  }
};

/// Finds the target of a channel.
/// out      nothing for a channel that is ignored: it names no node (G21), an unknown path, or by a pointer something
///          that the runtime does not animate or the file does not define (G58)
/// err      reference (a pointer past the end)
/// warning  animation-no-target, animation-path, animation-pointer
std::optional<ChannelTarget> read_channel_target(const gltf::Document& document, std::uint32_t animation,
                                                 std::uint32_t channel, IssueLog& log);

/// Times and values of one sampler, as the file has them.
struct SamplerData {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;  ///< [K * components] or [K * 3 * components] for cubic_spline (G03, G19)
};

/// Reads the sampler of a channel and checks that it has the shape of the animated property.
/// in       components   3, 4, the number of morph targets (G16), or those of a pointed property
/// out      nothing where the channel must be left out; the rest of the animation stays (G09, G13, G14). A single key
/// of
///          a cubic spline becomes a step (G08)
/// err      animation-input, animation-output
/// warning  animation-interpolation, animation-no-keys, animation-cubic-keys, animation-times, animation-time-repeated,
///          animation-values, animation-flag, animation-stride, animation-bounds
std::optional<SamplerData> read_sampler(const gltf::Document& document, std::uint32_t animation, std::uint32_t sampler,
                                        const ChannelTarget& target, std::uint32_t components, IssueLog& log);

}  // namespace sinew
