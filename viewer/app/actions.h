// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/keys.h"
#include "viewer/app/playback.h"
#include "viewer/app/settings.h"

namespace sinew::viewer {

/// Applies an action that changes settings, such as toggling ambient occlusion.
/// out  false (and no change) when the action does not concern settings
bool apply(Action action, Settings& settings) noexcept;

/// Applies an action that changes playback, such as pausing. Returns false for all other actions.
bool apply(Action action, Playback& playback);

}  // namespace sinew::viewer
