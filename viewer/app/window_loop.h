// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/app/exhibit.h"
#include "viewer/app/options.h"
#include "viewer/app/reload/exhibit_watch.h"

namespace sinew::viewer {

/// Opens the window and plays until the user closes it.
/// in   clip   shown first; nothing = the first one
///      watch  reads the exhibit again when its files change; null = never
/// io   exhibits  get centers of rotation when the user chooses that kind of skinning
/// out  exit code of the program: 0, or 3 when Options::validate is set and the validation layer reported something
/// err  DeviceError when there is no display or no device
int run_window(const Options& options, std::vector<Exhibit>& exhibits, std::optional<std::uint32_t> clip,
               ExhibitWatch* watch);

}  // namespace sinew::viewer
