// SPDX-License-Identifier: MIT
#include "tests/fuzz/geometry_mutator.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "runtime/base/checksum.h"
#include "runtime/clip/byte_stream.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/stored_bytes.h"
#include "tests/support/fixed_random.h"

namespace sinew::fuzz {
namespace {

using Blob = std::vector<std::byte>;

constexpr std::size_t kMostGrowth = 64, kMostUnpacked = 1 << 16;
constexpr std::size_t kFrameCountAt = 16, kMeshCountAt = 24;  // offsets in the directory

void change_bytes(Blob& bytes, const MutateBytes& mutate_bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(size + kMostGrowth);
  bytes.resize(mutate_bytes(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
}

/// The unpacked bytes of a section; empty if they cannot be unpacked.
Blob unpacked(Bytes stored, bool by_zstd) {
  static Unpacker unpacker;
  static std::vector<std::uint8_t> plain(kMostUnpacked);
  const std::size_t size = unpacker.unpack(stored, by_zstd, plain);
  const Bytes bytes = std::as_bytes(std::span(plain).first(size > plain.size() ? 0 : size));
  return {bytes.begin(), bytes.end()};
}

void append(Bytes bytes, Blob& out) { out.insert(out.end(), bytes.begin(), bytes.end()); }

/// Appends a table to a directory without compression.
void add_table(Bytes bytes, Blob& out) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  append(std::as_bytes(std::span(&size, 1)), out);
  append(bytes, out);
}

/// Copies a directory up to its tables of frames. The tables are stored uncompressed, so that changed bytes have an
/// effect.
class PlainDirectory {
 public:
  explicit PlainDirectory(Bytes directory) : directory_(directory), in_(directory) {}

  Blob copy() {
    copy_bytes(kMeshCountAt);
    for (auto meshes = copy_number<std::uint32_t>(); meshes > 0 && !in_.ended(); --meshes) {
      copy_bytes(copy_number<std::uint32_t>());  // name
      copy_bytes(2 * sizeof(std::uint32_t));
      copy_table();
      copy_bytes(sizeof(double) + 6 * sizeof(float));
      for (auto streams = copy_number<std::uint8_t>(); streams > 0 && !in_.ended(); --streams) {
        copy_bytes(1 + 3 * sizeof(std::uint32_t) + 2 * sizeof(double));
        copy_table();
        copy_table();
      }
    }
    return std::move(out_);
  }

 private:
  void copy_bytes(std::size_t size) {
    const std::size_t at = in_.offset();
    in_.skip(size);
    if (!in_.ended()) append(directory_.subspan(at, size), out_);
  }
  template <class T>
  T copy_number() {
    const T number = in_.number<T>();
    append(std::as_bytes(std::span(&number, 1)), out_);
    return number;
  }
  void copy_table() {
    const auto head = in_.number<std::uint32_t>(), size = head & ~kStoredByZstd;
    const std::size_t at = in_.offset();
    in_.skip(size);
    if (!in_.ended()) add_table(unpacked(directory_.subspan(at, size), head != size), out_);
  }

  Bytes directory_;
  ByteReader in_;
  Blob out_;
};

/// The parts of a cache. The directory is without its tables of frames, which are computed from the frames.
struct Parts {
  Blob directory;
  std::size_t mesh_count = 0;
  std::vector<Blob> frames;
};

std::optional<Parts> take_apart(Bytes file) {
  const auto cache = GeometryCache::open(file);
  if (!cache) return std::nullopt;
  Parts out;
  out.directory = PlainDirectory(file.subspan(kGeometryFileHead)).copy();
  out.mesh_count = cache->meshes().size();
  for (const GeometryFrame& frame : cache->frames()) {
    const Bytes bytes = file.subspan(frame.offset, frame.size);
    out.frames.emplace_back(bytes.begin(), bytes.end());
  }
  return out;
}

Blob put_together(Parts parts) {
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint64_t> sums;
  std::uint64_t size = kGeometryFileHead;
  for (const Blob& frame : parts.frames) {
    sums.push_back(checksum(frame));
    sizes.push_back(static_cast<std::uint32_t>(frame.size()));
    size += frame.size();
  }
  const auto count = static_cast<std::uint32_t>(sizes.size());
  if (parts.directory.size() >= kMeshCountAt)
    std::memcpy(parts.directory.data() + kFrameCountAt, &count, sizeof(count));
  const std::vector<std::uint8_t> planes = planes_of_numbers(sizes);
  add_table(std::as_bytes(std::span(planes)), parts.directory);
  add_table(std::as_bytes(std::span(sums)), parts.directory);
  add_table(Blob(12 * parts.mesh_count * parts.frames.size()), parts.directory);  // boxes
  size += parts.directory.size();
  ByteWriter out;
  for (const char c : kGeometryMagic) out.add(c);
  out.add(kGeometryFileVersion);
  out.add(std::uint32_t{0});
  out.add(static_cast<std::uint64_t>(kGeometryFileHead + parts.directory.size()));
  out.add(size);
  out.add(checksum(parts.directory));
  Blob file = std::move(out.bytes());
  append(parts.directory, file);
  for (const Blob& frame : parts.frames) append(frame, file);
  return file;
}

/// Place of a section in a stream of a frame.
struct Section {
  std::size_t size_at = 0, at = 0, stored = 0;
  bool by_zstd = false;
};

std::vector<Section> sections_of(Bytes frame) {
  std::vector<Section> out;
  std::size_t head = 0;
  while (head < frame.size() && frame.size() - head >= kSectionHeads) {
    std::size_t at = head + kSectionHeads;
    for (std::size_t s = 0; s < kSections; ++s) {
      std::uint32_t size;
      std::memcpy(&size, frame.data() + head + s * sizeof(size), sizeof(size));
      const std::size_t stored = size & ~kStoredByZstd;
      if (stored > frame.size() - at) return out;
      out.push_back({head + s * sizeof(size), at, stored, (size & kStoredByZstd) != 0});
      at += stored;
    }
    head = at;
  }
  return out;
}

/// Unpacks one section of a frame, changes it, and stores it uncompressed.
void change_section(Blob& frame, test::FixedRandom& random, const MutateBytes& mutate_bytes) {
  const std::vector<Section> sections = sections_of(frame);
  if (sections.empty()) return change_bytes(frame, mutate_bytes);
  const Section section = sections[random.below(static_cast<std::uint32_t>(sections.size()))];
  Blob changed = unpacked(Bytes(frame).subspan(section.at, section.stored), section.by_zstd);
  change_bytes(changed, mutate_bytes);
  const auto place = frame.begin() + static_cast<std::ptrdiff_t>(section.at);
  frame.insert(frame.erase(place, place + static_cast<std::ptrdiff_t>(section.stored)), changed.begin(), changed.end());
  const auto new_size = static_cast<std::uint32_t>(changed.size());
  std::memcpy(frame.data() + section.size_at, &new_size, sizeof(new_size));
}

}  // namespace

std::vector<std::byte> mutate_geometry(Bytes file, std::uint64_t seed, const MutateBytes& mutate_bytes) {
  test::FixedRandom random(seed);
  auto parts = take_apart(file);
  const std::uint32_t kind = random.below(12);
  if (!parts || kind == 0) {
    Blob out(file.begin(), file.end());
    change_bytes(out, mutate_bytes);
    return out;
  }
  const auto any_frame = [&]() -> Blob& {
    return parts->frames[random.below(static_cast<std::uint32_t>(parts->frames.size()))];
  };
  if (kind < 3) {
    change_bytes(parts->directory, mutate_bytes);
  } else if (kind < 5) {
    change_bytes(any_frame(), mutate_bytes);
  } else if (kind == 5) {
    const Blob copied = any_frame();
    any_frame() = copied;
  } else if (kind == 6) {
    parts->frames.resize(1 + random.below(8), parts->frames.back());
  } else {
    change_section(any_frame(), random, mutate_bytes);
  }
  return put_together(std::move(*parts));
}

}  // namespace sinew::fuzz
