// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include <tl/expected.hpp>

#include "importer/geometry_cache/geometry_take.h"
#include "importer/tool/bake/read_cache.h"

namespace sinew::tool {

/// The positions of the first frames of a cache, decoded.
/// err   a sentence for the user, if a frame is damaged
tl::expected<GeometryTake, std::string> decoded_take(const CacheFile& file, std::size_t most_frames);

}  // namespace sinew::tool
