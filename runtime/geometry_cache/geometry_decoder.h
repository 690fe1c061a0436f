// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew {

/// Where the bytes of frames come from: a file in memory (MappedFrames), or a window that is filled while the cache
/// plays (FrameWindow).
struct FrameSource {
  /// The bytes of a frame, valid until the next call; empty = not there yet.
  std::span<const std::byte> (*bytes)(void* context, std::uint32_t frame) noexcept = nullptr;
  void* context = nullptr;
  /// Asks for frames before they are wanted, from `next` on; null = they are all there.
  void (*prefetch)(void* context, std::uint32_t next) noexcept = nullptr;
};

/// The whole file in memory, or mapped into it. The cache and the bytes must outlive this.
struct MappedFrames {
  const GeometryCache& cache;
  std::span<const std::byte> file;

  operator FrameSource() noexcept;  ///< valid as long as this
};

enum class FramePlace : std::uint8_t;

enum class GeometryStatus : std::uint8_t {
  ok,
  not_there,     ///< the source has not all bytes yet; the decoder holds the newest frame that it could reach
  damaged,       ///< a frame is not as it was written; nothing is held
  out_of_range,  ///< no such frame, stream or time; nothing has changed
  size_mismatch  ///< the buffer is not of the stream's size; nothing has changed
};

/// Decodes the frames of a geometry cache. Holds two frames: the one that was asked for, and the one before it. The
/// next frame takes one frame of work, any other at most one segment (GeometryCache::segment_frames).
/// Bytes of any origin may be passed: their checksums are compared, and what could read or write outside of buffers is
/// refused.
class GeometryDecoder {
 public:
  /// The cache must outlive this. Allocates all memory that decoding takes.
  explicit GeometryDecoder(const GeometryCache& cache);
  ~GeometryDecoder();
  GeometryDecoder(GeometryDecoder&&) noexcept;

  /// Decodes a frame into the decoder.
  /// cost  one frame after the frame before, nothing for the frame that is held, else at most one segment; no
  /// allocation
  GeometryStatus decode(std::uint32_t frame, FrameSource source) noexcept;

  /// Decodes what positions between two frames need: the frames around `time_s` on the clock of the cache (start_s,
  /// clamped to its ends), for write_points with `part()`.
  GeometryStatus decode_time(double time_s, FrameSource source) noexcept;

  /// The frame whose bytes are needed first to get to `frame`: for FrameWindow::prefetch.
  std::uint32_t next_for(std::uint32_t frame) const noexcept;

  /// The frame whose bytes are needed next to get to `time_s`, or after it where it is held already. After the last
  /// frame comes the first one, as in a loop.
  std::uint32_t next_for_time(double time_s) const noexcept;

  /// The frame that is held; kNone = none.
  std::uint32_t frame() const noexcept { return frame_; }
  /// The place of `time_s` between the frame before the held one (0) and the held one (1); 1 after `decode`.
  float part() const noexcept { return part_; }

  /// Writes the points of a stream, in the order of the file: for the index buffer of a mesh that was reordered by
  /// GeometryStream::point_of_vertex.
  /// in   stream  of all meshes, one mesh after another
  /// out  [point_count]  metres;   err  out_of_range (also when nothing is held), size_mismatch
  /// cost O(points), no allocation
  GeometryStatus write_points(std::size_t stream, std::span<glm::vec3> out) const noexcept;

  /// Writes the value of each vertex of the mesh.
  /// out  [vertex_count];   cost  O(points + vertices), no allocation
  GeometryStatus write_vertices(std::size_t stream, std::span<glm::vec3> out) noexcept;

  std::uint64_t frames_decoded() const noexcept { return frames_decoded_; }  ///< since it was made: work counter
  std::size_t memory_bytes() const noexcept;  ///< all that it has allocated, without the cache

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
  bool has_before_ = false;  // the frame before the held one is held too
  std::uint64_t frames_decoded_ = 0;
};

}  // namespace sinew
