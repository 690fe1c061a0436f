// SPDX-License-Identifier: MIT
#include "importer/file/sandboxed_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "importer/file/data_uri.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using Kind = FileFault::Kind;

/// A folder `asset` with files, beside a file that must stay out of reach.
class sandboxed_files : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("sinew-sandbox-" + std::to_string(::getpid()));
    fs::create_directories(root_ / "asset" / "sub");
    write(root_ / "secret.bin", "secret");
    write(root_ / "asset" / "a.bin", "abcd");
    write(root_ / "asset" / "sub" / "b.bin", "ef");
    write(root_ / "asset" / "Box With Spaces.bin", "spaces");
    write(root_ / "asset" / "\xC3\xA4.bin", "umlaut");
    write(root_ / "asset" / "50%25.bin", "percent");
  }
  void TearDown() override { fs::remove_all(root_); }

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  std::string read(std::string_view uri, std::uint64_t allowance = 1 << 20) {
    SandboxedFiles files(root_ / "asset", allowance);
    const auto bytes = files.read(uri);
    if (bytes) return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return bytes.error().kind == Kind::forbidden ? "<forbidden>" : bytes.error().kind == Kind::missing ? "<missing>" : "<too large>";
  }

  fs::path root_;
};

TEST_F(sandboxed_files, G63_percent_spaces_and_utf8_name_the_same_file) {
  EXPECT_EQ(read("a.bin"), "abcd");
  EXPECT_EQ(read("sub/../sub/b.bin"), "ef");
  EXPECT_EQ(read("Box%20With%20Spaces.bin"), "spaces");
  EXPECT_EQ(read("Box With Spaces.bin"), "spaces");
  EXPECT_EQ(read("%C3%A4.bin"), "umlaut");
  EXPECT_EQ(read("\xC3\xA4.bin"), "umlaut");
  EXPECT_EQ(read("50%2525.bin"), "percent") << "decoded once, not twice";
}

TEST_F(sandboxed_files, G64_nothing_leaves_the_folder) {
  for (const char* uri : {"../secret.bin", "sub/../../secret.bin", "%2e%2e/secret.bin", "..%2Fsecret.bin", "/etc/passwd", "%2Fetc%2Fpasswd",
                          "file:///etc/passwd", "http://example.com/a.bin", "C:/a.bin", "\\\\server\\a.bin", "", "a.bin%00", "%zz.bin", "a%2"})
    EXPECT_EQ(read(uri), "<forbidden>") << uri;
}

TEST_F(sandboxed_files, G64_links_that_lead_out_are_refused) {
  fs::create_symlink(root_ / "secret.bin", root_ / "asset" / "link.bin");
  fs::create_directory_symlink(root_, root_ / "asset" / "up");
  fs::create_symlink("a.bin", root_ / "asset" / "inside.bin");
  EXPECT_EQ(read("link.bin"), "<forbidden>");
  EXPECT_EQ(read("up/secret.bin"), "<forbidden>");
  EXPECT_EQ(read("inside.bin"), "abcd");
}

TEST_F(sandboxed_files, only_regular_files_are_opened) {
  EXPECT_EQ(read("sub"), "<missing>");
  EXPECT_EQ(read("absent.bin"), "<missing>");
}

TEST_F(sandboxed_files, G67_the_allowance_is_for_all_files_together) {
  EXPECT_EQ(read("a.bin", 3), "<too large>");
  SandboxedFiles files(root_ / "asset", 5);
  EXPECT_TRUE(files.read("a.bin"));
  EXPECT_FALSE(files.read("sub/b.bin"));
  EXPECT_EQ(files.bytes_read(), 4u);
}

TEST_F(sandboxed_files, a_document_in_memory_reads_no_files) {
  SandboxedFiles files(std::nullopt, 100);
  EXPECT_EQ(files.read("a.bin").error().kind, Kind::forbidden);
}

TEST_F(sandboxed_files, G64_a_uri_out_of_the_folder_fails_the_import_and_names_it) {
  write(root_ / "asset" / "x.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":6,"uri":"../secret.bin"}]})");
  EXPECT_EQ(outcome(import_gltf(root_ / "asset" / "x.gltf")), "uri-forbidden at /buffers/0/uri");
}

TEST(data_uri, G65_decodes_any_media_type_with_and_without_padding) {
  const auto text = [](std::string_view uri) {
    const auto data = decode_data_uri(uri);
    return data ? data->mime_type + "|" + std::string(reinterpret_cast<const char*>(data->bytes.data()), data->bytes.size()) : "<none>";
  };
  EXPECT_EQ(text("data:application/octet-stream;base64,YWJj"), "application/octet-stream|abc");
  EXPECT_EQ(text("data:application/gltf-buffer;base64,YWI="), "application/gltf-buffer|ab");
  EXPECT_EQ(text("data:;base64,YQ"), "|a");
  EXPECT_EQ(text("data:image/webp;base64,YQ=="), "image/webp|a");
  EXPECT_EQ(text("data:image/png;name=x;base64,"), "image/png|");
  EXPECT_EQ(text("data:image/png;base64,Y"), "<none>");
  EXPECT_EQ(text("data:image/png;base64,Y*=="), "<none>");
  EXPECT_EQ(text("data:image/png,plain"), "<none>");
  EXPECT_EQ(text("data:nothing"), "<none>");
}

TEST(data_uri, round_trips_all_bytes) {
  std::vector<std::byte> bytes;
  for (int i = 0; i < 256; ++i) {
    bytes.push_back(static_cast<std::byte>(i));
    const auto data = decode_data_uri("data:;base64," + base64(bytes));
    ASSERT_TRUE(data);
    EXPECT_EQ(data->bytes, bytes);
  }
}

}  // namespace
}  // namespace sinew::test
