// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include <imgui.h>

namespace sinew::viewer {

/// Lays out a line of text as it is: a % in it is no format.
inline void show_text(std::string_view line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }

}  // namespace sinew::viewer
