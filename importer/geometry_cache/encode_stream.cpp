// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/encode_stream.h"

#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "importer/geometry_cache/code_residuals.h"
#include "importer/geometry_cache/fit_block.h"
#include "importer/geometry_cache/order_points.h"
#include "importer/geometry_cache/unique_points.h"
#include "runtime/base/contract.h"
#include "runtime/geometry_cache/block_headers.h"
#include "runtime/geometry_cache/geometry_format.h"

namespace sinew {
namespace {

/// Appends the packed bits of a block: for each axis 64 numbers of `width` bits, lowest bits first.
void pack(const FittedBlock& block, std::vector<std::uint8_t>& out) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const unsigned width = block.motion.width[axis];
    std::uint64_t waiting = 0;
    unsigned have = 0;
    for (std::size_t i = 0; i < kBlockPoints && width > 0; ++i) {
      const std::uint64_t lower = zigzag(block.residuals[axis * kBlockPoints + i]) & ((std::uint64_t{1} << width) - 1);
      waiting |= lower << have;
      for (have += width; have >= 8; have -= 8) {
        out.push_back(static_cast<std::uint8_t>(waiting));
        waiting >>= 8;
      }
    }
  }
}

struct StoredFrame {
  std::vector<std::byte> bytes;
  std::uint32_t payload = 0;  // bytes before zstd
};

StoredFrame store(std::span<const FittedBlock> blocks) {
  std::vector<BlockMotion> motions;
  std::vector<std::uint8_t> payload;
  for (const FittedBlock& block : blocks) {
    motions.push_back(block.motion);
    pack(block, payload);
  }
  const BlockHeaderBytes heads = write_block_headers(motions);
  StoredFrame out{std::vector<std::byte>(kSectionHeads), static_cast<std::uint32_t>(payload.size())};
  const std::uint32_t sizes[kSections] = {store_bytes(heads.coarse, out.bytes), store_bytes(heads.fine, out.bytes),
                                          store_bytes(payload, out.bytes), store_bytes(write_codes(blocks), out.bytes)};
  std::memcpy(out.bytes.data(), sizes, sizeof(sizes));
  return out;
}

/// Encodes the frames of one stream one after another.
class StreamEncoder {
 public:
  StreamEncoder(EncodedStream& out, const std::vector<std::uint32_t>& vertex_of_point, double step, const Grid& grid)
      : out_(out), vertex_of_point_(vertex_of_point), step_(step), grid_(grid), x1_(out.info.block_count()), x2_(x1_) {}

  void add_frame(std::span<const glm::vec3> frame, std::uint32_t from_key) {
    std::vector<FittedBlock> blocks;
    for (std::size_t b = 0; b < x1_.size(); ++b) {
      blocks.push_back(fit(frame, b, from_key));
      x2_[b] = x1_[b];
      x1_[b] = blocks[b].state;
    }
    StoredFrame packed = store(blocks);
    for (FittedBlock& block : blocks) choose_codes(block);
    StoredFrame coded = store(blocks);
    StoredFrame& smaller = coded.bytes.size() < packed.bytes.size() ? coded : packed;
    out_.frames.push_back(std::move(smaller.bytes));
    out_.info.most_payload = std::max(out_.info.most_payload, smaller.payload);
  }

 private:
  FittedBlock fit(std::span<const glm::vec3> frame, std::size_t b, std::uint32_t from_key) const {
    const std::size_t first = b * kBlockPoints, count = std::min(kBlockPoints, vertex_of_point_.size() - first);
    BlockValues values{};
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t a = 0; a < 3; ++a)
        values[a * kBlockPoints + i] = frame[vertex_of_point_[first + i]][static_cast<int>(a)] / step_;
    const std::span corners = std::span(out_.info.corners).subspan(3 * first, kBlockNumbers);
    if (from_key == 0) return fit_in_space(values, count, corners, grid_);
    return fit_in_time(values, count, corners, x1_[b], x2_[b], from_key > 1, grid_);
  }

  EncodedStream& out_;
  const std::vector<std::uint32_t>& vertex_of_point_;
  double step_;
  Grid grid_;
  std::vector<BlockState> x1_, x2_;
};

/// Renumbers the points by their position in `order`.
void reorder(UniquePoints& unique, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size()), vertex_of_place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    vertex_of_place[i] = unique.vertex_of_point[order[i]];
  }
  for (std::uint32_t& point : unique.point_of_vertex) point = place[point];
  unique.vertex_of_point = std::move(vertex_of_place);
}

PointOrder order_of(const TakeStream& stream, const UniquePoints& unique, std::span<const std::uint32_t> triangles) {
  std::vector<std::vector<glm::vec3>> points;
  for (const std::vector<glm::vec3>& frame : stream.frames) {
    auto& p = points.emplace_back();
    for (const std::uint32_t v : unique.vertex_of_point) p.push_back(frame[v]);
  }
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t v : triangles) corners.push_back(unique.point_of_vertex[v]);
  return order_points(points, corners);
}

std::size_t bytes_of(const EncodedStream& stream) {
  std::size_t bytes = 0;
  for (const auto& frame : stream.frames) bytes += frame.size();
  return bytes;
}

}  // namespace

std::uint32_t store_bytes(std::span<const std::uint8_t> bytes, std::vector<std::byte>& out, int zstd_level) {
  const std::size_t before = out.size(), most = ZSTD_compressBound(bytes.size());
  CONTRACT(most < kStoredByZstd);
  out.resize(before + most);
  const std::size_t size = ZSTD_compress(out.data() + before, most, bytes.data(), bytes.size(), zstd_level);
  const bool smaller = ZSTD_isError(size) == 0u && size < bytes.size() - bytes.size() / 8;
  out.resize(before + (smaller ? size : bytes.size()));
  if (smaller) return static_cast<std::uint32_t>(size) | kStoredByZstd;
  if (!bytes.empty()) std::memcpy(out.data() + before, bytes.data(), bytes.size());
  return static_cast<std::uint32_t>(bytes.size());
}

EncodedStream encode_stream(const TakeStream& stream, std::span<const std::uint32_t> triangles, double within,
                            std::uint32_t segment_frames) {
  UniquePoints unique = find_unique_points(stream.frames);
  PointOrder order = order_of(stream, unique, triangles);
  reorder(unique, order.points);
  EncodedStream best;
  for (const bool centred : {false, true}) {
    EncodedStream out;
    out.info.kind = stream.kind;
    out.info.centred = centred;
    out.info.step = static_cast<float>(2.0 * within / std::sqrt(centred ? 5.0 : 3.0));
    out.info.point_count = static_cast<std::uint32_t>(order.points.size());
    out.info.point_of_vertex = unique.point_of_vertex;
    out.info.corners = order.corners;
    const auto step = static_cast<double>(out.info.step);
    StreamEncoder encoder(out, unique.vertex_of_point, step, {within / step * (1.0 + 1e-7), centred});
    for (std::uint32_t f = 0; f < stream.frames.size(); ++f) encoder.add_frame(stream.frames[f], f % segment_frames);
    if (!centred || bytes_of(out) < bytes_of(best)) best = std::move(out);
  }
  return best;
}

}  // namespace sinew
