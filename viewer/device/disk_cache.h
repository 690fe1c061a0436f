// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sinew::viewer {

/// Files that save work in later runs: compiled pipelines and filtered environment maps. Deleting them is always safe.
class DiskCache {
 public:
  DiskCache() = default;  ///< stores nothing

  /// in   folder  created at the first store; empty = nothing is stored
  explicit DiskCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool on() const noexcept { return !folder_.empty(); }

  /// Reads the bytes stored under a name. Returns nothing if the file is missing, damaged, or was stored with another
  /// key.
  std::optional<std::vector<std::byte>> load(const std::string& name, std::uint64_t key) const;

  /// Replaces the file of this name atomically. A failed write is not an error: the next run computes the data again.
  void store(const std::string& name, std::uint64_t key, std::span<const std::byte> bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace sinew::viewer
