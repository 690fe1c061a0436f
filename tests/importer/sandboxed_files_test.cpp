// SPDX-License-Identifier: MIT
#include "importer/file/sandboxed_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <deque>
#include <fstream>
#include <vector>

#include "importer/file/data_uri.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using Kind = FileFault::Kind;

/// A folder `asset` with files; the files beside it must stay out of reach.
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
    write(root_ / "asset" / "j\x0f.bin", "digits");
  }
  void TearDown() override { fs::remove_all(root_); }

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  std::string read(std::string_view uri, std::uint64_t allowance = 1 << 20) {
    SandboxedFiles files(root_ / "asset", allowance);
    const auto bytes = files.read(uri, storage_);
    if (bytes) return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return bytes.error().kind == Kind::forbidden ? "<forbidden>"
           : bytes.error().kind == Kind::missing ? "<missing>"
                                                 : "<too large>";
  }

  fs::path root_;
  std::deque<std::vector<std::byte>> storage_;
};

TEST_F(sandboxed_files, G63_percent_spaces_and_utf8_name_the_same_file) {
  EXPECT_EQ(read("a.bin"), "abcd");
  EXPECT_EQ(read("sub/../sub/b.bin"), "ef");
  EXPECT_EQ(read("Box%20With%20Spaces.bin"), "spaces");
  EXPECT_EQ(read("Box With Spaces.bin"), "spaces");
  EXPECT_EQ(read("%C3%A4.bin"), "umlaut");
  EXPECT_EQ(read("\xC3\xA4.bin"), "umlaut");
  for (const char* uri : {"%6a%0f.bin", "%6A%0F.bin"}) EXPECT_EQ(read(uri), "digits") << "of either case: " << uri;
  EXPECT_EQ(read("50%2525.bin"), "percent") << "decoded once, not twice";
}

TEST(percent_decode, every_byte_has_two_digits_of_either_case_and_nothing_else_is_one) {
  const std::string digits = "0123456789abcdef", others = "0123456789ABCDEF";
  for (unsigned byte = 0; byte < 256; ++byte) {
    const std::string expected(1, static_cast<char>(byte)), character(1, static_cast<char>(byte));
    for (const std::string& d : {digits, others})
      EXPECT_EQ(percent_decode(std::string{'%', d[byte / 16], d[byte % 16]}), expected) << byte;
    const bool is_digit = (digits + others).find(character) != std::string::npos;
    EXPECT_EQ(percent_decode("%" + character + "0").has_value(), is_digit) << byte;
    EXPECT_EQ(percent_decode("%0" + character).has_value(), is_digit) << byte;
  }
  EXPECT_EQ(percent_decode("a%20b%"), std::nullopt);
  EXPECT_EQ(percent_decode("a%20b%2"), std::nullopt);
  EXPECT_EQ(percent_decode("a%20b%21"), "a b!");
}

/// RFC 3986: a scheme is a letter, then letters, digits, "+", "-" and ".".
TEST_F(sandboxed_files, G64_a_scheme_is_what_the_standard_says) {
  for (const char* uri : {"a:b", "Z:b", "a9:b", "a+:b", "a-:b", "a.:b", "z1+-.Z:", "a%3Ab"})
    EXPECT_EQ(read(uri), "<forbidden>") << uri;
  for (const char* uri : {":b", "1a:b", "+a:b", "a_b:c", "a b:c", "sub/a:b", "a~:b"})
    EXPECT_EQ(read(uri), "<missing>") << uri;
}

TEST_F(sandboxed_files, G64_T9_nothing_leaves_the_folder) {
  for (const char* uri : {"../secret.bin", "sub/../../secret.bin", "%2e%2e/secret.bin", "..%2Fsecret.bin",
                          "/etc/passwd", "%2Fetc%2Fpasswd", "file:///etc/passwd", "http://example.com/a.bin",
                          "C:/a.bin", "\\\\server\\a.bin", "", "a.bin%00", "%zz.bin", "a%2"})
    EXPECT_EQ(read(uri), "<forbidden>") << uri;
}

TEST_F(sandboxed_files, a_refusal_says_what_is_wrong_with_the_uri) {
  const auto detail_of = [&](const char* uri) {
    const auto bytes = SandboxedFiles(root_ / "asset", 1 << 20).read(uri, storage_);
    return bytes ? "read" : bytes.error().detail;
  };
  EXPECT_EQ(detail_of("sub\\b.bin"),
            "\"sub\\b.bin\" cannot be opened: No such file or directory; a URI has / between folders, not \\");
  EXPECT_EQ(detail_of("sub%5Cb.bin"), detail_of("sub\\b.bin"));
  EXPECT_EQ(detail_of("%E4.bin"),
            "\"\xE4.bin\" cannot be opened: No such file or directory; its bytes are not UTF-8, as those of a URI are");
  EXPECT_EQ(detail_of("c.bin"), "\"c.bin\" cannot be opened: No such file or directory");
  EXPECT_EQ(detail_of("C:\\a.bin").substr(0, 22), "the URI names the driv");
  EXPECT_EQ(detail_of("file:///a.bin"),
            "the URI has the scheme \"file:\"; only data: and paths from the folder of this file are read");
  EXPECT_EQ(detail_of("/a.bin"), "the URI is not relative; name the file by its path from the folder of this file");
}

TEST_F(sandboxed_files, G64_links_that_lead_out_are_refused) {
  fs::create_symlink(root_ / "secret.bin", root_ / "asset" / "link.bin");
  fs::create_directory_symlink(root_, root_ / "asset" / "up");
  fs::create_symlink("a.bin", root_ / "asset" / "inside.bin");
  EXPECT_EQ(read("link.bin"), "<forbidden>");
  EXPECT_EQ(read("up/secret.bin"), "<forbidden>");
  EXPECT_EQ(read("inside.bin"), "abcd");
}

TEST_F(sandboxed_files, T9_what_a_shell_would_run_is_a_name_like_others) {
  const fs::path harm = root_ / "asset" / "harm.bin";
  for (const std::string name :
       {"$(touch harm.bin)", "`touch harm.bin`", "a.bin; touch harm.bin", "a.bin|touch harm.bin",
        "a.bin && touch harm.bin", "$HOME", "~", "*.bin", "a.b?n", "{a,b}.bin", "'a.bin'"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(read(name), "<missing>") << "nothing is expanded or matched";
    write(root_ / "asset" / name, "named");
    EXPECT_EQ(read(name), "named");
    const Json document = {{"asset", {{"version", "2.0"}}}, {"buffers", {{{"byteLength", 5}, {"uri", name}}}}};
    write(root_ / "asset" / "x.gltf", document.dump());
    const auto file = import_gltf(root_ / "asset" / "x.gltf");
    EXPECT_EQ(outcome(file), "ok");
    EXPECT_TRUE(file && file->warnings.empty());
    EXPECT_FALSE(fs::exists(harm) || fs::exists("harm.bin"));
  }
}

TEST_F(sandboxed_files, G64_T9_pipes_and_devices_are_not_opened_and_do_not_block) {
  ASSERT_EQ(::mkfifo((root_ / "asset" / "pipe.bin").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", root_ / "asset" / "zero.bin");
  EXPECT_EQ(read("pipe.bin"), "<missing>");
  EXPECT_EQ(read("zero.bin"), "<forbidden>");
  EXPECT_EQ(outcome(import_gltf(root_ / "asset" / "pipe.bin")), "file-unreadable at ");
  EXPECT_EQ(outcome(import_gltf(fs::path("/dev/zero"))), "file-unreadable at ");
}

TEST_F(sandboxed_files, G64_a_link_to_the_whole_folder_is_its_folder) {
  fs::create_directory_symlink(root_ / "asset", root_ / "elsewhere");
  SandboxedFiles files(root_ / "elsewhere", 100);
  EXPECT_TRUE(files.read("a.bin", storage_));
  EXPECT_FALSE(files.read("../secret.bin", storage_));
}

TEST_F(sandboxed_files, G63_json_escapes_spaces_and_percent_name_the_same_buffer) {
  write(root_ / "asset" / "x.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":6,"uri":"Box With Spaces.bin"},)"
        R"({"byteLength":6,"uri":"Box%20With%20Spaces.bin"},{"byteLength":6,"uri":"Box\u0020With\u0020Spaces.bin"}]})");
  const auto result = import_gltf(root_ / "asset" / "x.gltf");
  EXPECT_EQ(outcome(result), "ok");
  EXPECT_TRUE(result && result->warnings.empty());
}

TEST_F(sandboxed_files, G64_images_stay_in_the_folder_too) {
  write(root_ / "asset" / "x.gltf",
        R"({"asset":{"version":"2.0"},"images":[{"uri":"../secret.bin"},{"uri":"http://127.0.0.1/a.png"}]})");
  const auto result = import_gltf(root_ / "asset" / "x.gltf");
  EXPECT_TRUE(warns(result, "uri-forbidden", "/images/0/uri") && warns(result, "uri-forbidden", "/images/1/uri"));
  ASSERT_EQ(result->warnings.size(), 2u) << "each said once";
  EXPECT_FALSE(result->scene.images[0].missing_reason.empty());
}

TEST_F(sandboxed_files, G67_a_buffer_past_the_allowance_names_itself) {
  write(root_ / "asset" / "x.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"a.bin"}]})");
  ImportOptions options;
  options.max_file_bytes = fs::file_size(root_ / "asset" / "x.gltf") + 3;
  EXPECT_EQ(outcome(import_gltf(root_ / "asset" / "x.gltf", options)), "file-too-large at /buffers/0/uri");
}

TEST_F(sandboxed_files, only_regular_files_are_opened) {
  EXPECT_EQ(read("sub"), "<missing>");
  EXPECT_EQ(read("absent.bin"), "<missing>");
}

TEST_F(sandboxed_files, G67_the_allowance_is_for_all_files_together) {
  EXPECT_EQ(read("a.bin", 3), "<too large>");
  SandboxedFiles files(root_ / "asset", 5);
  EXPECT_TRUE(files.read("a.bin", storage_));
  EXPECT_FALSE(files.read("sub/b.bin", storage_));
  EXPECT_EQ(files.bytes_read(), 4u);
}

TEST_F(sandboxed_files, a_document_in_memory_reads_no_files) {
  SandboxedFiles files(std::nullopt, 100);
  EXPECT_EQ(files.read("a.bin", storage_).error().kind, Kind::forbidden);
}

TEST_F(sandboxed_files, G64_a_uri_out_of_the_folder_fails_the_import_and_names_it) {
  write(root_ / "asset" / "x.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":6,"uri":"../secret.bin"}]})");
  EXPECT_EQ(outcome(import_gltf(root_ / "asset" / "x.gltf")), "uri-forbidden at /buffers/0/uri");
}

TEST(data_uri, G65_decodes_any_media_type_with_and_without_padding) {
  const auto text = [](std::string_view uri) {
    const auto data = decode_data_uri(uri);
    return data ? data->mime_type + "|" +
                      std::string(reinterpret_cast<const char*>(data->bytes.data()), data->bytes.size())
                : "<none>";
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
