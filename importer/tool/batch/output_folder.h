// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <tl/expected.hpp>

#include "importer/tool/batch/input_list.h"

namespace sinew::tool {

/// Names the output of every file: the folder, the path of the file below the folder that was given, and the
/// extension in place of the file's. Makes the folders that are needed.
/// in       extension   with its dot
/// in,out   list        Input::output is filled
/// err      a sentence: two files would have one output, an output would replace an input, a folder cannot be made
tl::expected<void, std::string> name_outputs(InputList& list, const std::string& folder, const std::string& extension);

}  // namespace sinew::tool
