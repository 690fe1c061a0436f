// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json.hpp>

namespace sinew::tool {

/// The document that info_json() makes, as text for people.
std::string info_text(const nlohmann::ordered_json& info);

}  // namespace sinew::tool
