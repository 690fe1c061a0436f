// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "importer/import_error.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Gives clips the events and curves of a JSON text that lies beside the model, by clip names:
///
///     {"Walk": {"events": [{"time": 0.4, "name": "left foot"}], "curves": {}}}
///
/// Each clip has the form of `extras` in README.md. A clip that the text names loses the events and curves that it had.
/// out  animations  changed only if there is no issue
///      issues      json-syntax, animation-extras (an unknown clip, an entry of another form); all are errors
/// cost O(text), allocates
std::vector<ImportIssue> annotate_clips(std::span<Animation> animations, std::string_view json);
/// Does so for the animations of a scene, and for the clips that were compiled of them.
std::vector<ImportIssue> annotate_clips(Scene& scene, std::string_view json);

}  // namespace sinew
