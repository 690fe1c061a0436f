// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_decoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "runtime/base/checksum.h"
#include "runtime/geometry_cache/block_headers.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"

namespace sinew {

MappedFrames::operator FrameSource() noexcept {
  const auto bytes_of = [](void* context, std::uint32_t frame) noexcept -> std::span<const std::byte> {
    const auto* in = static_cast<const MappedFrames*>(context);
    const GeometryFrame& at = in->cache.frames()[frame];
    if (at.offset > in->file.size() || at.size > in->file.size() - at.offset) return {};
    return in->file.subspan(at.offset, at.size);
  };
  return {bytes_of, this};
}

/// Two frames of one stream.
struct GeometryDecoder::Stream {
  const GeometryStream* info = nullptr;
  std::vector<std::int32_t> now, before;
};

/// Scratch memory for decoding one frame of a stream, large enough for all streams.
struct GeometryDecoder::Memory {
  Unpacker unpacker;
  std::vector<std::uint8_t> coarse, fine, payload;
  std::vector<BlockMotion> blocks;
  std::vector<glm::vec3> points;

  explicit Memory(const GeometryCache& cache) {
    std::size_t most_blocks = 0, most_payload = 0, most_points = 0;
    for (const GeometryMesh& mesh : cache.meshes())
      for (const GeometryStream& stream : mesh.streams) {
        most_blocks = std::max(most_blocks, stream.block_count());
        most_payload = std::max<std::size_t>(most_payload, stream.most_payload);
        most_points = std::max<std::size_t>(most_points, stream.point_count);
      }
    coarse.resize(most_coarse_bytes(most_blocks));
    fine.resize(most_fine_bytes(most_blocks));
    payload.resize(most_payload + kPayloadPadding);
    blocks.resize(most_blocks);
    points.resize(most_points);
  }

  std::size_t bytes() const noexcept {
    return coarse.size() + fine.size() + payload.size() + blocks.size() * sizeof(BlockMotion) +
           points.size() * sizeof(glm::vec3) + unpacker.memory_bytes();
  }
};

namespace {

/// Iterates over the sections of a frame, stream by stream.
class Sections {
 public:
  explicit Sections(std::span<const std::byte> bytes) : left_(bytes) {}

  /// Reads the heads of the three sections of the next stream.
  bool next_stream() noexcept {
    if (left_.size() < kSectionHeads) return false;
    std::memcpy(heads_, left_.data(), kSectionHeads);
    left_ = left_.subspan(kSectionHeads);
    return true;
  }

  /// Unpacks a section into the first bytes of `out`; SIZE_MAX on failure.
  std::size_t unpack(std::size_t section, Unpacker& unpacker, std::span<std::uint8_t> out) noexcept {
    const std::uint32_t size = heads_[section] & ~kStoredByZstd;
    if (size > left_.size()) return static_cast<std::size_t>(-1);
    const auto stored = left_.first(size);
    left_ = left_.subspan(size);
    return unpacker.unpack(stored, (heads_[section] & kStoredByZstd) != 0, out);
  }

  bool ended() const noexcept { return left_.empty(); }

 private:
  std::span<const std::byte> left_;
  std::uint32_t heads_[kSections] = {};
};

}  // namespace

GeometryDecoder::GeometryDecoder(const GeometryCache& cache) : cache_(cache), memory_(std::make_unique<Memory>(cache)) {
  for (const GeometryMesh& mesh : cache.meshes())
    for (const GeometryStream& stream : mesh.streams) {
      const std::size_t numbers = stream.block_count() * kBlockNumbers;
      streams_.push_back({&stream, std::vector<std::int32_t>(numbers), std::vector<std::int32_t>(numbers)});
    }
}
GeometryDecoder::~GeometryDecoder() = default;
GeometryDecoder::GeometryDecoder(GeometryDecoder&&) noexcept = default;

bool GeometryDecoder::decode_streams(std::span<const std::byte> bytes, FramePlace place) noexcept {
  Sections sections(bytes);
  Memory& m = *memory_;
  for (Stream& stream : streams_) {
    constexpr auto kFailed = static_cast<std::size_t>(-1);
    const std::span blocks = std::span(m.blocks).first(stream.info->block_count());
    if (!sections.next_stream()) return false;
    const std::size_t coarse = sections.unpack(0, m.unpacker, m.coarse);
    if (coarse == kFailed) return false;
    const std::size_t fine = sections.unpack(1, m.unpacker, m.fine);
    if (fine == kFailed) return false;
    const std::size_t payload =
        sections.unpack(2, m.unpacker, std::span(m.payload).first(m.payload.size() - kPayloadPadding));
    if (payload == kFailed) return false;
    if (!read_block_headers(std::span(m.coarse).first(coarse), std::span(m.fine).first(fine), place, blocks))
      return false;
    if (payload_bytes(blocks) != payload) return false;
    std::swap(stream.now, stream.before);
    run_unchecked(MoveBlocksJob{.blocks = blocks,
                                .payload = m.payload,
                                .corners = stream.info->corners,
                                .x1 = stream.before,
                                .x2 = stream.now,
                                .x = stream.now});
  }
  return sections.ended();
}

GeometryStatus GeometryDecoder::advance(std::uint32_t frame, FrameSource source) noexcept {
  const std::span<const std::byte> bytes = source.bytes(source.context, frame);
  const GeometryFrame& expected = cache_.frames()[frame];
  if (bytes.empty() && expected.size > 0) return GeometryStatus::not_loaded;
  const std::uint32_t from_key = frame - cache_.key_frame_of(frame);
  const FramePlace place = from_key == 0 ? FramePlace::key : from_key == 1 ? FramePlace::second : FramePlace::later;
  const bool follows = frame_ != kNone && frame_ + 1 == frame;
  frame_ = kNone;
  if (bytes.size() != expected.size || checksum(bytes) != expected.checksum || !decode_streams(bytes, place))
    return GeometryStatus::damaged;
  frame_ = frame;
  has_before_ = follows;
  part_ = 1.0f;
  ++frames_decoded_;
  return GeometryStatus::ok;
}

std::uint32_t GeometryDecoder::next_for(std::uint32_t frame) const noexcept {
  const std::uint32_t key = cache_.key_frame_of(frame);
  return frame_ != kNone && frame_ < frame && frame_ + 1 >= key ? frame_ + 1 : key;
}

GeometryStatus GeometryDecoder::decode(std::uint32_t frame, FrameSource source) noexcept {
  if (frame >= cache_.frame_count()) return GeometryStatus::out_of_range;
  part_ = 1.0f;
  if (frame_ == frame) return GeometryStatus::ok;
  const bool is_ahead = frame_ != kNone && frame_ < frame;
  if (const std::uint32_t next = next_for(frame); !is_ahead || next != frame_ + 1) {
    const GeometryStatus status = advance(next, source);
    const bool frames_before_may_help = status == GeometryStatus::not_loaded && is_ahead;
    if (status != GeometryStatus::ok && !frames_before_may_help) return status;
  }
  while (frame_ != frame)
    if (const GeometryStatus status = advance(frame_ + 1, source); status != GeometryStatus::ok) return status;
  return GeometryStatus::ok;
}

std::uint32_t GeometryDecoder::next_for_time(double time_s) const noexcept {
  const FrameTime at = cache_.frame_time(time_s);
  const std::uint32_t last = at.frame + (at.part > 0.0f);
  if (frame_ == last && (at.part == 0.0f || has_before_)) return (last + 1) % cache_.frame_count();
  return frame_ == at.frame ? last : next_for(at.frame);
}

GeometryStatus GeometryDecoder::decode_time(double time_s, FrameSource source) noexcept {
  if (std::isnan(time_s)) return GeometryStatus::out_of_range;
  const auto [frame, part] = cache_.frame_time(time_s);
  const bool is_between = part > 0.0f;
  if (is_between && frame_ == frame + 1 && has_before_) {
    part_ = part;
    return GeometryStatus::ok;
  }
  GeometryStatus status = decode(frame, source);
  if (status == GeometryStatus::ok && is_between) status = advance(frame + 1, source);
  if (status == GeometryStatus::ok && is_between) part_ = part;
  return status;
}

GeometryStatus GeometryDecoder::write_points(std::size_t stream, std::span<glm::vec3> out) const noexcept {
  if (stream >= streams_.size() || frame_ == kNone) return GeometryStatus::out_of_range;
  const Stream& s = streams_[stream];
  if (out.size() != s.info->point_count) return GeometryStatus::size_mismatch;
  run_unchecked(EmitPointsJob{.from = s.before, .to = s.now, .part = part_, .step = s.info->step, .out = out});
  return GeometryStatus::ok;
}

GeometryStatus GeometryDecoder::write_vertices(std::size_t stream, std::span<glm::vec3> out) noexcept {
  if (stream >= streams_.size() || frame_ == kNone) return GeometryStatus::out_of_range;
  const std::span<const std::uint32_t> point_of = streams_[stream].info->point_of_vertex;
  if (out.size() != point_of.size()) return GeometryStatus::size_mismatch;
  const std::span points = std::span(memory_->points).first(streams_[stream].info->point_count);
  const GeometryStatus status = write_points(stream, points);
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = points[point_of[v]];
  return status;
}

std::size_t GeometryDecoder::memory_bytes() const noexcept {
  std::size_t bytes = memory_->bytes();
  for (const Stream& stream : streams_) bytes += 2 * stream.now.size() * sizeof(std::int32_t);
  return bytes;
}

}  // namespace sinew
