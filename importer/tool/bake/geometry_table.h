// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::tool {

/// "positions", "normals", "colours".
const char* name_of(GeometryKind kind);

/// An error of a stream in its unit: a length, an angle that a unit vector so far off may turn by, or a difference.
std::string error_text(GeometryKind kind, double error);

/// A table of the streams of a geometry cache, with the budget and the measured errors of each. Lines below it give
/// frames, bytes, bytes a second, and the number of frames that a seek decodes.
std::string geometry_table(const GeometryCache& cache);

/// The same facts as JSON.
Json geometry_json(const GeometryCache& cache);

}  // namespace sinew::tool
