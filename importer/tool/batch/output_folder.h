// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <tl/expected.hpp>

#include "importer/tool/batch/input_list.h"

namespace sinew::tool {

/// Sets the output path of every input: `folder`, then the path below the input folder, with a new extension. Creates
/// missing folders.
/// in       extension   with its dot
/// in,out   list        Input::output is filled
/// err      a sentence: two files would have one output, an output would replace an input, a folder cannot be made
tl::expected<void, std::string> name_outputs(InputList& list, const std::string& folder, const std::string& extension);

}  // namespace sinew::tool
