// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Why a file is refused: the broken rule, the byte where it was found, and a sentence.
///
///     cache-magic      the bytes do not start with the magic of geometry caches
///     cache-version    another version of the library wrote it: bake it again
///     cache-checksum   bytes have changed since it was written
///     cache-value      a number has no valid meaning in its field
///     cache-size       the bytes end too early
struct GeometryCacheError {
  std::string rule;
  std::uint64_t offset = 0;
  std::string detail;
};

/// Meaning of the three numbers per point of a stream.
enum class GeometryKind : std::uint8_t { positions, normals, colors };

/// One attribute of a mesh over time. Vertices whose values are equal in all frames share one point.
struct GeometryStream {
  GeometryKind kind = GeometryKind::positions;
  float step = 0.0f;                           ///< quantisation step: values are integer multiples of it
  std::uint32_t point_count = 0;               ///< number of points in the file
  std::vector<std::uint32_t> point_of_vertex;  ///< [vertices] the point of each vertex of the mesh
  std::vector<std::uint8_t> corners;           ///< [3 * 64 * blocks] for each point the three points that predict it
  std::uint32_t most_payload = 0;              ///< bytes of packed residuals in the largest frame
  double asked = 0.0;     ///< requested error bound: metres, or the length of a difference of normals or colours
  double measured = 0.0;  ///< largest error of a decoded value in any frame, measured after decoding

  std::size_t block_count() const noexcept { return (point_count + std::size_t{63}) / 64; }
};

/// Largest position errors in metres, over all vertices and frames of a mesh.
struct GeometryCertificate {
  double asked_m = 0.0;     ///< error budget of positions, as GeometryStream::asked
  double measured_m = 0.0;  ///< largest measured error of positions, as GeometryStream::measured
  double between_m = -1.0;  ///< halfway between frames, for linearly interpolated positions; negative = not measured
};

struct GeometryMesh {
  std::string name;
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;  ///< [3 * triangles] empty = the cache does not store them; the scene does
  std::vector<GeometryStream> streams;   ///< at most one of each kind, in the order of kinds; positions always exist
  GeometryCertificate certificate;
  Aabb bounds;  ///< box around the mesh in all frames
};

/// Where the bytes of a frame lie in the file.
struct GeometryFrame {
  std::uint64_t offset = 0;
  std::uint32_t size = 0;
  std::uint64_t checksum = 0;
};

/// A time, expressed as a frame and the fraction of the way to the next frame.
struct FrameTime {
  std::uint32_t frame = 0;
  float part = 0.0f;  ///< [0, 1]; 0 in the last frame
};

/// The head of a geometry cache: what the file contains and where each frame lies, without the frames. A geometry cache
/// stores the vertices of every frame, for simulations and other motion that no skeleton can express. GeometryDecoder
/// decodes the frames.
class SINEW_API GeometryCache {
 public:
  /// Number of bytes from the start of the file that `open` needs. 0 if `start` is no geometry cache or too short to
  /// tell; kGeometryFileHead bytes are enough.
  static std::uint64_t head_bytes(std::span<const std::byte> start) noexcept;

  /// Reads and checks the head of a file.
  /// in   head       the file, or its first head_bytes()
  ///      file_size  bytes of the whole file
  /// Any bytes may be passed. Memory stays below 16 MiB and 64 times the head.
  /// err  GeometryCacheError;  cost O(head), allocates
  static tl::expected<GeometryCache, GeometryCacheError> open(std::span<const std::byte> head, std::uint64_t file_size);
  static tl::expected<GeometryCache, GeometryCacheError> open(std::span<const std::byte> file) {
    return open(file, file.size());
  }

  std::span<const GeometryMesh> meshes() const noexcept { return meshes_; }
  std::size_t stream_count() const noexcept { return stream_count_; }  ///< number of streams of all meshes
  std::uint32_t frame_count() const noexcept { return static_cast<std::uint32_t>(frames_.size()); }
  /// Every segment_frames-th frame is a key frame
  std::uint32_t segment_frames() const noexcept { return segment_frames_; }
  std::uint32_t key_frame_of(std::uint32_t frame) const noexcept { return frame - frame % segment_frames_; }
  double start_s() const noexcept { return start_s_; }  ///< time of frame 0
  double frame_s() const noexcept { return frame_s_; }  ///< time from one frame to the next
  double duration_s() const noexcept { return frame_s_ * (frame_count() - 1); }
  std::span<const GeometryFrame> frames() const noexcept { return frames_; }
  std::uint64_t file_bytes() const noexcept { return file_bytes_; }
  std::uint64_t largest_frame() const noexcept { return largest_frame_; }
  /// Checksum of the directory, which contains the checksums of all frames: identifies the content of the file.
  std::uint64_t content() const noexcept { return content_; }

  /// Converts a time on the cache's clock, clamped to its ends. Times within a millionth of a frame interval snap to
  /// the frame, so that rounded multiples of frame_s hit their frames exactly.
  FrameTime frame_time(double time_s) const noexcept;

  /// Bounding box of a mesh in a frame, known before the frame is decoded.
  Aabb bounds(std::uint32_t frame, std::size_t mesh) const noexcept;

 private:
  friend class GeometryHeadReader;
  std::vector<GeometryMesh> meshes_;
  std::vector<GeometryFrame> frames_;
  std::vector<std::uint16_t> boxes_;  // [frames][meshes][6] relative to the mesh's bounds, in 65535ths
  std::size_t stream_count_ = 0;
  std::uint32_t segment_frames_ = 1;
  double start_s_ = 0.0, frame_s_ = 1.0;
  std::uint64_t file_bytes_ = 0, largest_frame_ = 0, content_ = 0;
};

/// True if the bytes start with the magic of geometry caches.
SINEW_API bool looks_like_geometry_cache(std::span<const std::byte> start) noexcept;

inline constexpr std::uint32_t kGeometryFileVersion = 1;
inline constexpr std::size_t kGeometryFileHead = 40;

}  // namespace sinew
