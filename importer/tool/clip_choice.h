// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// The clips that a user chooses; kNone stands for the rest pose.
using ClipChoice = std::vector<std::uint32_t>;

/// Reads `--clip INDEX|NAME|none`. Without the option it is the rest pose and all clips. A number is taken as an index
/// if there is such a clip, else as a name; of several clips with one name the first is taken. NAME#2 is the second
/// clip of that name. NAME#1 also finds clips called "3", "none" or nothing ("#1").
/// err   a sentence for the user that lists the clips of the file
tl::expected<ClipChoice, std::string> choose_clips(const Scene& scene, const std::optional<std::string>& wanted);

/// The clips with their numbers, for a message. If there are many, only the first few.
std::string list_of_clips(const Scene& scene);

}  // namespace sinew::tool
