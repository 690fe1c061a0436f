// SPDX-License-Identifier: MIT
// Small geometry caches for the viewer's tests, in memory and as files.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "runtime/model/scene.h"
#include "tests/geometry_cache/takes.h"
#include "viewer/app/cache/cache_on_scene.h"

namespace sinew::viewer {

using Bytes = std::vector<std::byte>;

/// A flag of 33 x 25 vertices in segments of 8 frames; its mesh is called "mesh".
inline Bytes flag_bytes(std::uint32_t frames = 20, double start_s = 0.0) {
  GeometryTake take = test::flag_take(frames);
  take.start_s = start_s;
  const auto bytes = encode_geometry_cache(take, {.segment_frames = 8});
  if (!bytes) throw std::runtime_error(bytes.error().issue.detail);
  return *bytes;
}

/// A file of these bytes, in a folder of this process; the destructor removes it.
class WrittenFile {
 public:
  WrittenFile(const std::string& name, const Bytes& bytes)
      : path_(std::filesystem::temp_directory_path() / ("sinew-" + std::to_string(getpid()) + "-" + name)) {
    std::ofstream out(path_, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  ~WrittenFile() { std::filesystem::remove(path_); }
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// The bytes of a cache with one flipped bit in a frame.
inline Bytes with_damage(Bytes bytes, std::uint32_t frame) {
  const auto cache = GeometryCache::open(bytes);
  bytes[cache->frames()[frame].offset + cache->frames()[frame].size / 2] ^= std::byte{1};
  return bytes;
}

/// A cache shown without a glTF file.
inline CacheAlone flag_alone(const Bytes& bytes) {
  auto file = open_cache_bytes("flag", bytes);
  if (!file) throw std::runtime_error(file.error());
  auto alone = show_cache_alone(std::move(*file));
  if (!alone) throw std::runtime_error(alone.error());
  return std::move(*alone);
}

}  // namespace sinew::viewer
