// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "runtime/memory/memory_of.h"

namespace sinew::tool {

/// {"total": 1234, "skeletons": 34, ...} in bytes, with the kinds that are not 0.
Json memory_json(const MemoryBytes& bytes);

/// "memory: 1234 B (skeletons 34 B, clip keys 1200 B)" and a line end.
std::string memory_text(const Json& memory);

}  // namespace sinew::tool
