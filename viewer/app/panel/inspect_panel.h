// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/panel/panel.h"

namespace sinew::viewer {

/// Lays out the window that looks inside the scene, at the right. It has the tree of nodes, the values of the inspected
/// joint and vertex, and choices of what is drawn over the picture.
/// in   free  the part of the window beside the panel
/// out  the part of `free` that this window leaves
FreePart lay_out_inspect(const PanelFacts& facts, Settings& settings, FreePart free);

}  // namespace sinew::viewer
