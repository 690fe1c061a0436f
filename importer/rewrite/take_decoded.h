// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Replaces compressed data (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression) by the
/// decoded data of the import. Accessors get the decoder's type and count, and bounds of the decoded elements.
void take_decoded(const gltf::Document& document, Draft& draft);

/// True for an accessor with min or max. Some files have only one, although glTF requires both.
inline bool has_bounds(const Json& accessor) { return accessor.contains("min") || accessor.contains("max"); }

/// Sets min and max of an accessor from its elements.
/// in    stored   values as returned by read_stored()
void set_bounds(Json& accessor, const std::vector<double>& stored, std::size_t components);

}  // namespace sinew::rewrite
