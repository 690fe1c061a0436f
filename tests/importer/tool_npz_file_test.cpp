// SPDX-License-Identifier: MIT
// Arrays that are written side by side while poses are sampled: the file is whole, and memory does not grow with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "importer/tool/poses/npz_file.h"
#include "importer/tool/poses/zip_records.h"
#include "tests/importer/tool_model.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;

std::string unpacked(const std::string& file) {
  std::string out;
  std::array<char, 4096> block;
  gzFile stream = gzopen(file.c_str(), "rb");
  for (int count = 0; (count = gzread(stream, block.data(), block.size())) > 0;)
    out.append(block.data(), static_cast<std::size_t>(count));
  gzclose(stream);
  return out;
}

/// Python zipfile's listing of a zip, "name size header_offset", and the content of short entries. It finds no wrong
/// checksum, and does not read files that have holes.
std::string listed_by_python(const ToolModelFile& folder, const std::string& zip, bool has_holes = false) {
  const std::string script = folder.beside("list.py"), out = folder.beside("listed");
  std::ofstream(script) << "import sys, zipfile\n"
                           "with zipfile.ZipFile(sys.argv[1]) as z:\n"
                           "  for f in z.infolist():\n"
                           "    print(f.filename, f.file_size, f.header_offset,"
                           " z.read(f).hex() if f.file_size < 100 else '')\n"
                           "  assert sys.argv[2] == 'long' or not z.testzip()\n";
  EXPECT_EQ(
      std::system(("python3 " + script + " " + zip + (has_holes ? " long" : " -") + " >" + out + " 2>&1").c_str()), 0)
      << text_of_file(out);
  return text_of_file(out);
}

void put_at(std::ofstream& out, std::uint64_t place, const std::string& bytes) {
  out.seekp(static_cast<std::streamoff>(place));
  out << bytes;
}

TEST(npz_file, arrays_grow_side_by_side_in_any_steps) {
  const ToolModelFile folder;
  const std::string file = folder.beside("a.npz");
  {
    tool::StreamedFile out(file);
    tool::NpzFile zip(out);
    const std::size_t a = zip.add({"a", "<i4", {2, 3}});
    zip.append(a, "0123456789ab");
    const std::size_t b = zip.add({"b", "<U2", {1}});
    zip.append(b, "second");
    zip.append(a, "cdefghijklmn");
    zip.append(b, "!!");
    zip.add({"none", "<f8", {0, 4}});
    zip.finish();
    ASSERT_TRUE(out.finish());
  }
  const std::string bytes = text_of_file(file);
  EXPECT_THAT(bytes, HasSubstr("\n0123456789abcdefghijklmnPK"));
  EXPECT_THAT(bytes, HasSubstr("\nsecond!!PK"));
  const std::string listed = listed_by_python(folder, file);
  EXPECT_THAT(listed, testing::StartsWith("a.npy 152 0 "));
  EXPECT_THAT(listed, HasSubstr("\nb.npy 136 187 "));
  EXPECT_THAT(listed, HasSubstr("\nnone.npy 128 358 "));
}

TEST(npz_file, an_array_takes_what_its_shape_says) {
  const ToolModelFile folder;
  tool::StreamedFile out(folder.beside("a.npz"));
  tool::NpzFile zip(out);
  const std::size_t a = zip.add({"a", "<f4", {2}});
  zip.append(a, "0123");
  EXPECT_DEATH(zip.append(a, "45678"), "entry.size");
  EXPECT_DEATH(zip.finish(), "entry.size");
}

/// The first of two files has a hole of 5 GiB, which takes no room on the disk.
TEST(npz_file, files_beyond_4_GiB_have_the_long_fields) {
  const ToolModelFile folder;
  const std::string file = folder.beside("long.zip");
  const std::uint64_t size = std::uint64_t{5} << 30;
  const std::string first = tool::zip_local_head("first", 0, size);
  const std::uint64_t second_at = first.size() + size;
  const auto checksum = static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>("short"), 5));
  const std::string second = tool::zip_local_head("second", checksum, 5) + "short";
  const std::string directory =
      tool::zip_directory_entry("first", 0, size, 0) + tool::zip_directory_entry("second", checksum, 5, second_at);
  const std::uint64_t directory_at = second_at + second.size();
  {
    std::ofstream out(file, std::ios::binary);
    put_at(out, 0, first);
    put_at(out, second_at, second);
    put_at(out, directory_at, directory + tool::zip_ending(2, directory_at, directory.size()));
  }
  EXPECT_EQ(listed_by_python(folder, file, true),
            "first 5368709120 0 \nsecond 5 " + std::to_string(second_at) + " 73686f7274\n");
}

TEST(npz_file, more_files_than_a_short_directory_counts) {
  const ToolModelFile folder;
  const std::string file = folder.beside("many.zip");
  constexpr std::uint64_t kCount = 70'000;
  {
    std::ofstream out(file, std::ios::binary);
    const std::string one = tool::zip_local_head("x", 0, 0);
    std::string directory;
    for (std::uint64_t i = 0; i < kCount; ++i) {
      out << one;
      directory += tool::zip_directory_entry("x", 0, 0, i * one.size());
    }
    out << directory << tool::zip_ending(kCount, kCount * one.size(), directory.size());
  }
  const std::string listed = listed_by_python(folder, file);
  EXPECT_EQ(std::count(listed.begin(), listed.end(), '\n'), static_cast<std::ptrdiff_t>(kCount));
  const std::string count_in_8_bytes("\x70\x11\x01\0\0\0\0\0", 8);
  EXPECT_THAT(tool::zip_ending(kCount, 0, 0), HasSubstr(count_in_8_bytes + count_in_8_bytes)) << "Python does not look";
  EXPECT_THAT(tool::zip_ending(2, 0, 0), testing::SizeIs(22)) << "no long fields without need";
}

TEST(npz_file, stdout_and_compressed_files_hold_the_same_bytes) {
  const ToolModelFile model;
  for (const std::string format : {"npz", "npy"}) {
    const auto sampled = [&](const std::string& out) {
      const CommandOutcome outcome = run_tool({"sample", model.path(), "--format", format, "-o", out});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      return outcome.out;
    };
    sampled(model.beside("plain"));
    sampled(model.beside("packed.gz"));
    const std::string bytes = text_of_file(model.beside("plain"));
    ASSERT_GT(bytes.size(), 1000u);
    EXPECT_TRUE(sampled("-") == bytes) << format;
    EXPECT_TRUE(text_of_file(model.beside("packed.gz")) != bytes);
    EXPECT_TRUE(unpacked(model.beside("packed.gz")) == bytes) << format;
  }
}

TEST(npz_file, memory_does_not_grow_with_the_number_of_poses) {
  const ToolModelFile model;
  for (const std::string format : {"npz", "npy"}) {
    const std::string out = model.beside("poses." + format);
    const PeakMemory memory;
    const CommandOutcome outcome = run_tool({"sample", model.path(), "--fps", "15000", "-o", out});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(out), (format == "npz" ? 4 : 1) * tool::NpzFile::kHeld) << format;
    EXPECT_LT(memory.bytes(), 2 * tool::NpzFile::kHeld) << format;
    if (format == "npy") continue;
    EXPECT_THAT(listed_by_python(model, out), HasSubstr("world.npy")) << "checksums of many steps are right";
  }
}

}  // namespace
}  // namespace sinew::test
