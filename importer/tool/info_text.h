// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json.hpp>

namespace sinew::tool {

/// The document of info_json.h as text for people.
std::string info_text(const nlohmann::ordered_json& info);

}  // namespace sinew::tool
