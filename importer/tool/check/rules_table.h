// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace sinew::tool {

/// All rules with their severities, consequences and sentences, in lines of at most 100 columns where words allow it.
std::string rules_text();

/// The same as JSON: [{rule, severity, consequence, sentence}], indented.
std::string rules_json();

}  // namespace sinew::tool
