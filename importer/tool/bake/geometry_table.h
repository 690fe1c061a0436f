// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::tool {

/// The name of a kind for people: "positions", "normals", "colours".
const char* name_of(GeometryKind kind);

/// The error of a stream with its unit: a length of positions, an angle of normals, or a difference of colours.
std::string error_text(GeometryKind kind, double error);

/// A table of the streams of a geometry cache, with the budget and the measured errors of each. Lines below it give
/// frames, bytes, bytes a second, and the number of frames that a seek decodes.
std::string geometry_table(const GeometryCache& cache);

/// The same facts as JSON.
Json geometry_json(const GeometryCache& cache);

}  // namespace sinew::tool
