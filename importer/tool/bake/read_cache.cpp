// SPDX-License-Identifier: MIT
#include "importer/tool/bake/read_cache.h"

#include <algorithm>
#include <fstream>
#include <ios>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "importer/tool/messages.h"

namespace sinew::tool {

std::optional<tl::expected<CacheFile, ExitCode>> read_cache(const std::string& file, bool whole) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const auto size = stream ? static_cast<std::uint64_t>(std::max<std::streamoff>(stream.tellg(), 0)) : 0;
  CacheFile out;
  const auto read = [&](std::uint64_t count) {
    out.bytes.resize(std::min(size, count));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(out.bytes.data()), static_cast<std::streamsize>(out.bytes.size()));
  };
  read(kGeometryFileHead);
  if (!looks_like_geometry_cache(out.bytes)) return std::nullopt;
  read(whole ? size : GeometryCache::head_bytes(out.bytes));
  auto cache = GeometryCache::open(out.bytes, size);
  if (!cache)
    return tl::unexpected(fail_with(
        ExitCode::input_at_fault,
        fmt::format("{}: byte {}: {}: {}", file, cache.error().offset, cache.error().rule, cache.error().detail)));
  out.cache = std::move(*cache);
  return out;
}

}  // namespace sinew::tool
