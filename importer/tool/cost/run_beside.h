// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace sinew::cost {

/// What a program that lies in the folder of this one prints to stdout; what it complains of is not shown.
/// err  in words: there is no such program, or it ended in another way than with status 0
tl::expected<std::string, std::string> output_of_program_beside(const std::string& program,
                                                                const std::vector<std::string>& arguments);

}  // namespace sinew::cost
