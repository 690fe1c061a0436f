// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "importer/graph/graph_text.h"
#include "importer/graph/program_document.h"

namespace sinew {

/// Reads the text of a pose program. Unknown keys are refused by name, except `editor`.
/// err  the first fault: no JSON, an unknown or missing key, a wrong type or word
GraphTextResult<ProgramDocument> read_program(std::string_view text);

}  // namespace sinew
