// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Splits a joint's name into lower-case words, at every character that is no letter and before capitals.
/// "lowerarm_twist_01_l" gives lowerarm, twist, l. The last word may be empty. Internal to retarget/
std::vector<std::string> name_words(std::string_view name);

}  // namespace sinew
