// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/mesh.h"

namespace sinew {

/// Why bytes are refused: the broken rule, the byte where it was found, and the case in words.
///
///     cache-magic      the bytes do not begin as such files do
///     cache-version    another version of the library wrote it: bake it again
///     cache-checksum   bytes have changed since it was written
///     cache-value      a number makes no sense where it is
///     cache-size       the bytes end too early
struct GeometryCacheError {
  std::string rule;
  std::uint64_t offset = 0;
  std::string detail;
};

/// What the three numbers of a stream are.
enum class GeometryKind : std::uint8_t { positions, normals, colors };

/// One attribute of a mesh over time. Vertices with equal values in all frames share one point.
struct GeometryStream {
  GeometryKind kind = GeometryKind::positions;
  float step = 0.0f;                           ///< a value is a whole number of these
  std::uint32_t point_count = 0;               ///< in the order in which they lie in the file
  std::vector<std::uint32_t> point_of_vertex;  ///< [vertices] the point that each vertex of the mesh takes
  std::vector<std::uint8_t> corners;           ///< [3 * 64 * blocks] as MoveBlocksJob::corners
  std::uint32_t most_payload = 0;              ///< bytes of residuals in the largest frame
  double asked = 0.0;     ///< largest distance that was asked for: metres, or the length of a difference of normals or
                          ///< colours
  double measured = 0.0;  ///< largest distance of a decoded value in any frame, measured after decoding

  std::size_t block_count() const noexcept { return (point_count + std::size_t{63}) / 64; }
};

/// Largest distances of positions in metres, over all vertices and frames of a mesh.
struct GeometryCertificate {
  double asked_m = 0.0;     ///< as GeometryStream::asked of positions
  double measured_m = 0.0;  ///< as GeometryStream::measured
  double between_m = -1.0;  ///< half way between frames, of positions interpolated linearly; negative = not measured
};

struct GeometryMesh {
  std::string name;
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;  ///< [3 * triangles] empty = kept elsewhere
  std::vector<GeometryStream> streams;   ///< at most one of each kind, in the order of kinds; positions are there
  GeometryCertificate certificate;
  Aabb bounds;  ///< of all frames
};

/// Where the bytes of a frame lie in the file.
struct GeometryFrame {
  std::uint64_t offset = 0;
  std::uint32_t size = 0;
  std::uint64_t checksum = 0;
};

/// A time as a frame and the part of the way to the next one.
struct FrameTime {
  std::uint32_t frame = 0;
  float part = 0.0f;  ///< [0, 1]; 0 in the last frame
};

/// The head of a geometry cache: what is in the file and where each frame lies, without the frames themselves. Vertices
/// of every frame are stored, for simulations and whatever else no skeleton can move. GeometryDecoder decodes it.
class GeometryCache {
 public:
  /// Bytes from the start of the file that `open` needs; 0 when these are too few to tell (kGeometryFileHead are
  /// enough) or no geometry cache.
  static std::uint64_t head_bytes(std::span<const std::byte> start) noexcept;

  /// in   head       the file, or its first head_bytes()
  ///      file_size  bytes of the whole file
  /// Any bytes may be passed. Memory stays below 16 MiB and 64 times the head.
  /// err  GeometryCacheError;  cost O(head), allocates
  static tl::expected<GeometryCache, GeometryCacheError> open(std::span<const std::byte> head, std::uint64_t file_size);
  static tl::expected<GeometryCache, GeometryCacheError> open(std::span<const std::byte> file) {
    return open(file, file.size());
  }

  std::span<const GeometryMesh> meshes() const noexcept { return meshes_; }
  std::size_t stream_count() const noexcept { return stream_count_; }  ///< of all meshes, one mesh after another
  std::uint32_t frame_count() const noexcept { return static_cast<std::uint32_t>(frames_.size()); }
  std::uint32_t segment_frames() const noexcept { return segment_frames_; }  ///< every such frame is a key frame
  std::uint32_t key_frame_of(std::uint32_t frame) const noexcept { return frame - frame % segment_frames_; }
  double start_s() const noexcept { return start_s_; }  ///< time of frame 0
  double frame_s() const noexcept { return frame_s_; }  ///< time from one frame to the next
  double duration_s() const noexcept { return frame_s_ * (frame_count() - 1); }
  std::span<const GeometryFrame> frames() const noexcept { return frames_; }
  std::uint64_t file_bytes() const noexcept { return file_bytes_; }
  std::uint64_t largest_frame() const noexcept { return largest_frame_; }
  std::uint64_t content() const noexcept {
    return content_;
  }  ///< checksum of the directory, which has those of all
     ///< frames: tells files apart

  /// Where a time lies on the clock of the cache, clamped to its ends. Within a millionth of the time between frames it
  /// is the frame, so that multiples of frame_s are, however they are rounded.
  FrameTime frame_time(double time_s) const noexcept;

  /// Box that holds all vertices of a mesh in a frame, known before the frame is decoded.
  Aabb bounds(std::uint32_t frame, std::size_t mesh) const noexcept;

 private:
  friend class GeometryHeadReader;
  std::vector<GeometryMesh> meshes_;
  std::vector<GeometryFrame> frames_;
  std::vector<std::uint16_t> boxes_;  // [frames][meshes][6] parts of the mesh's bounds, in 65535ths
  std::size_t stream_count_ = 0;
  std::uint32_t segment_frames_ = 1;
  double start_s_ = 0.0, frame_s_ = 1.0;
  std::uint64_t file_bytes_ = 0, largest_frame_ = 0, content_ = 0;
};

/// True when the bytes begin as geometry caches do.
bool looks_like_geometry_cache(std::span<const std::byte> start) noexcept;

inline constexpr std::uint32_t kGeometryFileVersion = 1;
inline constexpr std::size_t kGeometryFileHead = 40;

}  // namespace sinew
