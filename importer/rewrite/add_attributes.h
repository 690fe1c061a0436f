// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "importer/rewrite/draft.h"
#include "importer/rewrite_gltf.h"

namespace sinew::rewrite {

/// Removes attributes of these names from all primitives.
void leave_out_attributes(std::span<const std::string> names, Draft& draft);

/// Adds vertex attributes to primitives of the document; replaces existing ones of the same name.
/// in    attributes   one value for each vertex of the primitive
void add_attributes(std::span<const AddedAttribute> attributes, Draft& draft);

}  // namespace sinew::rewrite
