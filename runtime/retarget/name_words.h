// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Words of a joint's name in small letters, parted by all that is no letter and before capitals: "lowerarm_twist_01_l"
/// is lowerarm, twist, l. The last one may be empty. Internal to retarget/
std::vector<std::string> name_words(std::string_view name);

}  // namespace sinew
