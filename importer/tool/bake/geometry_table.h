// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::tool {

/// "positions", "normals", "colours".
const char* name_of(GeometryKind kind);

/// An error of a stream in its unit: a length, an angle that a unit vector so far off may turn by, or a difference.
std::string error_text(GeometryKind kind, double error);

/// A table of the streams of a geometry cache with their certificates: budget asked for, error measured at frames and
/// between them; and lines with its frames and bytes beside raw floats, bytes a second, and what a seek decodes.
std::string geometry_table(const GeometryCache& cache);

/// The same for programs.
nlohmann::ordered_json geometry_json(const GeometryCache& cache);

}  // namespace sinew::tool
