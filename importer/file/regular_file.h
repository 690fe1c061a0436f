// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace sinew {

/// A file that is opened before its type is asked for, so that it cannot be swapped for another one in between. Opening
/// does not wait for the other end of a pipe and does not take over a terminal.
class RegularFile {
 public:
  /// Names the file on the disk, whatever its path: device and number of its entry.
  using Identity = std::pair<std::uint64_t, std::uint64_t>;

  explicit RegularFile(const std::filesystem::path& path) noexcept;
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  /// False: errno says why.
  bool opened() const noexcept { return descriptor_ >= 0; }

  /// Nothing for folders, pipes and devices, which must not be read.
  std::optional<std::uint64_t> size() const noexcept;
  Identity identity() const noexcept;

  /// Fills `out` from where the last call ended; false where the file ends early.
  bool read(std::span<std::byte> out) const noexcept;

  /// For libraries that read from a descriptor. It belongs to this object.
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace sinew
