// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/normal_angles.h"
#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Measures the viewer's texture filters, on a plane that reaches the horizon, each with its error against
/// supersampling, and both its interpolations of normals, on a sphere, on the Vulkan device of this machine. Neither
/// depends on a file. A separate program (tests/study) does it, so that this program needs no Vulkan.
/// out  JSON as tests/study/shading_main.cpp writes it, for the groups below; they say why where that fails
std::string measure_shading(bool quick);

Group filter_group(const std::string& measured);

/// For a file without textures, which calls for none.
Group no_filters();

/// Interpolations of normals: degrees off the great arcs of a scene, and the time that was measured.
/// in   angles  of the scene
Group normal_interpolation_group(const NormalAngles& angles, const std::string& measured);

}  // namespace sinew::cost
