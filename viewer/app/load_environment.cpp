// SPDX-License-Identifier: MIT
#include "viewer/app/load_environment.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "viewer/light/panorama.h"
#include "viewer/light/stored_environment.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kFaceSize = 256;

/// An environment with the parts that an earlier run stored, or made and stored.
std::shared_ptr<const Environment> kept_environment(const std::string& name, CubeMap sky, const DiskCache& disk) {
  const std::uint64_t key = environment_key(sky);
  if (const auto stored = disk.load(name, key))
    if (auto whole = whole_environment(sky, *stored)) return whole;
  auto made = make_environment(std::move(sky));
  if (disk.on()) disk.store(name, key, stored_parts(*made));
  return made;
}

}  // namespace

tl::expected<std::shared_ptr<const Environment>, std::string> load_environment(const std::string& name,
                                                                               const DiskCache& disk) {
  if (name == "studio") return disk.on() ? kept_environment("studio.light", studio_sky(), disk) : studio_environment();
  if (name == "plain") return plain_environment();
  if (name == "none") return nullptr;
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error))
    return tl::unexpected(name + ": there is no such file, and the built-in environments are studio, plain and none");
  std::ifstream in(name, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
  if (!in) return tl::unexpected(name + ": cannot be read");
  const auto panorama = decode_panorama(std::as_bytes(std::span(bytes)));
  if (!panorama) return tl::unexpected(name + ": " + panorama.error());
  return kept_environment("panorama.light", cube_from(*panorama, kFaceSize), disk);
}

}  // namespace sinew::viewer
