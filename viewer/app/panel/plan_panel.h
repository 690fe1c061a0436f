// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/panel/panel.h"

namespace sinew::viewer {

/// Lays out the window of the live plan with ImGui calls, one row per stage.
/// io   open   becomes false when the user closes the window
void lay_out_plan(const PanelFacts& facts, bool& open);

}  // namespace sinew::viewer
