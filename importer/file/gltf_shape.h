// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/json_shape.h"

namespace sinew {

/// Schema of a glTF 2.0 document, as far as the importer reads it: types, ranges, allowed words, required properties.
/// read_document() relies on it and would misread values of a wrong type.
const JsonValueShape& gltf_shape();

}  // namespace sinew
