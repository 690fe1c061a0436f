// SPDX-License-Identifier: MIT
#include "viewer/app/load_environment.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "viewer/light/panorama.h"
#include "viewer/light/rooms.h"
#include "viewer/light/stored_environment.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kFaceSize = 256;

/// Completes an environment with filtered maps from the disk cache, or computes and stores them.
std::shared_ptr<Environment> cached_environment(const std::string& name, CubeMap sky, const DiskCache& disk) {
  const std::uint64_t key = environment_key(sky);
  if (const auto stored = disk.load(name, key))
    if (auto whole = complete_environment(sky, *stored)) return whole;
  auto made = make_environment(std::move(sky));
  if (disk.on()) disk.store(name, key, stored_parts(*made));
  return made;
}

/// All bytes of a file; empty optional if reading fails.
std::optional<std::string> read_all(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (in) {
    in.read(part.data(), part.size());
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof()) return std::nullopt;
  return bytes;
}

}  // namespace

tl::expected<std::shared_ptr<const Environment>, std::string> load_environment(const std::string& name,
                                                                               const DiskCache& disk) {
  if (const auto room = room_named(name))
    return disk.on() ? furnished(*room, cached_environment(name + ".light", sky_of(*room), disk))
                     : room_environment(*room);
  if (name == "plain") return plain_environment();
  if (name == "none") return nullptr;
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error))
    return tl::unexpected(
        name + ": there is no such file, and the built-in environments are studio, sunset, overcast, plain and none");
  const auto bytes = read_all(name);
  if (!bytes) return tl::unexpected(name + ": cannot be read");
  const auto panorama = decode_panorama(std::as_bytes(std::span(*bytes)));
  if (!panorama) return tl::unexpected(name + ": " + panorama.error());
  return cached_environment("panorama.light", cube_from(*panorama, kFaceSize), disk);
}

}  // namespace sinew::viewer
