// SPDX-License-Identifier: MIT
#include "importer/topology/weld.h"

#include <algorithm>
#include <bit>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

/// Adding +0 maps -0 to +0 and keeps all other values.
std::uint32_t bits(float x) noexcept { return std::bit_cast<std::uint32_t>(x + 0.0f); }

std::uint64_t hash(std::span<const float> key) noexcept {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const float x : key) {
    h = (h ^ bits(x)) * 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  }
  return h;
}

bool same(std::span<const float> a, std::span<const float> b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) { return bits(x) == bits(y); });
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const float> keys, std::size_t stride) {
  CONTRACT(stride > 0 && keys.size() % stride == 0);
  const std::size_t count = keys.size() / stride;
  const auto key_of = [&](std::size_t v) { return keys.subspan(v * stride, stride); };

  // Hash table with open addressing, at most half full: one flat array, no allocation per vertex.
  const std::size_t slot_count = std::bit_ceil(2 * count + 1);
  constexpr std::uint32_t kFree = 0xffffffffu;
  std::vector<std::uint32_t> slots(slot_count, kFree);
  std::vector<std::uint32_t> first(count);
  for (std::size_t v = 0; v < count; ++v) {
    std::size_t slot = hash(key_of(v)) & (slot_count - 1);
    while (slots[slot] != kFree && !same(key_of(slots[slot]), key_of(v))) slot = (slot + 1) & (slot_count - 1);
    if (slots[slot] == kFree) slots[slot] = static_cast<std::uint32_t>(v);
    first[v] = slots[slot];
  }
  return first;
}

}  // namespace sinew
