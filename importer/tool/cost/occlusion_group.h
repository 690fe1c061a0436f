// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Measures the viewer's ambient occlusion on the Vulkan device of this machine, each variant with its error against
/// ray casting. A separate program (tests/study) does it, so that this program needs no Vulkan. If that program fails,
/// the group says why.
/// in   arguments  of sinew-occlusion-study
Group look_at_occlusion(const std::vector<std::string>& arguments);

/// Arguments for that program: a clip of a file, or the program's built-in scene if `file` is empty.
/// in   clip  kNone = the pose at rest
std::vector<std::string> occlusion_arguments(const std::string& file, std::uint32_t clip, bool quick);

/// Makes the group from the output of that program: JSON as tests/study/occlusion_main.cpp writes it.
Group occlusion_group(const std::string& answer);

}  // namespace sinew::cost
