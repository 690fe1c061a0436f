// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// Cache file for the centers of rotation of one primitive. Its name is a hash of all inputs.
class CentersCache {
 public:
  /// in   folder  empty = no cache
  CentersCache(const std::filesystem::path& folder, const Primitive& primitive, double sigma);

  /// Empty if the file is absent, damaged, or of another version or size.
  std::optional<std::vector<glm::vec3>> load() const;

  /// Writes atomically, through a temporary file. A failed write is not an error: the centers are computed again next
  /// time.
  void store(const std::vector<glm::vec3>& centers) const;

 private:
  std::filesystem::path file_;
  std::size_t vertex_count_ = 0;
};

}  // namespace sinew
