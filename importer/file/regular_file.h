// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "importer/platform/files.h"

namespace sinew {

/// A file that is opened before its type is asked for, so that it cannot be swapped for another one in between. Opening
/// does not wait for the other end of a pipe and does not take over a terminal.
class RegularFile {
 public:
  using Identity = platform::FileIdentity;

  explicit RegularFile(const std::filesystem::path& path) noexcept : descriptor_(platform::open_to_read(path)) {}
  ~RegularFile() {
    if (opened()) platform::close(descriptor_);
  }
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  /// False: errno says why.
  bool opened() const noexcept { return descriptor_ >= 0; }

  /// Nothing for folders, pipes and devices, which must not be read.
  std::optional<std::uint64_t> size() const noexcept { return platform::regular_size(descriptor_); }
  Identity identity() const noexcept { return platform::identity_of(descriptor_); }

  /// Fills `out` from where the last call ended; false where the file ends early.
  bool read(std::span<std::byte> out) const noexcept { return platform::read_all(descriptor_, out); }

  /// For libraries that read from a descriptor. It belongs to this object.
  int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace sinew
