// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace sinew::viewer {
namespace {

/// Reads up to `bytes` bytes from the start of a file; empty if it cannot be read.
std::optional<std::vector<std::byte>> start_of(const std::string& path, std::uint64_t bytes) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::byte> start(bytes);
  if (!stream.read(reinterpret_cast<char*>(start.data()), static_cast<std::streamsize>(bytes)) && !stream.eof())
    return std::nullopt;
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start;
}

std::string describe(const std::string& name, const GeometryCacheError& error) {
  return name + ": byte " + std::to_string(error.offset) + ": " + error.rule + ": " + error.detail;
}

}  // namespace

bool is_cache_file(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".sgeo") return true;
  const auto start = start_of(path, kGeometryFileHead);
  return start && GeometryCache::head_bytes(*start) != 0;
}

tl::expected<CacheFile, std::string> open_cache_file(const std::string& path) {
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(path, failed);
  if (failed) return tl::unexpected(path + ": " + failed.message());
  const auto cannot_read = [&] { return tl::unexpected(path + ": " + std::strerror(errno)); };
  auto start = start_of(path, std::min<std::uint64_t>(size, kGeometryFileHead));
  if (!start) return cannot_read();
  if (const std::uint64_t head = GeometryCache::head_bytes(*start); head != 0) {
    start = start_of(path, std::min(size, head));
    if (!start) return cannot_read();
  }
  auto cache = GeometryCache::open(*start, size);
  if (!cache) return tl::unexpected(describe(path, cache.error()));
  return CacheFile{std::filesystem::path(path).filename().string(), path, {}, std::move(*cache)};
}

tl::expected<CacheFile, std::string> open_cache_bytes(std::string name, std::span<const std::byte> bytes) {
  auto cache = GeometryCache::open(bytes);
  if (!cache) return tl::unexpected(describe(name, cache.error()));
  return CacheFile{std::move(name), {}, bytes, std::move(*cache)};
}

}  // namespace sinew::viewer
