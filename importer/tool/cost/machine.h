// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace sinew::cost {

/// What the times depend on, as names and values for people: processor, cores, load, system, compiler, build,
/// instructions, date.
std::vector<std::pair<std::string, std::string>> describe_machine();

}  // namespace sinew::cost
