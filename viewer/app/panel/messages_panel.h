// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

namespace sinew::viewer {

/// A badge with the number of warnings of the shown files, which opens their list. Lays out nothing without warnings.
void lay_out_messages(std::span<const std::string> messages);

}  // namespace sinew::viewer
