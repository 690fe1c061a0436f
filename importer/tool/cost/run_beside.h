// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace sinew::cost {

/// Runs a program that lies in the folder of this one, and returns what it prints to stdout. Its stderr is discarded.
/// err   a sentence for the user, if there is no such program or it did not end with status 0
tl::expected<std::string, std::string> output_of_program_beside(const std::string& program,
                                                                const std::vector<std::string>& arguments);

}  // namespace sinew::cost
