// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/app/loaded_scene.h"
#include "viewer/app/options.h"
#include "viewer/app/reload/scene_reloader.h"

namespace sinew::viewer {

/// Opens the window and plays until the user closes it.
/// in   clip   shown first; kNone = the rest pose; empty = the first clip
///      watch  reloads the scene when its files change; null = never
/// io   loaded_scenes  get centers of rotation when the user chooses that skinning method
/// out  exit code of the program: 0; 1 = a geometry cache is damaged; 3 = Options::validate is set and the validation
///      layer reported something
/// err  DeviceError if there is no display or no device
int run_window(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
               SceneReloader* watch);

}  // namespace sinew::viewer
