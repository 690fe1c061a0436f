// SPDX-License-Identifier: MIT
#include "importer/tool/bake/read_cache.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "importer/file/regular_file.h"
#include "importer/platform/files.h"
#include "importer/tool/messages.h"

namespace sinew::tool {

std::optional<tl::expected<CacheFile, ExitCode>> read_cache(const std::string& file, bool whole) {
  const RegularFile opened(platform::path_of(file));
  const std::uint64_t size = opened.opened() ? opened.size().value_or(0) : 0;
  CacheFile out;
  const auto read = [&](std::uint64_t count) {
    const std::size_t before = out.bytes.size();
    out.bytes.resize(std::max<std::size_t>(before, std::min(size, count)));
    if (!opened.read(std::span(out.bytes).subspan(before))) out.bytes.clear();
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
