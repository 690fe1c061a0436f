// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew {

/// Where a decoder gets the bytes of frames: a file in memory (MappedFrames), or a window that loads while the cache
/// plays (FrameWindow).
struct SINEW_API FrameSource {
  /// The bytes of a frame, valid until the next call; empty = not loaded yet.
  std::span<const std::byte> (*bytes)(void* context, std::uint32_t frame) noexcept = nullptr;
  void* context = nullptr;
  /// Requests frames before they are needed, starting at `next`; null = all frames are loaded.
  void (*prefetch)(void* context, std::uint32_t next) noexcept = nullptr;
};

/// A whole file in memory, or mapped into it. The cache and the bytes must outlive this.
struct SINEW_API MappedFrames {
  const GeometryCache& cache;
  std::span<const std::byte> file;

  operator FrameSource() noexcept;  ///< valid as long as this
};

enum class FramePlace : std::uint8_t;

enum class GeometryStatus : std::uint8_t {
  ok,
  not_loaded,    ///< the source has not loaded all bytes yet; the decoder holds the newest frame that it could reach
  damaged,       ///< the bytes of a frame have changed since they were written; the decoder holds no frame
  out_of_range,  ///< no such frame, stream or time; nothing has changed
  size_mismatch  ///< the buffer has not the size of the stream; nothing has changed
};

/// Decodes the frames of a geometry cache. It holds two frames: the last decoded one and the one before it. Decoding
/// the next frame costs one frame of work; any other frame costs at most one segment (GeometryCache::segment_frames).
/// Bytes of any origin may be passed: checksums are compared, and data that would read or write outside of buffers is
/// refused.
class SINEW_API GeometryDecoder {
 public:
  /// The cache must outlive this. Allocates all memory that decoding needs.
  explicit GeometryDecoder(const GeometryCache& cache);
  ~GeometryDecoder();
  GeometryDecoder(GeometryDecoder&&) noexcept;

  /// Decodes a frame into the decoder.
  /// cost  one frame if it follows the held frame, nothing if it is held, else at most one segment; no allocation
  GeometryStatus decode(std::uint32_t frame, FrameSource source) noexcept;

  /// Decodes the two frames around `time_s`, for write_points to interpolate by `part()`. `time_s` is on the cache's
  /// clock (start_s), clamped to its ends.
  GeometryStatus decode_time(double time_s, FrameSource source) noexcept;

  /// The first frame whose bytes decode(frame) needs: for FrameWindow::prefetch.
  std::uint32_t next_for(std::uint32_t frame) const noexcept;

  /// The next frame whose bytes decode_time(time_s) needs, for FrameWindow::prefetch. If it needs no more bytes: the
  /// frame after those that it shows. The first frame follows the last one, as in a loop.
  std::uint32_t next_for_time(double time_s) const noexcept;

  /// The held frame; kNone = none.
  std::uint32_t frame() const noexcept { return frame_; }
  /// Place of `time_s` between the previous frame (0) and the held frame (1); 1 after `decode`.
  float part() const noexcept { return part_; }

  /// Writes the points of a stream in file order. It suits meshes whose indices were mapped from vertices to points by
  /// GeometryStream::point_of_vertex.
  /// in   stream  index over the streams of all meshes, one mesh after another
  /// out  [point_count]  positions in metres, or normals or colours, by GeometryStream::kind
  /// err  out_of_range (also if no frame is held), size_mismatch
  /// cost O(points), no allocation
  GeometryStatus write_points(std::size_t stream, std::span<glm::vec3> out) const noexcept;

  /// Writes the value of each vertex of the mesh.
  /// out  [vertex_count];   cost  O(points + vertices), no allocation
  GeometryStatus write_vertices(std::size_t stream, std::span<glm::vec3> out) noexcept;

  std::uint64_t frames_decoded() const noexcept { return frames_decoded_; }  ///< work counter, since construction
  std::size_t memory_bytes() const noexcept;  ///< all memory that the decoder allocated; the cache is not included

 private:
  struct Stream;
  GeometryStatus advance(std::uint32_t frame, FrameSource source) noexcept;
  bool decode_streams(std::span<const std::byte> bytes, FramePlace place) noexcept;

  const GeometryCache& cache_;
  std::vector<Stream> streams_;
  struct Memory;
  std::unique_ptr<Memory> memory_;
  std::uint32_t frame_ = kNone;
  float part_ = 1.0f;
  bool has_before_ = false;  // the points of the frame before frame_ are held too
  std::uint64_t frames_decoded_ = 0;
};

}  // namespace sinew
