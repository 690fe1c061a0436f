// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// A file with the centers of rotation of one primitive. Its name is a hash of everything that the centers depend on.
class CentersCache {
 public:
  /// An empty folder switches the cache off.
  CentersCache(const std::filesystem::path& folder, const Primitive& primitive, double sigma);

  /// Nothing when the file is absent, damaged, or of another version or size.
  std::optional<std::vector<glm::vec3>> load() const;

  /// Writes a temporary file and renames it, so that a reader never sees half a file. A cache that cannot be written is
  /// no error: the centers are computed again next time.
  void store(const std::vector<glm::vec3>& centers) const;

 private:
  std::filesystem::path file_;
  std::size_t vertex_count_ = 0;
};

}  // namespace sinew
