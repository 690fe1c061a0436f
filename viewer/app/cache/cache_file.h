// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew::viewer {

/// A geometry cache whose head has been read, and where the bytes of its frames are.
struct CacheFile {
  std::string name;                       ///< for the panel and for messages
  std::string path;                       ///< empty = the program holds the bytes
  std::span<const std::byte> bytes = {};  ///< the whole file, where there is no path
  GeometryCache cache;
};

/// The file is a geometry cache, or is called one (.sgeo). False for files that cannot be read.
bool is_cache_file(const std::string& path);

/// Reads the head of a geometry cache, not its frames.
/// err  one sentence: the file, and why it cannot be read or which rule it breaks (GeometryCacheError)
tl::expected<CacheFile, std::string> open_cache_file(const std::string& path);

/// A geometry cache that the program holds.
/// in   bytes  must outlive the result
tl::expected<CacheFile, std::string> open_cache_bytes(std::string name, std::span<const std::byte> bytes);

}  // namespace sinew::viewer
