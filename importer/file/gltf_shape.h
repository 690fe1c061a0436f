// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/json_shape.h"

namespace sinew {

/// The JSON shape of a glTF 2.0 document, as far as the importer reads it: types, ranges, allowed words, required
/// properties. The parser behind it skips what it does not understand (T1, T2), so this runs before it.
const JsonValueShape& gltf_shape();

}  // namespace sinew
