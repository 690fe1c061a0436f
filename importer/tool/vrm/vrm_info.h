// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "importer/vrm.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// What `sinew info` says about a VRM character: its bones, expressions, springs and constraints, with the file's node
/// numbers.
nlohmann::ordered_json vrm_json(const VrmCharacter& vrm, const Scene& scene);

/// The same as lines of text.   in   what vrm_json() made
std::string vrm_text(const nlohmann::ordered_json& vrm);

}  // namespace sinew::tool
