// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

namespace sinew::test {

using Json = nlohmann::json;

}  // namespace sinew::test
