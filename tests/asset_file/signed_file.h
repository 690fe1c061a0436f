// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "runtime/asset_file/asset_file.h"
#include "runtime/base/checksum.h"
#include "runtime/clip/clip_file.h"

namespace sinew::test {

/// Byte offsets of the fields of a table entry.
inline constexpr std::size_t kEntryKind = 0, kEntryVersion = 4, kEntryStorage = 8, kEntryOffset = 16, kEntryStored = 24,
                             kEntryBytes = 32, kEntrySum = 40, kEntrySignature = 48;

template <class T>
T number_at(std::span<const std::byte> file, std::size_t at) {
  T number{};
  std::memcpy(&number, file.data() + at, sizeof number);
  return number;
}

template <class T>
void put_number(std::span<std::byte> file, std::size_t at, T number) {
  std::memcpy(file.data() + at, &number, sizeof number);
}

/// Updates size and checksum of a block of compiled clips (clip/clip_file.h).
inline void sign_clips(std::span<std::byte> block) {
  if (!looks_like_clips(block) || block.size() < kClipFileHead) return;
  put_number(block, 16, std::uint64_t{block.size()});
  put_number(block, 24, checksum(block.subspan(kClipFileHead)));
}

/// Updates the size of a file and all of its checksums, as far as its table makes sense. Damage is then not caught by a
/// checksum but by the code behind it.
inline void sign_assets(std::span<std::byte> file) {
  if (file.size() < kAssetHead) return;
  const std::uint64_t count = number_at<std::uint32_t>(file, 12);
  put_number(file, 16, std::uint64_t{file.size()});
  if (count > (file.size() - kAssetHead) / kAssetEntry) return;
  const auto table = file.subspan(kAssetHead, count * kAssetEntry);
  for (std::size_t at = 0; at < table.size(); at += kAssetEntry) {
    const auto offset = number_at<std::uint64_t>(table, at + kEntryOffset),
               size = number_at<std::uint64_t>(table, at + kEntryStored);
    if (offset < kAssetHead + table.size() || offset > file.size() || size > file.size() - offset) continue;
    if (number_at<std::uint32_t>(table, at + kEntryKind) == static_cast<std::uint32_t>(AssetKind::clips))
      sign_clips(file.subspan(offset, size));  // each page in the block has its own size and checksum
    put_number(table, at + kEntrySum, checksum(file.subspan(offset, size)));
  }
  put_number(file, 24, checksum(table));
}

}  // namespace sinew::test
