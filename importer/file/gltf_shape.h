// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/json_shape.h"

namespace sinew {

/// The JSON shape of a glTF 2.0 document, as far as the importer reads it: types, ranges, allowed words, required
/// properties. It is checked before read_document(), which relies on it and would otherwise misread values of a wrong
/// type (T1, T2).
const JsonValueShape& gltf_shape();

}  // namespace sinew
