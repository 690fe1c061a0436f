// SPDX-License-Identifier: MIT
#include "viewer/light/stored_environment.h"

#include <cstring>
#include <utility>

#include "runtime/base/checksum.h"
#include "viewer/light/split_sum.h"

namespace sinew::viewer {
namespace {

/// Increase it when make_environment or split_sum_table change their results for the same sky.
constexpr std::uint64_t kVersion = 2;

/// Visits all stored arrays, as bytes, in the order of the file.
template <class Visit>
void for_each_part(Environment& environment, const Visit& visit) {
  visit(std::as_writable_bytes(std::span(environment.diffuse)));
  for (std::size_t level = 1; level < environment.reflected.size(); ++level)
    visit(std::as_writable_bytes(std::span(environment.reflected[level].texels)));
  visit(std::as_writable_bytes(std::span(environment.split_sum)));
}

std::size_t size_of_parts(Environment& environment) {
  std::size_t size = 0;
  for_each_part(environment, [&](std::span<std::byte> part) { size += part.size(); });
  return size;
}

/// An environment with the sky as its sharpest level and memory for all stored arrays.
std::shared_ptr<Environment> empty_environment(CubeMap sky) {
  auto made = std::make_shared<Environment>();
  const std::uint32_t size = sky.size;
  made->reflected.push_back(std::move(sky));
  for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level) {
    const std::size_t side = size >> level;
    made->reflected.push_back({size >> level, std::vector<glm::vec3>(kCubeFaces * side * side)});
  }
  made->split_sum.resize(std::size_t{kSplitSumSize} * kSplitSumSize);
  return made;
}

}  // namespace

std::uint64_t environment_key(const CubeMap& sky) {
  return checksum(std::as_bytes(std::span(sky.texels)), kVersion << 32 | sky.size);
}

std::vector<std::byte> stored_parts(const Environment& environment) {
  Environment whole = environment;
  if (whole.split_sum.empty()) whole.split_sum = split_sum_table();
  std::vector<std::byte> bytes(size_of_parts(whole));
  std::size_t at = 0;
  for_each_part(whole, [&](std::span<std::byte> part) {
    std::memcpy(&bytes[at], part.data(), part.size());
    at += part.size();
  });
  return bytes;
}

std::shared_ptr<Environment> complete_environment(CubeMap sky, std::span<const std::byte> parts) {
  auto made = empty_environment(std::move(sky));
  if (parts.size() != size_of_parts(*made)) return nullptr;
  std::size_t at = 0;
  for_each_part(*made, [&](std::span<std::byte> part) {
    std::memcpy(part.data(), &parts[at], part.size());
    at += part.size();
  });
  return made;
}

}  // namespace sinew::viewer
