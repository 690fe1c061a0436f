// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Repairs floats that a lossy encoder changed. Clamps colours and weights to [0, 1], normalises weights whose sum
/// deviates by more than float rounding, and sets the handedness of tangents to +1 or -1.
/// in       primitive  its `decoded` attributes have just been decoded
/// warning  draco-range, once for the primitive
/// cost     O(elements)
void mend_decoded(gltf::Document& document, const gltf::Primitive& primitive, const gltf::Json& decoded,
                  const std::string& place, IssueLog& log);

/// Removes min and max of accessors that could not be decoded, so that they are not checked.
void forget_bounds(gltf::Document& document, const gltf::Primitive& primitive);

}  // namespace sinew
