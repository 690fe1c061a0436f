// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::viewer {

/// A geometry cache whose head has been read, and the location of its frame data.
struct CacheFile {
  std::string name;                       ///< for the panel and for messages
  std::string path;                       ///< empty = the data is in `bytes`
  std::span<const std::byte> bytes = {};  ///< the whole file, if `path` is empty
  GeometryCache cache;
};

/// True if the name ends in .sgeo or the content starts like a geometry cache.
bool is_cache_file(const std::string& path);

/// Reads the head of a geometry cache file, but not its frames.
/// err  one sentence: the file, and why it cannot be read or which rule it breaks (GeometryCacheError)
tl::expected<CacheFile, std::string> open_cache_file(const std::string& path);

/// Opens a geometry cache that is in memory.
/// in   bytes  must outlive the result
tl::expected<CacheFile, std::string> open_cache_bytes(std::string name, std::span<const std::byte> bytes);

}  // namespace sinew::viewer
