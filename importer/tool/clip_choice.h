// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// The poses that a person asks for: kNone stands for the rest pose.
using ClipChoice = std::vector<std::uint32_t>;

/// Reads `--clip INDEX|NAME|none`; without it the rest pose and all clips. A number is an index first, a name second;
/// of several clips of one name the first is meant.
/// err  a sentence that names the clips there are
tl::expected<ClipChoice, std::string> choose_clips(const Scene& scene, const std::optional<std::string>& wanted);

}  // namespace sinew::tool
