// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Puts floats right that an encoder has rounded: colours and weights are clamped to [0, 1], the weights of a vertex
/// are divided by their sum where rounding to floats does not explain it, and the handedness of a tangent becomes +1 or
/// -1.
/// in       primitive  whose `decoded` attributes have just been decoded
/// warning  draco-range, once for the primitive
/// cost     O(elements)
void mend_decoded(gltf::Document& document, const gltf::Primitive& primitive, const gltf::Json& decoded,
                  const std::string& place, IssueLog& log);

}  // namespace sinew
