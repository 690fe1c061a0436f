// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "viewer/app/loaded_scene.h"
#include "viewer/app/reload/background_reload.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// Makes the job that reloads the changed file and prepares all that the display needs: centers of rotation and ambient
/// visibility. It holds only copies.
BackgroundReload::Read make_reload_job(const Options& options, const LoadedScene& loaded, ShownScene& shown);

/// Uploads a scene to the device.
using MakeShown = std::function<std::unique_ptr<ShownScene>(const LoadedScene& loaded, const Evaluation& evaluation)>;

/// Replaces the shown scene by `changed`, between two pictures. Keeps the clip (by name), time, speed, looping and
/// evaluation settings. The pose at that time is ready for the next picture.
/// io   loaded, shown  the current scene, replaced. Waits for the device before freeing the old one.
/// err  one sentence if the device cannot hold the new scene; then the old scene is shown again
/// cost waits for the device and for one pose; uploads the scene
tl::expected<void, std::string> replace_shown_scene(const Device& device, LoadedScene changed, LoadedScene& loaded,
                                                    std::unique_ptr<ShownScene>& shown, const MakeShown& make);

}  // namespace sinew::viewer
