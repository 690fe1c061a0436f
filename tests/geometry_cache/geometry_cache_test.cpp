// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

Bytes small_file() {
  GeometryTake take = noise_take(70, 6, 1e-2);
  take.meshes[0].triangles = {0, 1, 2, 2, 1, 3};
  return *encode_geometry_cache(take, {.segment_frames = 3});
}

/// Decodes all frames; true if all succeed.
bool decode_all(const GeometryCache& cache, std::span<const std::byte> file) {
  GeometryDecoder decoder(cache);
  MappedFrames source{cache, file};
  bool all = true;
  for (std::uint32_t f = 0; f < cache.frame_count(); ++f) all = decoder.decode(f, source) == GeometryStatus::ok && all;
  return all;
}

/// Updates the checksum of the directory after a change.
void sign(Bytes& file) {
  const std::uint64_t head = GeometryCache::head_bytes(file);
  if (head < kGeometryFileHead || head > file.size()) return;
  const std::uint64_t sum = checksum(std::span(file).subspan(kGeometryFileHead, head - kGeometryFileHead));
  std::memcpy(file.data() + 32, &sum, sizeof(sum));
}

/// The table of parallelogram corners of the first mesh, in the directory.
class CornersInFile {
 public:
  explicit CornersInFile(Bytes file) : file_(std::move(file)), in_(file_, kGeometryFileHead) {
    in_.skip(2 * sizeof(double) + 3 * sizeof(std::uint32_t));  // times, numbers of frames, frames per segment, meshes
    in_.numbers<char>();                                       // name
    in_.skip(2 * sizeof(std::uint32_t));                       // vertices, corners of triangles
    skip_table();                                              // triangles
    in_.skip(sizeof(double) + 6 * sizeof(float) + 1);          // certificate, box, streams
    in_.skip(1 + sizeof(float) + 2 * sizeof(std::uint32_t) +
             2 * sizeof(double));  // kind, step, points, largest payload, asked and measured
    skip_table();                  // points of vertices
    begin_ = in_.offset();
    skip_table();
  }

  /// The file with other corners, stored unpacked, and with corrected counts and checksums.
  Bytes with(std::span<const std::uint8_t> corners) {
    ByteWriter table;
    table.add(static_cast<std::uint32_t>(corners.size()));
    Bytes out(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(begin_));
    out.insert(out.end(), table.bytes().begin(), table.bytes().end());
    const auto bytes = std::as_bytes(corners);
    out.insert(out.end(), bytes.begin(), bytes.end());
    out.insert(out.end(), file_.begin() + static_cast<std::ptrdiff_t>(in_.offset()), file_.end());
    const std::uint64_t head = GeometryCache::head_bytes(file_) + out.size() - file_.size(), size = out.size();
    std::memcpy(out.data() + 16, &head, sizeof(head));
    std::memcpy(out.data() + 24, &size, sizeof(size));
    sign(out);
    return out;
  }

 private:
  void skip_table() { in_.skip(in_.number<std::uint32_t>() & ~kStoredByZstd); }

  Bytes file_;
  ByteReader in_;
  std::size_t begin_ = 0;
};

TEST(geometry_cache, corners_of_parallelograms_come_before_their_point) {
  const Bytes good = *encode_geometry_cache(flag_take(4), {});
  const std::vector<std::uint8_t> corners = GeometryCache::open(good)->meshes()[0].streams[0].corners;
  ASSERT_GT(corners.size(), 6 * std::size_t{kBlockPoints});
  CornersInFile in_file(good);
  const auto rule_with = [&](std::size_t at, std::uint8_t corner) {
    std::vector<std::uint8_t> changed = corners;
    changed[at] = corner;
    const auto cache = GeometryCache::open(in_file.with(changed));
    return cache ? std::string() : cache.error().rule;
  };
  EXPECT_EQ(rule_with(0, corners[0]), "") << "as it was";
  for (const std::size_t point :
       {std::size_t{0}, std::size_t{1}, std::size_t{31}, std::size_t{63}, std::size_t{64}, std::size_t{127}})
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t in_block = point % kBlockPoints, at = 3 * point + k;
      EXPECT_EQ(rule_with(at, static_cast<std::uint8_t>(in_block)), "cache-value") << "itself, point " << point;
      if (in_block < kBlockPoints - 1) {
        EXPECT_EQ(rule_with(at, static_cast<std::uint8_t>(in_block + 1)), "cache-value") << "later, point " << point;
      }
      if (in_block > 0) {
        EXPECT_EQ(rule_with(at, static_cast<std::uint8_t>(in_block - 1)), "") << "point " << point;
      }
      EXPECT_EQ(rule_with(at, kNoCorner), "") << "none, point " << point;
      EXPECT_EQ(rule_with(at, kNoCorner + 1), "cache-value") << "outside of its block, point " << point;
    }
}

TEST(geometry_cache, says_what_is_in_the_file) {
  GeometryTake take = flag_take(9);
  take.start_s = 2.0;
  take.frame_s = 0.04;
  const Bytes file = *encode_geometry_cache(take, {.segment_frames = 4});
  const auto cache = GeometryCache::open(file);
  ASSERT_TRUE(cache.has_value());
  EXPECT_EQ(cache->frame_count(), 9u);
  EXPECT_EQ(cache->segment_frames(), 4u);
  EXPECT_EQ(cache->key_frame_of(7), 4u);
  EXPECT_EQ(cache->start_s(), 2.0);
  EXPECT_DOUBLE_EQ(cache->duration_s(), 0.32);
  EXPECT_EQ(cache->file_bytes(), file.size());
  ASSERT_EQ(cache->meshes().size(), 1u);
  EXPECT_EQ(cache->meshes()[0].name, "mesh");
  EXPECT_EQ(cache->meshes()[0].triangles, take.meshes[0].triangles);
  const Bytes without = *encode_geometry_cache(take, {.keep_triangles = false});
  EXPECT_TRUE(GeometryCache::open(without)->meshes()[0].triangles.empty());
}

TEST(geometry_cache, the_head_alone_is_enough_to_open_it) {
  const Bytes file = small_file();
  const std::uint64_t head = GeometryCache::head_bytes(std::span(file).first(kGeometryFileHead));
  ASSERT_LT(head, file.size());
  EXPECT_TRUE(GeometryCache::open(std::span(file).first(head), file.size()).has_value());
  EXPECT_FALSE(GeometryCache::open(std::span(file).first(head - 1), file.size()).has_value());
  EXPECT_FALSE(GeometryCache::open(std::span(file).first(head), file.size() + 1).has_value());
  EXPECT_EQ(GeometryCache::head_bytes(std::span(file).first(kGeometryFileHead - 1)), 0u);
}

TEST(geometry_cache, every_truncated_file_is_refused) {
  const Bytes file = small_file();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const auto cache = GeometryCache::open(std::span(file).first(size));
    ASSERT_FALSE(cache.has_value()) << size;
    EXPECT_THAT(cache.error().rule, testing::AnyOf("cache-magic", "cache-size", "cache-checksum")) << size;
  }
}

TEST(geometry_cache, every_flipped_bit_is_seen) {
  Bytes file = small_file();
  for (std::size_t at = 0; at < file.size(); ++at)
    for (const unsigned bit : {0u, 3u, 7u}) {
      file[at] ^= std::byte(1u << bit);
      const auto cache = GeometryCache::open(file);
      EXPECT_FALSE(cache.has_value() && decode_all(*cache, file)) << "byte " << at << " bit " << bit;
      file[at] ^= std::byte(1u << bit);
    }
}

TEST(geometry_cache, flipped_bits_with_a_right_checksum_never_lead_outside_of_buffers) {
  Bytes file = small_file();
  const std::uint64_t head = GeometryCache::head_bytes(file);
  for (std::size_t at = 0; at < head; ++at)
    for (unsigned bit = 0; bit < 8; ++bit) {
      file[at] ^= std::byte(1u << bit);
      Bytes changed = file;
      sign(changed);
      if (const auto cache = GeometryCache::open(changed)) decode_all(*cache, changed);
      file[at] ^= std::byte(1u << bit);
    }
}

TEST(geometry_cache, a_damaged_frame_is_refused_and_the_next_segment_plays) {
  Bytes file = small_file();
  const auto cache = GeometryCache::open(file);
  ASSERT_TRUE(cache.has_value());
  file[cache->frames()[1].offset + 20] ^= std::byte(4);
  GeometryDecoder decoder(*cache);
  MappedFrames source{*cache, file};
  EXPECT_EQ(decoder.decode(0, source), GeometryStatus::ok);
  EXPECT_EQ(decoder.decode(1, source), GeometryStatus::damaged);
  EXPECT_EQ(decoder.frame(), kNone);
  EXPECT_EQ(decoder.decode(2, source), GeometryStatus::damaged) << "it follows from the damaged one";
  EXPECT_EQ(decoder.decode(4, source), GeometryStatus::ok);
}

TEST(geometry_cache, each_rule_has_its_name) {
  const Bytes good = small_file();
  const auto rule_of = [](const Bytes& file) {
    const auto cache = GeometryCache::open(file);
    return cache ? std::string() : cache.error().rule;
  };
  EXPECT_EQ(rule_of(good), "");
  Bytes file = good;
  file[0] = std::byte('X');
  EXPECT_EQ(rule_of(file), "cache-magic");
  file = good;
  file[8] = std::byte(9);
  EXPECT_EQ(rule_of(file), "cache-version");
  file = good;
  file[12] = std::byte(1);
  EXPECT_EQ(rule_of(file), "cache-value");
  file = good;
  file[50] ^= std::byte(1);
  EXPECT_EQ(rule_of(file), "cache-checksum");
  file = good;
  file.resize(file.size() + 1);
  EXPECT_EQ(rule_of(file), "cache-size");
  file = good;
  file[kGeometryFileHead + 15] = std::byte(0xff);  // the sign of the time between frames
  sign(file);
  EXPECT_EQ(rule_of(file), "cache-value");
}

TEST(geometry_cache, a_mesh_has_one_stream_of_each_kind_in_their_order) {
  GeometryTake take = noise_take(70, 2, 1e-2);
  take.meshes[0].streams.push_back({GeometryKind::normals, take.meshes[0].streams[0].frames, 0.5});
  Bytes file = *encode_geometry_cache(take);
  const GeometryStream normals = GeometryCache::open(file)->meshes()[0].streams[1];
  Bytes head(1 + sizeof(float), std::byte(1));  // the start of a stream in the directory: kind, step, ...
  std::memcpy(&head[1], &normals.step, sizeof(float));
  const auto found = std::search(file.begin(), file.end(), head.begin(), head.end());
  ASSERT_NE(found, file.end());
  *found = std::byte(0);  // positions a second time
  sign(file);
  const auto cache = GeometryCache::open(file);
  ASSERT_FALSE(cache.has_value());
  EXPECT_EQ(cache.error().rule, "cache-value");
  EXPECT_THAT(cache.error().detail, testing::HasSubstr("kinds"));
}

TEST(geometry_cache, errors_of_the_head_name_the_place_of_their_number) {
  const Bytes good = small_file();
  const auto offset_with = [&](std::size_t at, std::uint8_t bits) {
    Bytes file = good;
    file[at] ^= std::byte(bits);
    const auto cache = GeometryCache::open(file);
    return cache ? std::uint64_t{999} : cache.error().offset;
  };
  EXPECT_EQ(offset_with(0, 1), 0u);
  EXPECT_EQ(offset_with(8, 2), 8u);
  EXPECT_EQ(offset_with(12, 1), 12u);
  EXPECT_EQ(offset_with(22, 1), 16u);
  EXPECT_EQ(offset_with(24, 1), 24u);
  EXPECT_EQ(offset_with(32, 1), 32u);
  EXPECT_EQ(offset_with(kGeometryFileHead, 1), 32u);
}

/// A file of one block in two frames. One byte of the second frame is changed, and the checksums are corrected.
Bytes with_changed_frame(std::size_t at, unsigned value) {
  Bytes file = *encode_geometry_cache(noise_take(64, 2, 1e-3));
  const auto cache = GeometryCache::open(file);
  const GeometryFrame frame = cache->frames()[1];
  file[frame.offset + at] = static_cast<std::byte>(value & 0xff);
  const std::uint64_t sum = checksum(std::span(file).subspan(frame.offset, frame.size));
  Bytes old(sizeof(sum));
  std::memcpy(old.data(), &frame.checksum, sizeof(sum));
  const auto found = std::search(file.begin(), file.end(), old.begin(), old.end());
  EXPECT_NE(found, file.end());
  std::memcpy(&*found, &sum, sizeof(sum));
  sign(file);
  return file;
}

TEST(geometry_cache, sections_that_do_not_fit_their_headers_are_damage_whatever_the_checksum_says) {
  const Bytes good = *encode_geometry_cache(noise_take(64, 2, 1e-3));
  const auto cache = GeometryCache::open(good);
  const std::size_t frame = cache->frames()[1].offset;
  std::uint32_t heads[kSections];
  std::memcpy(heads, good.data() + frame, sizeof(heads));
  for (const std::uint32_t head : heads) ASSERT_EQ(head & kStoredByZstd, 0u) << "noise is stored as it is";
  const auto is_whole = [](const Bytes& file) {
    const auto opened = GeometryCache::open(file);
    return opened.has_value() && decode_all(*opened, file);
  };
  const auto byte_at = [&](std::size_t at) { return static_cast<unsigned>(good[frame + at]); };
  EXPECT_TRUE(is_whole(with_changed_frame(0, byte_at(0))));
  for (std::size_t section = 0; section < kSections; ++section) {
    const std::size_t head = 4 * section;
    EXPECT_FALSE(is_whole(with_changed_frame(head + 3, byte_at(head + 3) | 0x80))) << "by zstd, section " << section;
    EXPECT_FALSE(is_whole(with_changed_frame(head + 2, 0x7f))) << "too long, section " << section;
    EXPECT_FALSE(is_whole(with_changed_frame(head, byte_at(head) - 1))) << section;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const unsigned more : {1u, ~0u}) {
      const std::size_t width = kSectionHeads + 2 + axis;
      EXPECT_FALSE(is_whole(with_changed_frame(width, byte_at(width) + more)))
          << "residuals of another width, axis " << axis;
    }
}

}  // namespace
}  // namespace sinew::test
