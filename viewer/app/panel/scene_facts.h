// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/panel/panel.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// The facts of the panel that the shown scene knows. They are valid until its next request.
PanelFacts scene_facts(ShownScene& shown);

}  // namespace sinew::viewer
