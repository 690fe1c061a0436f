// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>

#include "viewer/app/exhibit.h"
#include "viewer/app/options.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

/// Clip time of picture n of a range: n / fps, repeated from the start after the end of the clip. A picture exactly at
/// the end shows the end.
double picture_time_s(std::uint32_t picture, double fps, double duration_s) noexcept;

/// Writes the picture that the options ask for, or numbered pictures DIR/00000.png ... Needs no display.
/// in   clip  kNone = rest pose
/// out  exit code of the program: 0, 1 when a geometry cache is damaged, or 3 when a file cannot be written or the
///      validation layer reported something
/// err  DeviceError when the device fails
int write_pictures(Device& device, const Options& options, const Exhibit& exhibit, std::uint32_t clip);

}  // namespace sinew::viewer
