// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/tool/exit_code.h"
#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::tool {

/// A geometry cache with the bytes that were read of its file.
struct CacheFile {
  std::vector<std::byte> bytes;
  GeometryCache cache;
};

/// Reads a geometry cache.
/// in    whole  false: reads only the head, without the frames
/// out   empty if the file is no geometry cache
/// err   the exit code, after its message was printed
std::optional<tl::expected<CacheFile, ExitCode>> read_cache(const std::string& file, bool whole);

}  // namespace sinew::tool
