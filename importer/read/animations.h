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

/// `mesh_weights` are the default weights of a mesh, for all nodes without weights of their own; `pointed` is anything
/// else that a pointer names.
enum class AnimatedProperty : std::uint8_t { translation, rotation, scale, weights, mesh_weights, pointed };

/// What a channel moves.
struct ChannelTarget {
  AnimatedProperty property = AnimatedProperty::translation;
  std::uint32_t node = kNone;     ///< the mesh of mesh_weights
  std::uint32_t element = kNone;  ///< one of the weights; kNone = all of them
  PropertyTarget pointed = {};    ///< of a pointed property, with the file's index

  friend auto operator<=>(const ChannelTarget&, const ChannelTarget&) = default;

  bool moves_joint() const noexcept { return property < AnimatedProperty::weights; }
};

/// Nothing where the channel is to be ignored: no node (G21), an unknown path, a pointer to something that the runtime
/// does not animate or the file does not define (G58).
/// err  reference (a pointer past the end);  warning animation-no-target, animation-path, animation-pointer
std::optional<ChannelTarget> read_channel_target(const gltf::Document& document, std::uint32_t animation,
                                                 std::uint32_t channel, IssueLog& log);

/// Times and values of one sampler as the file has them.
struct SamplerData {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;  ///< [K * components] or [K * 3 * components] for cubic_spline (G03, G19)
};

/// Reads the sampler of a channel and holds it to the shape of its property: `components` 3, 4, the number of morph
/// targets (G16), or those of a pointed property. Nothing where the channel must be left out; the rest of the animation
/// stays (G08, G09, G13, G14). err  animation-input, animation-output;  warning animation-interpolation,
/// animation-no-keys, animation-cubic-keys,
///      animation-times, animation-time-repeated, animation-values, animation-flag
std::optional<SamplerData> read_sampler(const gltf::Document& document, std::uint32_t animation, std::uint32_t sampler,
                                        const ChannelTarget& target, std::uint32_t components, IssueLog& log);

}  // namespace sinew
