// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/file/document_materials.h"
#include "importer/issue_log.h"
#include "runtime/animation/annotations.h"

namespace sinew {

/// Reads the events and curves of an animation from its `extras`:
///
///     "events": [{"time": 0.4, "name": "left foot"}],
///     "curves": {"trail": {"blend": "mean", "keys": [{"time": 0, "value": 1.5, "step": "linear"}]}}
///
/// A value is a number, a flag, or a list of two to four numbers. `"type": "rotation"` makes four numbers a rotation
/// (x y z w). "step" is linear, hold or cubic; cubic keys have "in" and "out" tangents, per second.
/// in       extras   any JSON; place  its pointer;  duration_s  of the animation
/// warning  animation-extras: an entry of another form is left out, as is an event outside of the animation
Annotations read_annotations(const gltf::Json& extras, const std::string& place, double duration_s, IssueLog& log);

/// Writes events and curves into the `extras` of an animation, in place of those that it has; other extras stay.
/// read_annotations reads them back.
/// in       animation   a JSON object
void set_annotations(const Annotations& annotations, gltf::Json& animation);

}  // namespace sinew
