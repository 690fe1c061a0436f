// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/motion/character_rig.h"
#include "viewer/app/motion/motion_settings.h"
#include "viewer/app/panel/panel.h"

namespace sinew::viewer {

/// Lays out what moves a character besides its clip: root motion, cross-fade, layers, springs and expressions. Each
/// part appears only where the scene has it.
void lay_out_motion(const PanelFacts& facts, MotionSettings& settings);

/// Lays out a motion graph: a slider for each parameter, the states that play, and the program of the pose as a list.
void lay_out_graph(const PanelFacts& facts);

}  // namespace sinew::viewer
