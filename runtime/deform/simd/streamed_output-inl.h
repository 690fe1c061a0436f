// SPDX-License-Identifier: MIT
// Outputs that are written past the caches: what does not fit them would be read into them first and leave them unread.
#if defined(SINEW_STREAMED_OUTPUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_STREAMED_OUTPUT_INL_H_
#undef SINEW_STREAMED_OUTPUT_INL_H_
#else
#define SINEW_STREAMED_OUTPUT_INL_H_
#endif

#include <hwy/cache_control.h>

#include <cstdint>
#include <optional>

#include "runtime/deform/simd/tile-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/deform/vertex_streams.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr std::size_t kStreamedBytes = std::size_t{8} << 20;  ///< more than a core's part of the last cache

/// At which vertices a tile's stores may go past the caches, which takes whole aligned vectors.
class StreamedOutput {
 public:
  StreamedOutput() = default;
  StreamedOutput(const VertexOutput& out, AttributesPresent wanted) {
    const std::size_t bytes = sizeof(glm::vec3) * (1 + wanted.normals) + sizeof(glm::vec4) * wanted.tangents;
    if (kTileSize == 1 || out.positions.size() * bytes < kStreamedBytes) return;
    for (std::size_t first = 0; first < kTileSize && !first_; ++first)
      if (is_aligned(&out.positions[first]) && (!wanted.normals || is_aligned(&out.normals[first])) &&
          (!wanted.tangents || is_aligned(&out.tangents[first])))
        first_ = first;
  }
  ~StreamedOutput() {
    if (first_) hwy::FlushStream();  // whoever is told of the output next finds it in memory
  }
  StreamedOutput(const StreamedOutput&) = delete;
  StreamedOutput& operator=(const StreamedOutput&) = delete;

  bool begins_at(std::size_t vertex) const { return first_ && vertex % kTileSize == *first_; }

  /// Vertices from there to the next at which it may; 0 where there is none.
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
