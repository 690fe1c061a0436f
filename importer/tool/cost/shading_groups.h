// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/cost/normal_angles.h"
#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Measures the viewer's texture filters and interpolations of normals on this machine's Vulkan device. Filters are
/// drawn on a plane that reaches the horizon, with their error against supersampling; normals on a sphere.
/// Neither depends on a file. A separate program (tests/study) does it, so that this program needs no Vulkan.
/// out  JSON as tests/study/shading_main.cpp writes it, for the groups below; if measuring fails, they give the reason
std::string measure_shading(bool quick);

Group filter_group(const std::string& measured);

/// The group for a file without textures: it has no points and says why.
Group no_filters();

/// Interpolations of normals: degrees off the great arcs of a scene, and the time that was measured.
/// in   angles  of the scene
Group normal_interpolation_group(const NormalAngles& angles, const std::string& measured);

}  // namespace sinew::cost
