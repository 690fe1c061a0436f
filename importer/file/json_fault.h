// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace sinew {

/// Says where and why text is no JSON: "line 2, column 7: Missing a colon after a name of object member.". RapidJSON's
/// reader finds the fault. It also refuses a zero with a huge exponent ("0e999"), which read_json() accepts.
/// in     text that read_json() refuses
/// out    not empty
/// cost   O(text), several times that of read_json()
std::string describe_json_fault(std::string_view text);

}  // namespace sinew
