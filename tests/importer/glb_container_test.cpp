// SPDX-License-Identifier: MIT
#include "importer/file/glb_container.h"

#include <gtest/gtest.h>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

std::string u32(std::uint32_t value) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 255);
  return text;
}

std::string chunk(const std::string& type, const std::string& data) {
  return u32(static_cast<std::uint32_t>(data.size())) + type + data;
}

std::string glb(const std::string& chunks, std::uint32_t version = 2) {
  return "glTF" + u32(version) + u32(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

const std::string kBinType("BIN\0", 4);

std::string rule_of(const std::string& file) {
  IssueLog log;
  if (open_glb(bytes_of(file), log)) return "ok";
  return log.take_error("x").issue.rule;
}

TEST(glb_container, splits_json_and_bin) {
  IssueLog log;
  const std::string file = glb(chunk("JSON", "{}  ") + chunk(kBinType, "abcd"));
  const auto parts = open_glb(bytes_of(file), log);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->json.size(), 4u);
  ASSERT_TRUE(parts->bin);
  EXPECT_EQ(std::to_integer<char>((*parts->bin)[3]), 'd');
  EXPECT_TRUE(log.take_warnings().empty());
}

TEST(glb_container, G67_every_truncation_is_refused) {
  const std::string file = glb(chunk("JSON", "{}  ") + chunk(kBinType, "abcd"));
  for (std::size_t size = 0; size < file.size(); ++size) EXPECT_EQ(rule_of(file.substr(0, size)), "glb-header") << size;
}

TEST(glb_container, a_file_without_room_for_a_header_is_told_its_size) {
  IssueLog log;
  EXPECT_FALSE(open_glb(bytes_of("glTF\2"), log));
  EXPECT_EQ(log.take_error("x").issue.detail, "the file has 5 bytes, a header needs 12");
}

TEST(glb_container, a_chunk_needs_room_for_its_own_header) {
  const std::string whole = chunk("JSON", "{}  ") + chunk(kBinType, "abcd");
  for (const std::size_t more : {1u, 4u, 7u}) {
    IssueLog log;
    EXPECT_FALSE(open_glb(bytes_of(glb(whole + std::string(more, '\0'))), log)) << more;
    EXPECT_EQ(log.take_error("x").issue.detail, "the chunk at byte 36 has no room for its header");
  }
  EXPECT_EQ(rule_of(glb(whole + chunk("WHAT", ""))), "ok") << "eight bytes are room enough";
}

TEST(glb_container, refuses_bad_headers) {
  const std::string chunks = chunk("JSON", "{}  ");
  EXPECT_EQ(rule_of(glb(chunks, 1)), "glb-header");
  EXPECT_EQ(rule_of("glTX" + glb(chunks).substr(4)), "glb-header");
  EXPECT_EQ(rule_of("glTF" + u32(2) + u32(0xffffffff) + chunks), "glb-header");
  EXPECT_EQ(rule_of("glTF" + u32(2) + u32(4) + chunks), "glb-header");
}

TEST(glb_container, T9_chunk_lengths_near_2_to_the_32_do_not_wrap) {
  const std::string body = u32(0xfffffffc) + "JSON{}  ";
  EXPECT_EQ(rule_of(glb(body)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(chunk("JSON", "{}  ") + u32(0xfffffff8) + kBinType + "abcd")), "glb-chunk");
}

TEST(glb_container, refuses_wrong_chunk_orders) {
  const std::string json = chunk("JSON", "{}  "), bin = chunk(kBinType, "abcd"), other = chunk("WHAT", "abcd");
  EXPECT_EQ(rule_of(glb("")), "glb-chunk");
  EXPECT_EQ(rule_of(glb(bin)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(bin + json)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(json + json)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(json + bin + bin)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(json + other + bin)), "glb-chunk");
  EXPECT_EQ(rule_of(glb(chunk("JSON", ""))), "glb-chunk");
  EXPECT_EQ(rule_of(glb(json + bin + other)), "ok");
}

/// The warnings of a container that can be read, and its two parts.
std::string parts_of(const std::string& file) {
  IssueLog log;
  const auto parts = open_glb(bytes_of(file), log);
  if (!parts) return log.take_error("x").issue.rule;
  const auto text = [](std::span<const std::byte> bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  std::string out = "\"" + text(parts->json) + "\" \"" + (parts->bin ? text(*parts->bin) : "none") + "\"";
  for (const ImportIssue& warning : log.take_warnings()) out += " " + warning.rule;
  return out;
}

TEST(glb_container, chunks_of_any_length_are_read_from_where_they_lie) {
  EXPECT_EQ(parts_of(glb(chunk("JSON", "{} "))), R"("{} " "none" glb-alignment)");
  EXPECT_EQ(parts_of(glb(chunk("JSON", "{} ") + chunk(kBinType, "abcd"))), R"("{} " "abcd" glb-alignment)");
  EXPECT_EQ(parts_of(glb(chunk("JSON", "{}  ") + chunk(kBinType, "abcde"))), R"("{}  " "abcde" glb-alignment)");
  for (const std::size_t padding : {1u, 2u, 3u}) {
    const std::string json(8 - padding, ' '), zeros(padding, '\0');
    EXPECT_EQ(parts_of(glb(chunk("JSON", json) + std::string(padding, ' ') + chunk(kBinType, "abcd"))),
              '"' + json + R"(" "abcd" glb-alignment)")
        << "padding that the length leaves out: " << padding;
    EXPECT_EQ(parts_of(glb(chunk("JSON", "{}  ") + chunk(kBinType, json) + zeros)),
              R"("{}  " ")" + json + R"(" glb-alignment)")
        << "padding at the end: " << padding;
  }
  EXPECT_EQ(parts_of(glb(chunk("JSON", "{} ") + "BIN?")), "glb-chunk") << "nothing of a chunk follows";
}

TEST(glb_container, bytes_that_a_program_took_for_text_are_told_from_a_file_that_is_cut_off) {
  const auto detail_of = [](const std::string& file) {
    IssueLog log;
    EXPECT_FALSE(open_glb(bytes_of(file), log));
    return log.take_error("x").issue.detail;
  };
  const std::string chunks = chunk("JSON", "{}  ");
  EXPECT_NE(
      detail_of("glTF" + u32(2) + "\xef\xbf\xbd\x01" + std::string(2, '\0') + chunks).find("as if they were text"),
      std::string::npos);
  EXPECT_NE(detail_of("glTF" + u32(2) + u32(1000) + chunks).find("it is cut off"), std::string::npos);
}

TEST(glb_container, bytes_after_the_end_are_a_warning) {
  IssueLog log;
  const std::string file = glb(chunk("JSON", "{}  ")) + "rest";
  EXPECT_TRUE(open_glb(bytes_of(file), log));
  const auto warnings = log.take_warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].rule, "glb-extra-data");
}

TEST(glb_container, T6_a_bin_chunk_serves_buffer_0_only) {
  std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4},{"byteLength":4}],)"
                     R"("bufferViews":[{"buffer":1,"byteLength":4}],)"
                     R"("accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string file = glb(chunk("JSON", json) + chunk(kBinType, "abcd"));
  EXPECT_EQ(outcome(import_gltf(bytes_of(file), "x.glb")), "buffer-missing at /buffers/1");
}

}  // namespace
}  // namespace sinew::test
