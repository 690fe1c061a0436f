// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/assets/scene.h"

namespace sinew::viewer {

/// The clip that `text` names: "none" is the rest pose (kNone), digits are an index, anything else a name. A clip whose
/// name is made of digits is found by name when no index fits; one named "none" by its index only.
/// err  nothing when the scene has no such clip
std::optional<std::uint32_t> choose_clip(const Scene& scene, std::string_view text);

/// "--clip Fly: no such clip; the scene has 0 \"Survey\", 1 \"Walk\""
std::string describe_missing_clip(const Scene& scene, std::string_view text);

/// The name for menus: never empty.
std::string clip_label(const Scene& scene, std::uint32_t clip);

}  // namespace sinew::viewer
