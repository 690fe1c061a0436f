// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "importer/platform/files.h"

namespace sinew {

/// A file that is opened first and then checked for its type, so that it cannot be swapped in between. Opening never
/// blocks on a pipe and never acquires a controlling terminal.
class RegularFile {
 public:
  /// Identifies a file independent of its path: device and inode number.
  using Identity = platform::FileIdentity;

  explicit RegularFile(const std::filesystem::path& path) noexcept : descriptor_(platform::open_to_read(path)) {}
  ~RegularFile() {
    if (opened()) platform::close(descriptor_);
  }
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  /// False if opening failed; errno has the reason.
  bool opened() const noexcept { return descriptor_ >= 0; }

  /// Size in bytes; empty for folders, pipes and devices, which must not be read.
  std::optional<std::uint64_t> size() const noexcept { return platform::regular_size(descriptor_); }
  Identity identity() const noexcept { return platform::identity_of(descriptor_); }

  /// Reads the next bytes into `out`; false if the file ends before it is full.
  bool read(std::span<std::byte> out) const noexcept { return platform::read_all(descriptor_, out); }

  /// Returns the first bytes, at most `most`; none if the file is not regular or was not opened.
  std::vector<std::byte> read_up_to(std::uint64_t most) const {
    const auto whole = opened() ? size() : std::nullopt;
    std::vector<std::byte> bytes(static_cast<std::size_t>(std::min(most, whole.value_or(0))));
    if (!read(bytes)) bytes.clear();
    return bytes;
  }

  /// The file descriptor, for libraries that need one. This object closes it.
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace sinew
