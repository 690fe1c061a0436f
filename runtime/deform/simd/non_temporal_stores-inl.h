// SPDX-License-Identifier: MIT
// Decides which stores are non-temporal. A normal store first reads the cache line. This is wasted if the output
// exceeds the caches or is not read soon.
#if defined(SINEW_NON_TEMPORAL_STORES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_NON_TEMPORAL_STORES_INL_H_
#undef SINEW_NON_TEMPORAL_STORES_INL_H_
#else
#define SINEW_NON_TEMPORAL_STORES_INL_H_
#endif

#include <hwy/cache_control.h>

#include <cstdint>
#include <optional>

#include "runtime/deform/simd/tile-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/deform/vertex_streams.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr std::size_t kStreamedBytes = std::size_t{8} << 20;  ///< exceeds a core's share of last-level cache

/// Finds the vertices at which non-temporal stores may begin to write a tile. These stores write whole aligned vectors.
class NonTemporalStores {
 public:
  NonTemporalStores() = default;
  NonTemporalStores(const VertexOutput& out, AttributesPresent wanted, bool asked) {
    const std::size_t bytes = sizeof(glm::vec3) * (1 + wanted.normals) + sizeof(glm::vec4) * wanted.tangents;
    // With four lanes arithmetic limits the speed, not memory. Alignment would also cost each group one more tile.
    const bool pays = (asked && kTileSize >= 8) || out.positions.size() * bytes >= kStreamedBytes;
    if (kTileSize == 1 || !pays) return;
    for (std::size_t first = 0; first < kTileSize && !first_; ++first)
      if (is_aligned(&out.positions[first]) && (!wanted.normals || is_aligned(&out.normals[first])) &&
          (!wanted.tangents || is_aligned(&out.tangents[first])))
        first_ = first;
  }
  ~NonTemporalStores() {
    if (first_) hwy::FlushStream();  // makes the output visible to threads that this one signals afterwards
  }
  NonTemporalStores(const NonTemporalStores&) = delete;
  NonTemporalStores& operator=(const NonTemporalStores&) = delete;

  bool begins_at(std::size_t vertex) const { return first_ && vertex % kTileSize == *first_; }

  /// Number of vertices from `vertex` to the next aligned one; 0 if there is none.
  std::size_t until(std::size_t vertex) const {
    return first_ ? (*first_ + kTileSize - vertex % kTileSize) % kTileSize : 0;
  }

 private:
  static bool is_aligned(const void* at) { return reinterpret_cast<std::uintptr_t>(at) % sizeof(Wide) == 0; }

  std::optional<std::size_t> first_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
