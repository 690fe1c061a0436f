// SPDX-License-Identifier: MIT
// The calls of the operating system, on each system that runs this program.
#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <string>
#include <string_view>

#include "importer/platform/files.h"
#include "importer/platform/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// A folder whose name no code page of one byte holds.
class platform_files : public testing::Test {
 protected:
  platform_files()
      : folder_(fs::temp_directory_path() / ("sinew-" + std::to_string(platform::process_number())) / kFolder) {
    fs::create_directories(folder_);
  }
  ~platform_files() override { fs::remove_all(folder_.parent_path()); }

  fs::path file(const char* name) const { return folder_ / name; }

  static std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

  static bool write(const fs::path& path, std::string_view text) {
    const int descriptor = platform::create_new(path);
    const bool done =
        descriptor >= 0 && platform::write_all(descriptor, bytes(text)) && platform::flush_to_disk(descriptor);
    platform::close(descriptor);
    return done;
  }

  static std::string read(const fs::path& path) {
    const int descriptor = platform::open_to_read(path);
    if (descriptor < 0) return "not opened";
    std::string text(platform::regular_size(descriptor).value_or(0), '\0');
    if (!platform::read_all(descriptor, std::as_writable_bytes(std::span(text)))) text = "not read";
    platform::close(descriptor);
    return text;
  }

 private:
  static constexpr const char* kFolder = "Fu\xc3\x9fg\xc3\xa4nger \xe8\xb5\xb0";
  fs::path folder_;
};

TEST_F(platform_files, hold_the_bytes_that_were_written) {
  const std::string text("a\nb\r\nc\x1a\0d", 9);  // ends of lines and of files that a text mode would change
  ASSERT_TRUE(write(file("new"), text));
  EXPECT_EQ(read(file("new")), text);
  EXPECT_EQ(fs::file_size(file("new")), text.size());
  EXPECT_LT(platform::create_new(file("new")), 0) << "it is there already";
  EXPECT_EQ(errno, EEXIST);
  EXPECT_LT(platform::open_to_read(file("none")), 0);
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(platform_files, replace_others_at_once) {
  ASSERT_TRUE(write(file("old"), "old"));
  const fs::path beside = platform::temporary_beside(file("old"));
  EXPECT_EQ(beside.parent_path(), file("old").parent_path());
  ASSERT_TRUE(write(beside, "new"));
  EXPECT_TRUE(platform::rename_over(beside, file("old")));
  EXPECT_EQ(read(file("old")), "new");
  EXPECT_FALSE(fs::exists(beside));
  EXPECT_FALSE(platform::rename_over(file("none"), file("old")));
  EXPECT_NE(errno, 0);
  EXPECT_TRUE(platform::remove(file("old")));
  EXPECT_FALSE(platform::remove(file("old")));
}

TEST_F(platform_files, have_one_identity_by_all_names) {
  ASSERT_TRUE(write(file("one"), "1"));
  ASSERT_TRUE(write(file("two"), "2"));
  const auto one = platform::identity_at(file("one")), two = platform::identity_at(file("two"));
  ASSERT_TRUE(one && two);
  EXPECT_NE(*one, *two);
  EXPECT_EQ(platform::identity_at(file("one").parent_path() / "." / "one"), one);
  const int descriptor = platform::open_to_read(file("one"));
  EXPECT_EQ(platform::identity_of(descriptor), *one);
  platform::close(descriptor);
  EXPECT_FALSE(platform::identity_at(file("none")));
}

TEST_F(platform_files, without_a_name_take_bytes_at_any_place) {
  const int descriptor = platform::open_temporary();
  ASSERT_GE(descriptor, 0);
  EXPECT_TRUE(platform::seek(descriptor, 3) && platform::write_all(descriptor, bytes("def")));
  EXPECT_TRUE(platform::seek(descriptor, 0) && platform::write_all(descriptor, bytes("abc")));
  EXPECT_TRUE(platform::seek(descriptor, 0));
  const int second = platform::duplicate(descriptor);
  std::array<std::byte, 6> text;
  EXPECT_TRUE(platform::read_all(second, text));
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(text.data()), text.size()), "abcdef");
  EXPECT_EQ(platform::read_some(second, text), 0u) << "both have one place, which is the end";
  EXPECT_FALSE(platform::read_all(second, text));
  platform::close(second);
  platform::close(descriptor);
}

TEST_F(platform_files, are_told_from_folders) {
  const int folder = platform::open_to_read(file("x").parent_path());  // Windows opens no folder as a file
  if (folder >= 0) {
    EXPECT_FALSE(platform::regular_size(folder));
    platform::close(folder);
  }
  ASSERT_TRUE(write(file("x"), "12345"));
  const int descriptor = platform::open_to_read(file("x"));
  EXPECT_EQ(platform::regular_size(descriptor), 5u);
  EXPECT_FALSE(platform::is_terminal(descriptor));
  platform::close(descriptor);
}

/// This program, which lists the tests of other suites than this one.
tl::expected<std::string, std::string> list_of_tests(const std::string& filter) {
  const fs::path program = platform::program_folder() / platform::program_file("sinew-test-platform");
  return platform::output_of(program, {"--gtest_list_tests", "--gtest_filter=" + filter});
}

TEST(platform_program, gets_the_output_of_another) {
  const auto listed = list_of_tests("platform_program.*");
  ASSERT_TRUE(listed) << listed.error();
  EXPECT_NE(listed->find("gets_the_output_of_another"), std::string::npos) << *listed;
  EXPECT_EQ(listed->find("have_one_identity"), std::string::npos) << "its words arrive";
  EXPECT_FALSE(platform::output_of(platform::program_folder() / "no such program", {}));
}

TEST(platform_program, tells_that_another_has_failed) {
  const fs::path program = platform::program_folder() / platform::program_file("sinew-test-platform");
  const auto failed =
      platform::output_of(program, {"--gtest_filter=platform_failure.*", "--gtest_also_run_disabled_tests"});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error(), platform::program_file("sinew-test-platform") + " ended with status 1");
}

TEST(platform_failure, DISABLED_fails_for_the_test_above) { FAIL(); }

TEST(platform_program, knows_its_machine) {
  EXPECT_FALSE(platform::system_name().empty());
  EXPECT_FALSE(platform::processor_name().empty());
  EXPECT_FALSE(platform::load_average().empty());
  EXPECT_EQ(platform::environment_variable("SINEW_NO_SUCH_VARIABLE"), "");
  EXPECT_NE(platform::environment_variable("PATH"), "");
}

}  // namespace
}  // namespace sinew::test
