// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/panel/panel.h"

namespace sinew::viewer {

/// Lays out the timeline at the lower edge of the window: play controls, and a ruler with the keys of the clip.
/// Settings::timeline_keys adds a row of keys for each channel, and the curve of the joint that is looked at.
/// in   free  the part of the window beside the panel, which the timeline shares
/// out  the part of `free` that the timeline leaves
FreePart lay_out_timeline(const PanelFacts& facts, Settings& settings, Playback& playback, FreePart free);

}  // namespace sinew::viewer
