// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_reader.h"

#include <gtest/gtest.h>

#include <thread>

#include "runtime/geometry_cache/geometry_decoder.h"
#include "tests/viewer/cache_files.h"

namespace sinew::viewer {
namespace {

using Reads = CacheReader::Reads;

/// Decodes a frame; waits for its bytes if they are read on another thread.
GeometryStatus decode(GeometryDecoder& decoder, std::uint32_t frame, FrameWindow& window) {
  for (;; std::this_thread::yield()) {
    window.prefetch(decoder.next_for(frame));
    const GeometryStatus status = decoder.decode(frame, window);
    if (status != GeometryStatus::not_loaded) return status;
  }
}

TEST(cache_reader, every_way_of_reading_gives_the_bytes_of_the_file) {
  const Bytes bytes = flag_bytes();
  const WrittenFile written("read.sgeo", bytes);
  const auto on_disk = open_cache_file(written.path()), in_memory = open_cache_bytes("flag", bytes);
  ASSERT_TRUE(on_disk && in_memory);
  for (const CacheFile* file : {&*on_disk, &*in_memory})
    for (const Reads reads : {Reads::blocking, Reads::on_thread}) {
      GeometryDecoder decoder(file->cache), expected(in_memory->cache);
      MappedFrames source{in_memory->cache, bytes};
      CacheReader reader(*file, reads, 12);
      FrameWindow window(file->cache, reader.reader(), 12);
      std::vector<glm::vec3> points(file->cache.meshes()[0].vertex_count), truth(points.size());
      for (const std::uint32_t frame : {0u, 1u, 2u, 19u, 5u, 4u, 3u, 12u}) {
        ASSERT_EQ(decode(decoder, frame, window), GeometryStatus::ok) << frame;
        decoder.write_vertices(0, points);
        ASSERT_EQ(expected.decode(frame, source), GeometryStatus::ok);
        expected.write_vertices(0, truth);
        ASSERT_EQ(points, truth) << frame;
      }
      EXPECT_GT(reader.bytes_read(), 0u);
      EXPECT_LE(reader.bytes_read(), window.bytes_requested());
      reader.stop();
      EXPECT_EQ(window.pending_reads(), 0u);
    }
}

TEST(cache_reader, reads_that_fail_are_late_frames) {
  Bytes bytes = flag_bytes();
  const auto whole = open_cache_bytes("flag", bytes);
  ASSERT_TRUE(whole);
  const WrittenFile cut(
      "cut.sgeo", Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(whole->cache.frames()[3].offset)));
  for (const std::string& path : {cut.path(), std::string("/nothing/here.sgeo")}) {
    const CacheFile file{"cut", path, {}, whole->cache};
    CacheReader reader(file, Reads::blocking, 4);
    FrameWindow window(file.cache, reader.reader(), 4);
    GeometryDecoder decoder(file.cache);
    EXPECT_EQ(decoder.decode(5, window), GeometryStatus::not_loaded);
    EXPECT_EQ(decoder.frame(), path == cut.path() ? 2u : kNone);
  }
}

TEST(cache_reader, ends_while_reads_wait) {
  const Bytes bytes = flag_bytes();
  const auto file = open_cache_bytes("flag", bytes);
  for (int i = 0; i < 50; ++i) {
    CacheReader reader(*file, Reads::on_thread, 20);
    FrameWindow window(file->cache, reader.reader(), 20);
    window.prefetch(0);
    reader.stop();
    EXPECT_EQ(window.pending_reads(), 0u);
    EXPECT_EQ(window.frames_loaded(), 20u) << "what was asked for before is read";
    window.prefetch(0);
  }
}

}  // namespace
}  // namespace sinew::viewer
