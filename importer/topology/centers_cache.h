// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// A file that holds the centers of rotation of one primitive, named by a hash of everything that they depend on.
class CentersCache {
 public:
  /// An empty folder switches the cache off.
  CentersCache(const std::filesystem::path& folder, const Primitive& primitive, double sigma);

  /// Nothing when the file is absent, of another version or size, or damaged.
  std::optional<std::vector<glm::vec3>> load() const;

  /// Writes beside the target and renames, so that a reader never sees half a file. A cache that cannot be written is
  /// not an error: the centers are computed again next time.
  void store(const std::vector<glm::vec3>& centers) const;

 private:
  std::filesystem::path file_;
  std::size_t vertex_count_ = 0;
};

}  // namespace sinew
