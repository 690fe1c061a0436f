// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Replaces compressed data (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression) by what the
/// import has decoded. Accessors take the type and count of the decoder, and bounds are those of the decoded elements.
void take_decoded(const gltf::Document& document, Draft& draft);

/// True for an accessor with min or max. Some files have one alone, though glTF wants both.
inline bool has_bounds(const Json& accessor) { return accessor.contains("min") || accessor.contains("max"); }

/// Sets min and max of an accessor from its elements.
/// in    stored   as read_stored() gives them
void set_bounds(Json& accessor, const std::vector<double>& stored, std::size_t components);

}  // namespace sinew::rewrite
