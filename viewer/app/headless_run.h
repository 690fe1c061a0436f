// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/compare/comparison.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/options.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

/// Clip time of a picture: picture / fps, wrapped to the clip's duration. A time exactly at the end is not wrapped.
double picture_time_s(std::uint32_t picture, double fps, double duration_s) noexcept;

/// Decides if exposure must follow the picture, by drawing the model once, or twice if light clips it.
/// out  one sentence that says so; empty = the exposure of the options stays
/// err  DeviceError when the device fails
std::string adapt_exposure(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip);

/// Renders and writes the requested picture, or numbered pictures DIR/00000.png and so on. Needs no display.
/// in   clip  kNone = rest pose
/// out  exit code of the program: 0 = done, 1 = the geometry cache is damaged, 3 = a file cannot be written or the
///      validation layer reported something
/// err  DeviceError when the device fails
int write_pictures(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip);

/// Same, for several evaluations of each moment side by side (comparison.h). Prints how far they are apart.
/// out  exit code of the program, also 2 = the files cannot be compared
int write_comparison(Device& device, const Options& options, const std::vector<LoadedScene>& loaded_scenes,
                     const std::vector<CompareView>& views, std::uint32_t clip);

/// Writes one picture of all clips: a row for each, with five poses from its start to its end. Prints which row is
/// which clip.
int write_sheet(Device& device, const Options& options, const LoadedScene& loaded);

}  // namespace sinew::viewer
