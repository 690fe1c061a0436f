// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/viewer/cache_files.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

std::string fault_of(const std::string& path) {
  const auto file = open_cache_file(path);
  EXPECT_FALSE(file.has_value());
  return file ? std::string() : file.error();
}

/// The error for an existing file that cannot be opened, because the process has no free descriptors.
std::string fault_without_files(const std::string& path) {
  rlimit before{};
  EXPECT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  std::string fault = fault_of(path);
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  return fault;
}

TEST(cache_file, is_read_up_to_its_frames) {
  const Bytes bytes = flag_bytes();
  const WrittenFile written("flag.sgeo", bytes);
  const auto file = open_cache_file(written.path());
  ASSERT_TRUE(file) << file.error();
  EXPECT_EQ(file->cache.frame_count(), 20u);
  EXPECT_EQ(file->cache.file_bytes(), bytes.size());
  EXPECT_EQ(file->path, written.path());
  EXPECT_THAT(file->name, HasSubstr("flag.sgeo"));
  EXPECT_THAT(file->name, testing::Not(HasSubstr("/")));
}

TEST(cache_file, is_told_by_its_name_or_by_its_first_bytes) {
  const WrittenFile other_name("flag.bin", flag_bytes(2)), other_bytes("a.glb", Bytes(100)), empty("b.sgeo", {});
  EXPECT_TRUE(is_cache_file(other_name.path()));
  EXPECT_TRUE(is_cache_file(empty.path()));
  EXPECT_FALSE(is_cache_file(other_bytes.path()));
  EXPECT_FALSE(is_cache_file("/nothing/here.glb"));
  EXPECT_TRUE(is_cache_file("/nothing/here.sgeo"));
}

TEST(cache_file, refuses_what_it_cannot_read_in_one_sentence_with_file_and_rule) {
  EXPECT_THAT(fault_of("/nothing/here.sgeo"),
              testing::AllOf(HasSubstr("/nothing/here.sgeo: "), HasSubstr("o such file")));
  EXPECT_THAT(fault_of("/tmp"), HasSubstr("/tmp: "));
  const WrittenFile empty("empty.sgeo", {});
  EXPECT_THAT(fault_of(empty.path()), HasSubstr("empty.sgeo: byte 0: cache-"));

  Bytes bytes = flag_bytes(2);
  const auto with = [&](std::size_t at, std::byte value) {
    Bytes changed = bytes;
    changed[at] = value;
    const WrittenFile file("changed.sgeo", changed);
    return fault_of(file.path());
  };
  EXPECT_THAT(with(0, std::byte{'x'}), HasSubstr("cache-magic"));
  EXPECT_THAT(with(8, std::byte{99}), HasSubstr("cache-version"));
  EXPECT_THAT(with(60, bytes[60] ^ std::byte{1}), HasSubstr("cache-checksum"));
  bytes.resize(bytes.size() / 2);
  const WrittenFile cut("cut.sgeo", bytes);
  EXPECT_THAT(fault_of(cut.path()), HasSubstr("cache-size"));
}

TEST(cache_file, says_what_the_system_says_of_a_file_that_does_not_open) {
  EXPECT_THAT(fault_without_files(WrittenFile("flag.sgeo", flag_bytes(2)).path()),
              HasSubstr("flag.sgeo: Too many open files"));
}

}  // namespace
}  // namespace sinew::viewer
