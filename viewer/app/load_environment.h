// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "viewer/device/disk_cache.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// Loads an environment by name: a room (rooms.h), "plain" (a gradient), "none" (null), or the path of a panorama.
/// in   disk  caches the filtered maps for later runs: of each room, and of the last panorama
/// err  one sentence that begins with the file's name
tl::expected<std::shared_ptr<const Environment>, std::string> load_environment(const std::string& name,
                                                                               const DiskCache& disk = DiskCache());

}  // namespace sinew::viewer
