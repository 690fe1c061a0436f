// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/plan/needs.h"

namespace sinew::tool {

/// The skinning methods by their names on the command line.
inline const std::map<std::string, Skinning> kSkinningNames = {{"linear", Skinning::linear},
                                                               {"dual-quaternion", Skinning::dual_quaternion},
                                                               {"center-of-rotation", Skinning::center_of_rotation}};

/// All names, with `more` at the end.
inline std::vector<std::string> skinning_names(std::vector<std::string> more = {}) {
  for (const auto& [name, kind] : kSkinningNames) more.insert(more.begin(), name);
  return more;
}

/// True if a list of names holds `wanted` or "all".
inline bool names_skinning(const std::vector<std::string>& names, std::string_view wanted) {
  return std::any_of(names.begin(), names.end(), [&](const auto& name) { return name == wanted || name == "all"; });
}

}  // namespace sinew::tool
