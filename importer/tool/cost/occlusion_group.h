// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Ambient occlusion of the viewer on this machine's Vulkan device, each way with its error against ray casting. A
/// program of its own (viewer/study) measures, so that this one needs no Vulkan; the group says why where it cannot. in
/// arguments  of sinew-occlusion-study: FILE, --clip, --quick
Group look_at_occlusion(const std::vector<std::string>& arguments);

/// The group that its answer makes: JSON as viewer/study/main.cpp writes it.
Group occlusion_group(const std::string& answer);

}  // namespace sinew::cost
