// SPDX-License-Identifier: MIT
// Files that are not glTF: each is named for what it is, with the next step.
#include "importer/file/foreign_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

using namespace std::string_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string named(const std::string& file) { return describe_foreign_file(bytes_of(file)).value_or("may be glTF"); }

TEST(foreign_file, archives_are_named_with_the_way_to_unpack_them) {
  EXPECT_THAT(named("\x1f\x8b\x08"s), AllOf(StartsWith("gzip data; "), HasSubstr("gunzip")));
  EXPECT_THAT(named("PK\3\4"s + std::string(22, '\0') + "\x09\0\0\0model.glb"s),
              AllOf(StartsWith("a ZIP archive; "), HasSubstr("unpack")));
  EXPECT_THAT(named("PK\3\4"s + std::string(22, '\0') + "\x0a\0\0\0model.usdc"s), StartsWith("a USDZ model; "));
  EXPECT_THAT(named("PK\3\4"s + std::string(22, '\0') + "\x0a\0\0\0joints.npy"s), StartsWith("NumPy arrays"));
  EXPECT_THAT(named("PK\3\4"), StartsWith("a ZIP archive; ")) << "cut off before the name of its first entry";
  EXPECT_THAT(named("\x28\xb5\x2f\xfd"), HasSubstr("zstd"));
  EXPECT_THAT(named(std::string(257, 'a') + "ustar"), StartsWith("a tar archive; "));
}

TEST(foreign_file, text_in_two_or_four_bytes_a_character_is_to_be_saved_as_utf8) {
  for (const std::string& text : {"\xff\xfe{\0"s, "\xfe\xff\0{"s, "{\0\"\0"s, "\0{\0\""s})
    EXPECT_EQ(named(text), "text in UTF-16; save it as UTF-8");
  for (const std::string& text :
       {"\xff\xfe\0\0{\0\0\0"s, "\0\0\xfe\xff\0\0\0{"s, "{\0\0\0\"\0\0\0"s, "\0\0\0{\0\0\0\""s})
    EXPECT_EQ(named(text), "text in UTF-32; save it as UTF-8");
}

TEST(foreign_file, failed_downloads_and_pointers_are_to_be_fetched_again) {
  for (const char* page :
       {"<!DOCTYPE html><html>", "\xEF\xBB\xBF\n <HTML>", "<?xml version=\"1.0\"?><html xmlns=\"\">"})
    EXPECT_THAT(named(page), AllOf(StartsWith("a web page (HTML)"), HasSubstr("download"))) << page;
  EXPECT_THAT(named("<?xml version=\"1.0\"?><Error><Code>NoSuchKey</Code>"), StartsWith("XML, as servers send"));
  EXPECT_THAT(named("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 3\n"), HasSubstr("git lfs pull"));
  EXPECT_THAT(named("/annex/objects/SHA256E-s3--00.glb\n"), HasSubstr("git annex get"));
  EXPECT_THAT(named("404: Not Found"), AllOf(HasSubstr("\"404: Not Found\""), HasSubstr("not JSON")));
  EXPECT_THAT(named(""), StartsWith("empty; "));
  EXPECT_THAT(named(" \n\t"), StartsWith("blank"));
  EXPECT_THAT(named(std::string(100, '\0')), StartsWith("nothing but zero bytes"));
}

TEST(foreign_file, other_models_are_named_with_the_way_to_gltf) {
  EXPECT_THAT(named("Kaydara FBX Binary  \0\x1a\0"s), AllOf(StartsWith("FBX; "), HasSubstr("sinew import")));
  EXPECT_THAT(named("; FBX 7.4.0 project file"), StartsWith("FBX (as text)"));
  EXPECT_THAT(named("BLENDER-v300"), AllOf(StartsWith("a Blender file"), HasSubstr("export glTF 2.0")));
  EXPECT_THAT(named("# made by hand\n\n  # twice\r\nmtllib a.mtl\nv 0 0 0\n"), StartsWith("a Wavefront OBJ model; "));
  EXPECT_THAT(named("v 0 0 0\nf 1 1 1\n"), StartsWith("a Wavefront OBJ model; "));
  EXPECT_THAT(named("# nothing but a comment"), HasSubstr("not JSON")) << "no statement follows";
  EXPECT_THAT(named("newmtl skin\n"), StartsWith("a material library"));
  EXPECT_THAT(named("<?xml version=\"1.0\"?>\n<COLLADA>"), StartsWith("COLLADA"));
  EXPECT_THAT(named("solid cube\n"), StartsWith("an STL model; "));
  EXPECT_THAT(named(std::string(80, '\x01') + "\1\0\0\0"s + std::string(50, '\x02')), StartsWith("an STL model; "))
      << "one triangle";
  EXPECT_THAT(named(std::string(80, '\x01') + "\2\0\0\0"s + std::string(50, '\x02')), StartsWith("binary data"))
      << "of two triangles it says it has";
}

TEST(foreign_file, our_own_files_are_known_by_their_names) {
  EXPECT_THAT(named("SINEWAST\1"), AllOf(HasSubstr("sinew"), HasSubstr("sinew info")));
  EXPECT_THAT(named("SINEWCLP\1"), HasSubstr("compiled clips"));
  EXPECT_THAT(named("SINEWGEO\1"), HasSubstr("geometry cache"));
}

TEST(foreign_file, unknown_bytes_are_shown_as_text_or_as_numbers) {
  EXPECT_THAT(named("\x7f"
                    "ELF\2\1\1\0rest"s),
              HasSubstr("bytes 7f 45 4c 46 02 01 01 00; a .gltf starts with {"));
  EXPECT_THAT(named("<\1\2"), StartsWith("binary data")) << "no XML";
  EXPECT_THAT(named("\1\2"), HasSubstr("bytes 01 02;")) << "fewer than eight";
  EXPECT_THAT(named("hello\nworld"), HasSubstr("starts with \"hello\";"));
}

TEST(foreign_file, what_may_be_gltf_is_left_to_the_parser) {
  for (const char* text : {"{", " \n{\"asset\":", "\xEF\xBB\xBF{}", "[1]", "glTF", "glTF\2"})
    EXPECT_EQ(named(text), "may be glTF") << text;
}

TEST(foreign_file, no_beginning_of_a_file_is_too_short_to_be_named) {
  for (const std::string& file : {"PK\3\4"s + std::string(22, '\0') + "\x0a\0\0\0model.usdc"s, "# a\n#b\nmtllib"s,
                                  "\xff\xfe\0\0{"s, "\0\0\xfe\xff"s, "<?xml <COLLADA"s, "Kaydara FBX Binary"s,
                                  std::string(83, 'a') + "\1\0\0\0"s, "\xEF\xBB\xBF \n<html"s, "v"s})
    for (std::size_t size = 0; size <= file.size(); ++size) EXPECT_FALSE(named(file.substr(0, size)).empty());
}

TEST(foreign_file, an_import_says_what_the_file_is) {
  const auto result = import_gltf(bytes_of("; FBX 7.4.0 project file"), "model.gltf");
  ASSERT_EQ(outcome(result), "not-gltf at ");
  EXPECT_THAT(result.error().issue.detail, StartsWith("the file is FBX (as text); "));
  const auto refusal = import_gltf(bytes_of(R"({"message": "Not Found"})"), "model.gltf");
  ASSERT_EQ(outcome(refusal), "not-gltf at ");
  EXPECT_THAT(refusal.error().issue.detail, AllOf(HasSubstr("nothing of glTF"), HasSubstr("\"message\"")));
  EXPECT_EQ(outcome(import_gltf(bytes_of(R"({"nodes": []})"), "model.gltf")), "json-missing at ");
}

TEST(foreign_file, buffers_and_images_that_are_pointers_count_as_missing) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 3\n";
  const auto bytes = bytes_of(pointer);
  const std::string uri = "data:application/octet-stream;base64," + base64({bytes.begin(), bytes.end()});
  TinyGltf file;
  file.add_triangle();
  file.root["buffers"] = Json::array({{{"byteLength", 36}, {"uri", uri}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "buffer-missing at /buffers/0/uri");
  EXPECT_THAT(result.error().issue.detail, HasSubstr("git lfs pull"));
  TinyGltf picture;
  picture.root["images"] = Json::array({{{"uri", uri}}});
  EXPECT_TRUE(warns(picture.import(), "image-missing", "/images/0"));
}

}  // namespace
}  // namespace sinew::test
