// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct ZSTD_DCtx_s;

namespace sinew {

/// Unpacks zstd with memory that is allocated once.
class Unpacker {
 public:
  Unpacker();

  /// in   stored  bytes of the file, packed by zstd or plain
  /// out  the first bytes of `out` are overwritten; returns how many
  /// err  SIZE_MAX: the bytes are no zstd frame, or unpack to more than `out` holds
  /// cost O(out), no allocation
  std::size_t unpack(std::span<const std::byte> stored, bool by_zstd, std::span<std::uint8_t> out) noexcept;

  std::size_t memory_bytes() const noexcept;

 private:
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const noexcept;
  };
  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

/// Decodes numbers from four byte planes of their zigzag differences; planes_of_numbers encodes them.
/// in   planes  [4 * numbers]
std::vector<std::uint32_t> numbers_of_planes(std::span<const std::uint8_t> planes);
std::vector<std::uint8_t> planes_of_numbers(std::span<const std::uint32_t> numbers);

}  // namespace sinew
