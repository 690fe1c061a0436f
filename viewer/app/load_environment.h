// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "viewer/device/disk_cache.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// The environment that an option names: "studio", "plain" (a gradient), "none" (null), or a panorama in a file.
/// in   disk  keeps what takes long to make for the next run: of each built-in environment, and of the last panorama
/// err  one sentence that begins with the file
tl::expected<std::shared_ptr<const Environment>, std::string> load_environment(const std::string& name,
                                                                               const DiskCache& disk = DiskCache());

}  // namespace sinew::viewer
