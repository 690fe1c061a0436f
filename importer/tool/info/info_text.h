// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json.hpp>

namespace sinew::tool {

/// The document that info_json() makes, as text for people.
/// in    all   list every warning and every joint, not one warning of each rule and the first joints
std::string info_text(const nlohmann::ordered_json& info, bool all);

/// The same in one line.
std::string info_line(const nlohmann::ordered_json& info);

}  // namespace sinew::tool
