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

/// Files that save work in the next run: what the driver compiled, prepared light. Deleting them is always safe.
class DiskCache {
 public:
  DiskCache() = default;  ///< stores nothing

  /// in   folder  made when something is stored; empty = nothing is stored
  explicit DiskCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool on() const noexcept { return !folder_.empty(); }

  /// What was stored under a name with this key. Nothing when the file is absent, damaged, or has another key.
  std::optional<std::vector<std::byte>> load(const std::string& name, std::uint64_t key) const;

  /// Replaces the file of this name. Readers see the old file or the new one, never a part. A file that cannot be
  /// written is no error: its contents are made again in the next run.
  void store(const std::string& name, std::uint64_t key, std::span<const std::byte> bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace sinew::viewer
