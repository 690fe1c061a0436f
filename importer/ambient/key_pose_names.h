// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace sinew {

/// Vertex attribute for ambient visibility: one float in [0, 1] per vertex. In glTF, names with an underscore are
/// application-specific, so other programs ignore it. COLOR_0 would be wrong: it multiplies the base colour and would
/// also darken direct light. Normalised integers would save nothing, because vertex attributes are aligned to four
/// bytes.
inline constexpr const char* kAmbientVisibilityAttribute = "_AMBIENT_ACCESS";

/// Identifies the key pose of a clip that a vertex attribute belongs to.
struct KeyPoseName {
  std::uint32_t clip = 0;  ///< index of the animation
  std::uint32_t pose = 0;  ///< index of the pose (key_pose_times()), below kMostKeyPoses
};

/// The attribute's name: _AMBIENT_ACCESS_2_5 is pose 5 of animation 2. The name holds all information, so nothing else
/// in the file changes.
std::string name_of_key_pose(const KeyPoseName& key);

/// Parses an attribute name. Empty for all other names, including similar ones such as _AMBIENT_ACCESS_02_5.
std::optional<KeyPoseName> key_pose_named(const std::string& name);

}  // namespace sinew
