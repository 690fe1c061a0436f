// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Measures the viewer's texture filters on the Vulkan device of this machine, on a plane that reaches the horizon,
/// each with its error against supersampling. It does not depend on a file. A separate program (viewer/study) does it,
/// so that this program needs no Vulkan. Where that fails, the group says why.
Group look_at_filters(bool quick);

/// The same for a file without textures, which calls for none.
Group no_filters();

/// Makes the group from the output of that program: JSON as viewer/study/shading_main.cpp writes it.
Group filter_group(const std::string& answer);

}  // namespace sinew::cost
