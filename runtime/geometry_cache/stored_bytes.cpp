// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/stored_bytes.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

void Unpacker::Free::operator()(ZSTD_DCtx_s* context) const noexcept { ZSTD_freeDCtx(context); }

Unpacker::Unpacker() : context_(ZSTD_createDCtx()) {
  if (!context_) throw std::bad_alloc();
}

std::size_t Unpacker::unpack(std::span<const std::byte> stored, bool by_zstd, std::span<std::uint8_t> out) noexcept {
  constexpr std::size_t kFault = std::numeric_limits<std::size_t>::max();
  if (by_zstd) {
    const std::size_t size = ZSTD_decompressDCtx(context_.get(), out.data(), out.size(), stored.data(), stored.size());
    return ZSTD_isError(size) != 0u ? kFault : size;
  }
  if (stored.size() > out.size()) return kFault;
  if (!stored.empty()) std::memcpy(out.data(), stored.data(), stored.size());
  return stored.size();
}

std::size_t Unpacker::memory_bytes() const noexcept { return ZSTD_sizeof_DCtx(context_.get()); }

std::vector<std::uint32_t> numbers_of_planes(std::span<const std::uint8_t> planes) {
  const std::size_t count = planes.size() / 4;
  std::vector<std::uint32_t> numbers(count);
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t gap = 0;
    for (std::size_t byte = 0; byte < 4; ++byte) gap |= std::uint32_t{planes[byte * count + i]} << (8 * byte);
    numbers[i] = before += static_cast<std::uint32_t>(unzigzag(gap));
  }
  return numbers;
}

std::vector<std::uint8_t> planes_of_numbers(std::span<const std::uint32_t> numbers) {
  std::vector<std::uint8_t> planes(4 * numbers.size());
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint32_t gap = zigzag(static_cast<std::int32_t>(numbers[i] - before));
    before = numbers[i];
    for (std::size_t byte = 0; byte < 4; ++byte)
      planes[byte * numbers.size() + i] = static_cast<std::uint8_t>(gap >> (8 * byte));
  }
  return planes;
}

}  // namespace sinew
