// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::viewer {

/// The animated quantity of a channel.
enum class ChannelKind : std::uint8_t { position, rotation, scale, morph_weights, property };

/// One keyed quantity of a clip, as the timeline shows it. The times belong to the scene.
struct Channel {
  ChannelKind kind = ChannelKind::position;
  std::uint32_t owner = kNone;  ///< joint; index into Scene::instances (morph_weights); into Animation::properties
  std::span<const float> times_s;
};

/// All channels with keys of a clip: those of a joint one after another, then morph weights, then properties. kNone and
/// clips without tracks, such as those of a .sinew file, have none.
std::vector<Channel> channels_of(const Scene& scene, std::uint32_t clip);

/// "hip rotation"; what has no name has its number.
std::string channel_label(const Scene& scene, std::uint32_t clip, const Channel& channel);

/// Name of a joint for lists; never empty.
std::string joint_label(const Scene& scene, std::uint32_t joint);

/// The track of a joint at a time, from the clip as authored: metres, degrees about fixed x, y and z axes, or factors.
/// The first and the last key hold beyond them; a joint without keys rests.
/// cost O(bones + log K)
glm::dvec3 curve_value(const Scene& scene, std::uint32_t clip, std::uint32_t joint, ChannelKind kind, double time_s);

/// The key times of all channels together, each once, in order.
std::vector<float> all_key_times(std::span<const Channel> channels);

/// Distance of the marks of a ruler: the smallest of 1, 2, 5, 10, ... times the unit that is at least as large.
/// in   least, unit  above 0
double ruler_step(double least, double unit);

}  // namespace sinew::viewer
