// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace sinew::tool {

/// All rules with their severities and sentences, in lines of at most 100 columns where words allow it.
std::string rules_text();

/// The same as JSON: [{rule, severity, sentence}], indented.
std::string rules_json();

}  // namespace sinew::tool
