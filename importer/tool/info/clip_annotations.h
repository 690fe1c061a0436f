// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "runtime/animation/annotations.h"

namespace sinew::tool {

/// Adds "events" and "curves" to the JSON of a clip.
void add_annotations(const Annotations& annotations, Json& clip);

/// The lines that name the events and curves of a clip; empty without any.
/// in   clip   JSON with "name" and what add_annotations adds
std::string annotation_lines(const Json& clip);

}  // namespace sinew::tool
