// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"

namespace sinew::tool {

/// The document that info_json() makes, as text for people.
/// in    all   list every warning and every joint, not one warning of each rule and the first joints
std::string info_text(const Json& info, bool all);

/// The same in one line.
std::string info_line(const Json& info);

}  // namespace sinew::tool
