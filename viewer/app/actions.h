// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/keys.h"
#include "viewer/app/playback.h"
#include "viewer/app/settings.h"

namespace sinew::viewer {

/// Does what a key asks of the settings.
/// out  false when the action is of something else, and nothing was done
bool apply(Action action, Settings& settings) noexcept;

/// The same of playback.
bool apply(Action action, Playback& playback);

}  // namespace sinew::viewer
