// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/encode_stream.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "importer/geometry_cache/fit_block.h"
#include "importer/geometry_cache/order_points.h"
#include "importer/geometry_cache/unique_points.h"
#include "runtime/base/contract.h"
#include "runtime/geometry_cache/block_headers.h"
#include "runtime/geometry_cache/geometry_format.h"

namespace sinew {
namespace {

/// Appends the residuals of a block: for each axis 64 numbers of `width` bits, lowest bits first.
void pack(const FittedBlock& block, std::vector<std::uint8_t>& out) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const unsigned width = block.motion.width[axis];
    std::uint64_t waiting = 0;
    unsigned have = 0;
    for (std::size_t i = 0; i < kBlockPoints && width > 0; ++i) {
      waiting |= std::uint64_t{zigzag(block.residuals[axis * kBlockPoints + i])} << have;
      for (have += width; have >= 8; have -= 8) {
        out.push_back(static_cast<std::uint8_t>(waiting));
        waiting >>= 8;
      }
    }
  }
}

/// Encodes the frames of one stream one after another.
class StreamEncoder {
 public:
  StreamEncoder(EncodedStream& out, const std::vector<std::uint32_t>& vertex_of_point, double step, double reach)
      : out_(out),
        vertex_of_point_(vertex_of_point),
        step_(step),
        reach_(reach),
        x1_(out.info.block_count()),
        x2_(x1_) {}

  void add_frame(std::span<const glm::vec3> frame, std::uint32_t from_key) {
    std::vector<BlockMotion> motions;
    std::vector<std::uint8_t> payload;
    for (std::size_t b = 0; b < x1_.size(); ++b) {
      const FittedBlock block = fit(frame, b, from_key);
      motions.push_back(block.motion);
      pack(block, payload);
      x2_[b] = x1_[b];
      x1_[b] = block.state;
    }
    const BlockHeaderBytes heads = write_block_headers(motions);
    std::vector<std::byte>& bytes = out_.frames.emplace_back(kSectionHeads);
    const std::uint32_t sizes[kSections] = {store_bytes(heads.coarse, bytes), store_bytes(heads.fine, bytes),
                                            store_bytes(payload, bytes)};
    std::memcpy(bytes.data(), sizes, sizeof(sizes));
    out_.info.most_payload = std::max(out_.info.most_payload, static_cast<std::uint32_t>(payload.size()));
  }

 private:
  FittedBlock fit(std::span<const glm::vec3> frame, std::size_t b, std::uint32_t from_key) const {
    const std::size_t first = b * kBlockPoints, count = std::min(kBlockPoints, vertex_of_point_.size() - first);
    BlockValues values{};
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t a = 0; a < 3; ++a)
        values[a * kBlockPoints + i] = frame[vertex_of_point_[first + i]][static_cast<int>(a)] / step_;
    const std::span corners = std::span(out_.info.corners).subspan(3 * first, kBlockNumbers);
    if (from_key == 0) return fit_in_space(values, count, corners, reach_);
    return fit_in_time(values, count, corners, x1_[b], x2_[b], from_key > 1, reach_);
  }

  EncodedStream& out_;
  const std::vector<std::uint32_t>& vertex_of_point_;
  double step_, reach_;
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

EncodedStream encode_stream(const TakeStream& stream, std::span<const std::uint32_t> triangles, float step,
                            double reach, std::uint32_t segment_frames) {
  UniquePoints unique = find_unique_points(stream.frames);
  PointOrder order = order_of(stream, unique, triangles);
  reorder(unique, order.points);
  EncodedStream out;
  out.info.kind = stream.kind;
  out.info.step = step;
  out.info.point_count = static_cast<std::uint32_t>(order.points.size());
  out.info.point_of_vertex = std::move(unique.point_of_vertex);
  out.info.corners = std::move(order.corners);
  StreamEncoder encoder(out, unique.vertex_of_point, static_cast<double>(step), reach);
  for (std::uint32_t f = 0; f < stream.frames.size(); ++f) encoder.add_frame(stream.frames[f], f % segment_frames);
  return out;
}

}  // namespace sinew
