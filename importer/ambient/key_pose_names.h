// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace sinew {

/// The vertex attribute of a file that holds ambient access: one float in [0, 1] a vertex. Names with an underscore are
/// the application's own in glTF, so other programs pass over it. COLOR_0 would be no place for it: that multiplies the
/// base colour, and so darkens the light of lamps too. Normalised integers would save nothing, because vertex
/// attributes are aligned to four bytes.
inline constexpr const char* kAmbientAccessAttribute = "_AMBIENT_ACCESS";

/// A key pose of a clip, which has a vertex attribute of its own.
struct KeyPoseName {
  std::uint32_t clip = 0;  ///< index of the animation
  std::uint32_t pose = 0;  ///< of the poses that are spread evenly over it (key_pose_times()), below kMostKeyPoses
};

/// The name of its attribute: _AMBIENT_ACCESS_2_5 is pose 5 of animation 2. The names say all, so nothing else of a
/// file changes.
std::string name_of_key_pose(const KeyPoseName& key);

/// The key pose that an attribute holds. Nothing for other names, also those that only look alike, such as
/// _AMBIENT_ACCESS_02_5.
std::optional<KeyPoseName> key_pose_named(const std::string& name);

}  // namespace sinew
