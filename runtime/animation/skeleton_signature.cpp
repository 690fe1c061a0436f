// SPDX-License-Identifier: MIT
#include "runtime/animation/skeleton_signature.h"

#include <cstddef>
#include <string_view>
#include <vector>

#include "runtime/base/checksum.h"

namespace sinew {
namespace {

void put(std::uint32_t number, std::vector<std::byte>& bytes) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(number >> shift & 0xff));
}

}  // namespace

std::uint64_t skeleton_signature(const Skeleton& skeleton) {
  std::vector<std::byte> bytes;
  put(static_cast<std::uint32_t>(skeleton.joint_count()), bytes);
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) {
    const std::string_view name = j < skeleton.names.size() ? skeleton.names[j] : std::string_view{};
    put(skeleton.parents[j], bytes);
    put(static_cast<std::uint32_t>(name.size()), bytes);
    for (const char c : name) bytes.push_back(static_cast<std::byte>(c));
  }
  return checksum(bytes);
}

}  // namespace sinew
