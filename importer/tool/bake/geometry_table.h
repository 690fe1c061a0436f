// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::tool {

/// A table of the meshes of a geometry cache with their certificates: budget asked for, error measured at frames and
/// between them; and a line with its frames and bytes beside raw floats.
std::string geometry_table(const GeometryCache& cache);

/// The same for programs.
nlohmann::ordered_json geometry_json(const GeometryCache& cache);

}  // namespace sinew::tool
