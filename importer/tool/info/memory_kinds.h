// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/tool/json.h"
#include "runtime/memory/memory_of.h"

namespace sinew::tool {

/// {"total": 1234, "skeletons": 34, ...} with the kinds that there are, in bytes.
Json memory_json(const MemoryBytes& bytes);

/// "memory: 1234 B (skeletons 34 B, clip keys 1200 B)" and the end of the line.
std::string memory_text(const Json& memory);

}  // namespace sinew::tool
