// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "importer/vrm.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// The output of `sinew info` for a VRM character: bones, expressions, springs and constraints, with the node numbers
/// of the file.
Json vrm_json(const VrmCharacter& vrm, const Scene& scene);

/// The same as lines of text.   in   result of vrm_json()
std::string vrm_text(const Json& vrm);

}  // namespace sinew::tool
