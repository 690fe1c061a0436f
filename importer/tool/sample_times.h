// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/bone_animation.h"

namespace sinew::tool {

/// Reads `--times T,T,...`: finite seconds, in the order given.
tl::expected<std::vector<double>, std::string> parse_times(const std::string& list);

/// Times for `sinew sample` if the user names none: the start, and five keys from the first to the last. After each key
/// follows the middle of its interval. Increasing; exact float32 values, so that keys are hit.
/// in    animation   may be empty; the result is then {0}
std::vector<double> representative_times(const Animation& animation);

/// 0, 1/fps, 2/fps, ... up to the clip's end, and the end itself.
std::vector<double> frame_times(double duration_s, double fps);

}  // namespace sinew::tool
