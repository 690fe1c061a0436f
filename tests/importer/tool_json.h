// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "importer/tool/json.h"

namespace sinew::test {

/// The document of a command, read from its text.
inline nlohmann::ordered_json parsed(const tool::Json& json) { return nlohmann::ordered_json::parse(json.dump()); }

/// A document of a test as commands make them.
inline tool::Json tool_json(const nlohmann::ordered_json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_null()) return nullptr;
  tool::Json out = json.is_object() ? tool::Json::object() : tool::Json::array();
  for (const auto& [key, value] : json.items())
    if (json.is_object())
      out[key] = tool_json(value);
    else
      out.push_back(tool_json(value));
  return out;
}

}  // namespace sinew::test
