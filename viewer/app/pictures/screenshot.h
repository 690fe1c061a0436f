// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "viewer/app/settings.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// Writes what the window shows, without its panel, to the first free name of sinew-0001.png, sinew-0002.png, ... in
/// the working folder. Edges are smooth, as in pictures.
/// out  one sentence: the file, or why there is none
/// err  DeviceError
std::string write_screenshot(Device& device, ShownScene& shown, const View& view, RenderOptions look,
                             const Settings& settings, VkExtent2D size, const TextureFilter& filter);

}  // namespace sinew::viewer
