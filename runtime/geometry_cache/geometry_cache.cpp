// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_cache.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"

namespace sinew {
namespace {

/// Tables of a directory may take at most this much memory: kMadeBytes plus kMadeTimes the size of the head.
constexpr std::uint64_t kMadeBytes = std::uint64_t{16} << 20, kMadeTimes = 64;

tl::unexpected<GeometryCacheError> refuse(const char* rule, std::uint64_t offset, const char* detail) {
  return tl::unexpected(GeometryCacheError{rule, offset, detail});
}

}  // namespace

/// Reads a directory. The first broken rule is kept.
class GeometryHeadReader {
 public:
  explicit GeometryHeadReader(std::span<const std::byte> head)
      : head_(head), in_(head, kGeometryFileHead), left_(kMadeBytes + kMadeTimes * head.size()) {}

  void read(GeometryCache& cache) {
    cache.start_s_ = in_.number<double>();
    cache.frame_s_ = in_.number<double>();
    const auto frames = in_.number<std::uint32_t>();
    cache.segment_frames_ = in_.number<std::uint32_t>();
    const auto meshes = in_.number<std::uint32_t>();
    require(std::isfinite(cache.start_s_) && std::isfinite(cache.frame_s_) && cache.frame_s_ > 0.0,
            "the times of frames are no times");
    require(frames > 0 && cache.segment_frames_ > 0, "there are no frames");
    for (std::uint32_t m = 0; m < meshes && ok(); ++m) add_mesh(cache);
    read_frames(cache, frames);
    if (ok() && in_.left() > 0) error_ = {"cache-size", in_.offset(), "bytes follow the directory"};
  }

  /// False if a rule was broken or bytes are missing.
  bool ok() {
    if (in_.ended() && error_.rule.empty()) error_ = {"cache-size", in_.offset(), "the directory ends too early"};
    return error_.rule.empty();
  }
  const GeometryCacheError& error() const noexcept { return error_; }

 private:
  void require(bool holds, const char* detail) {
    if (ok() && !holds) error_ = {"cache-value", in_.offset(), detail};
  }

  double finite() {
    const auto number = in_.number<double>();
    require(std::isfinite(number), "a distance of the certificate is not finite");
    return number;
  }

  /// Reads a section that must have `size` bytes when unpacked.
  std::vector<std::uint8_t> bytes(std::uint64_t size) {
    const auto head = in_.number<std::uint32_t>();
    const std::uint32_t stored = head & ~kStoredByZstd;
    require(size <= left_, "the directory describes far more than its bytes account for");
    require(stored <= in_.left(), "a table goes on after the end of the directory");
    if (!ok()) return {};
    left_ -= size;
    std::vector<std::uint8_t> out(size);
    const auto from = head_.subspan(in_.offset(), stored);
    if ((head & kStoredByZstd) != 0) {
      if (!unpacker_) unpacker_.emplace();
      require(unpacker_->unpack(from, true, out) == size, "a table is not of its size");
    } else {
      require(stored == size, "a table is not of its size");
      if (ok() && size > 0) std::memcpy(out.data(), from.data(), size);
    }
    in_.skip(stored);
    return out;
  }

  std::vector<std::uint32_t> numbers(std::uint64_t count, std::uint64_t below, const char* detail) {
    std::vector<std::uint32_t> out = numbers_of_planes(bytes(4 * count));
    require(std::all_of(out.begin(), out.end(), [&](std::uint32_t x) { return x < below; }), detail);
    return out;
  }

  void add_mesh(GeometryCache& cache) {
    GeometryMesh& mesh = cache.meshes_.emplace_back();
    const std::vector<char> name = in_.numbers<char>();
    mesh.name.assign(name.begin(), name.end());
    mesh.vertex_count = in_.number<std::uint32_t>();
    const auto corners = in_.number<std::uint32_t>();
    require(mesh.vertex_count <= kMaxPoints && corners % 3 == 0, "a mesh is too large, or not of triangles");
    mesh.triangles = numbers(corners, mesh.vertex_count, "a triangle names a vertex that is not there");
    mesh.certificate.between_m = finite();
    for (int axis = 0; axis < 3; ++axis) mesh.bounds.lower[axis] = in_.number<float>();
    for (int axis = 0; axis < 3; ++axis) mesh.bounds.upper[axis] = in_.number<float>();
    for (int axis = 0; axis < 3; ++axis)
      require(std::isfinite(mesh.bounds.lower[axis]) && std::isfinite(mesh.bounds.upper[axis]) &&
                  std::isfinite(mesh.bounds.upper[axis] - mesh.bounds.lower[axis]),
              "a box is not finite");
    const auto streams = in_.number<std::uint8_t>();
    require(streams > 0 && streams <= 3, "a mesh has no streams, or too many");
    for (std::uint8_t s = 0; s < streams && ok(); ++s) add_stream(mesh);
    require(ok() && mesh.streams[0].kind == GeometryKind::positions, "the first stream of a mesh is not its positions");
    if (!ok()) return;
    mesh.certificate.asked_m = mesh.streams[0].asked;
    mesh.certificate.measured_m = mesh.streams[0].measured;
    cache.stream_count_ += mesh.streams.size();
  }

  void add_stream(GeometryMesh& mesh) {
    GeometryStream& stream = mesh.streams.emplace_back();
    const auto kind = in_.number<std::uint8_t>();
    stream.kind = static_cast<GeometryKind>(kind);
    stream.step = in_.number<float>();
    stream.point_count = in_.number<std::uint32_t>();
    stream.most_payload = in_.number<std::uint32_t>();
    stream.asked = finite();
    stream.measured = finite();
    require(kind <= static_cast<std::uint8_t>(GeometryKind::colors), "there is no such kind of stream");
    require(mesh.streams.size() < 2 || mesh.streams[mesh.streams.size() - 2].kind < stream.kind,
            "the streams of a mesh are not in the order of their kinds, one of each");
    require(std::isfinite(stream.step) && stream.step > 0.0f, "the step of a stream is no length");
    require(stream.point_count <= mesh.vertex_count, "a stream has more points than its mesh has vertices");
    require(stream.most_payload <= stream.block_count() * kBlockNumbers * 4, "the residuals of a stream are too large");
    stream.point_of_vertex = numbers(mesh.vertex_count, stream.point_count, "a vertex has a point that is not there");
    stream.corners = bytes(stream.block_count() * kBlockNumbers);
    for (std::size_t i = 0; i < stream.corners.size() && ok(); ++i)
      require(stream.corners[i] == kNoCorner || stream.corners[i] < i / 3 % kBlockPoints,
              "a point follows from one that comes later");
  }

  void read_frames(GeometryCache& cache, std::uint64_t count) {
    const std::uint64_t boxes = 6 * count * cache.meshes_.size();
    std::vector<std::uint32_t> sizes = numbers(count, kStoredByZstd, "a frame is too large");
    const std::vector<std::uint8_t> sums = bytes(8 * count), box_bytes = bytes(2 * boxes);
    require(count * sizeof(GeometryFrame) <= left_, "the directory describes far more than its bytes account for");
    if (!ok()) return;
    cache.frames_.reserve(count);
    cache.boxes_.resize(boxes);
    if (boxes > 0) std::memcpy(cache.boxes_.data(), box_bytes.data(), box_bytes.size());
    std::uint64_t offset = head_.size();
    for (std::size_t f = 0; f < count; ++f) {
      GeometryFrame& frame = cache.frames_.emplace_back(GeometryFrame{offset, sizes[f], 0});
      std::memcpy(&frame.checksum, sums.data() + 8 * f, 8);
      offset += frame.size;
      cache.largest_frame_ = std::max<std::uint64_t>(cache.largest_frame_, frame.size);
    }
    require(offset == cache.file_bytes_, "the frames are not as long as the file");
  }

  std::span<const std::byte> head_;
  ByteReader in_;
  std::optional<Unpacker> unpacker_;  // created on first use
  std::uint64_t left_;
  GeometryCacheError error_;
};

bool looks_like_geometry_cache(std::span<const std::byte> start) noexcept {
  return start.size() >= sizeof(kGeometryMagic) &&
         std::memcmp(start.data(), kGeometryMagic, sizeof(kGeometryMagic)) == 0;
}

std::uint64_t GeometryCache::head_bytes(std::span<const std::byte> start) noexcept {
  if (start.size() < kGeometryFileHead || !looks_like_geometry_cache(start)) return 0;
  return ByteReader(start, 16).number<std::uint64_t>();
}

tl::expected<GeometryCache, GeometryCacheError> GeometryCache::open(std::span<const std::byte> head,
                                                                    std::uint64_t file_size) {
  if (!looks_like_geometry_cache(head)) return refuse("cache-magic", 0, "this is no geometry cache");
  if (head.size() < kGeometryFileHead) return refuse("cache-size", head.size(), "the file ends inside of its head");
  ByteReader in(head, sizeof(kGeometryMagic));
  if (in.number<std::uint32_t>() != kGeometryFileVersion)
    return refuse("cache-version", 8, "baked by another version of the library: bake it again");
  if (in.number<std::uint32_t>() != 0) return refuse("cache-value", 12, "reserved bytes are not 0");
  const auto size = in.number<std::uint64_t>();
  if (size < kGeometryFileHead || size > head.size())
    return refuse("cache-size", 16, "the file ends inside of its directory");
  if (in.number<std::uint64_t>() != file_size)
    return refuse("cache-size", 24, "the file is longer or shorter than it says");
  head = head.first(size);
  const std::uint64_t content = checksum(head.subspan(kGeometryFileHead));
  if (in.number<std::uint64_t>() != content)
    return refuse("cache-checksum", 32, "the directory has changed since it was written");
  GeometryCache cache;
  cache.file_bytes_ = file_size;
  cache.content_ = content;
  GeometryHeadReader reader(head);
  reader.read(cache);
  if (!reader.ok()) return tl::unexpected(reader.error());
  return cache;
}

FrameTime GeometryCache::frame_time(double time_s) const noexcept {
  const double at = (time_s - start_s_) / frame_s_, last = frame_count() - 1.0;
  const double clamped = at > 0.0 ? std::min(at, last) : 0.0;  // NaN becomes 0
  const double nearest = std::round(clamped);
  if (std::abs(clamped - nearest) <= 1e-6) return {static_cast<std::uint32_t>(nearest), 0.0f};
  const auto frame = static_cast<std::uint32_t>(clamped);
  return {frame, static_cast<float>(clamped - frame)};
}

Aabb GeometryCache::bounds(std::uint32_t frame, std::size_t mesh) const noexcept {
  const Aabb& all = meshes_[mesh].bounds;
  const std::uint16_t* parts = boxes_.data() + 6 * (std::size_t{frame} * meshes_.size() + mesh);
  Aabb out;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = double{all.upper[axis]} - all.lower[axis];
    out.lower[axis] = static_cast<float>(all.lower[axis] + size * parts[axis] / 65535.0);
    out.upper[axis] = static_cast<float>(all.upper[axis] - size * parts[3 + axis] / 65535.0);
  }
  return out;
}

}  // namespace sinew
