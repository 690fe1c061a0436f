// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <vector>

#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"
#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {
namespace {

constexpr std::uint32_t kPoints = 70, kFrames = 4, kSegment = 3;

void play(const GeometryCache& cache, Bytes file) {
  std::size_t vertices = 0;
  for (const GeometryMesh& mesh : cache.meshes()) vertices += mesh.vertex_count;
  if (cache.frame_count() > 1000 || vertices > 100'000) return;  // long, and nothing new
  GeometryDecoder decoder(cache);
  MappedFrames source{cache, file};
  std::vector<glm::vec3> out;
  for (const std::uint32_t frame : {0u, 1u, 2u, 3u, cache.frame_count() - 1, 0u}) {
    decoder.decode(std::min(frame, cache.frame_count() - 1), source);
    std::size_t stream = 0;
    for (const GeometryMesh& mesh : cache.meshes())
      for (std::size_t s = 0; s < mesh.streams.size(); ++s) {
        out.resize(mesh.vertex_count);
        decoder.write_vertices(stream++, out);
      }
  }
}

/// A table of a directory, stored as it is.
void add_table(std::span<const std::uint8_t> bytes, ByteWriter& out) {
  out.add(static_cast<std::uint32_t>(bytes.size()));
  for (const std::uint8_t byte : bytes) out.add(byte);
}

/// One mesh of one stream, without its frames.
void add_mesh(ByteWriter& out) {
  out.add(std::uint32_t{0});  // no name
  out.add(kPoints);
  out.add(std::uint32_t{0});  // no triangles
  add_table({}, out);
  for (int k = 0; k < 3; ++k) out.add(0.0);
  for (int k = 0; k < 6; ++k) out.add(static_cast<float>(k / 3));
  out.add(std::uint8_t{1});
  out.add(std::uint8_t{0});
  out.add(0.5f);
  out.add(kPoints);
  out.add(static_cast<std::uint32_t>(2 * kBlockNumbers * 4));
  add_table(planes_of_numbers(std::vector<std::uint32_t>(kPoints, kPoints - 1)), out);
  std::vector<std::uint8_t> corners(2 * kBlockNumbers, kNoCorner);
  for (std::size_t i = 3; i < corners.size(); ++i)
    if (i / 3 % kBlockPoints > 0) corners[i] = static_cast<std::uint8_t>(i / 3 % kBlockPoints - 1);
  add_table(corners, out);
}

/// A file that is right up to the frames: these are the input after three sizes of 16 bits, with right checksums.
std::vector<std::byte> file_around(Bytes input) {
  ByteReader sizes_in(input);
  std::vector<std::size_t> wanted;
  for (std::size_t f = 0; f + 1 < kFrames; ++f) wanted.push_back(sizes_in.number<std::uint16_t>());
  std::vector<Bytes> frames;
  Bytes left = input.subspan(sizes_in.offset());
  wanted.push_back(left.size());
  for (const std::size_t size : wanted) {
    frames.push_back(left.first(std::min(size, left.size())));
    left = left.subspan(frames.back().size());
  }
  ByteWriter directory;
  directory.add(0.0);
  directory.add(1.0);
  for (const std::uint32_t number : {kFrames, kSegment, 1u}) directory.add(number);
  add_mesh(directory);
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint8_t> sums(8 * kFrames);
  for (std::size_t f = 0; f < kFrames; ++f) {
    sizes.push_back(static_cast<std::uint32_t>(frames[f].size()));
    const std::uint64_t sum = checksum(frames[f]);
    std::memcpy(sums.data() + 8 * f, &sum, sizeof(sum));
  }
  add_table(planes_of_numbers(sizes), directory);
  add_table(sums, directory);
  add_table(std::vector<std::uint8_t>(2 * 6 * kFrames, 0), directory);
  ByteWriter out;
  for (const char c : kGeometryMagic) out.add(c);
  out.add(kGeometryFileVersion);
  out.add(std::uint32_t{0});
  out.add(static_cast<std::uint64_t>(kGeometryFileHead + directory.bytes().size()));
  std::uint64_t size = kGeometryFileHead + directory.bytes().size();
  for (const Bytes frame : frames) size += frame.size();
  out.add(size);
  out.add(checksum(directory.bytes()));
  std::vector<std::byte>& file = out.bytes();
  file.insert(file.end(), directory.bytes().begin(), directory.bytes().end());
  for (const Bytes frame : frames) file.insert(file.end(), frame.begin(), frame.end());
  return std::move(file);
}

/// The input as a file whose directory has the right checksum and size.
std::vector<std::byte> signed_file(Bytes input) {
  std::vector<std::byte> file(input.begin(), input.end());
  if (file.size() < kGeometryFileHead) return file;
  const std::uint64_t head = GeometryCache::head_bytes(file), size = file.size();
  std::memcpy(file.data() + 24, &size, sizeof(size));
  if (head < kGeometryFileHead || head > file.size()) return file;
  const std::uint64_t sum = checksum(std::span(file).subspan(kGeometryFileHead, head - kGeometryFileHead));
  std::memcpy(file.data() + 32, &sum, sizeof(sum));
  return file;
}

}  // namespace

void play_geometry(Bytes input) {
  const auto as_it_is = GeometryCache::open(input);
  if (!as_it_is) require(!as_it_is.error().rule.empty(), "an error names its rule");
  const std::vector<std::byte> file = signed_file(input);
  if (const auto cache = GeometryCache::open(file)) play(*cache, file);
  const std::vector<std::byte> around = file_around(input);
  const auto cache = GeometryCache::open(around);
  require(cache.has_value(), "frames do not decide whether a cache opens");
  play(*cache, around);
}

}  // namespace sinew::fuzz
