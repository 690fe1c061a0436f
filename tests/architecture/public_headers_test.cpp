// SPDX-License-Identifier: MIT
// Engines see the headers that runtime/public_headers.cmake lists, and no other. public_headers_alone.cmake compiles
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHeaders = 45;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

struct PublicHeader {
  std::string name;    ///< "frame.h" of <sinew/frame.h>
  std::string source;  ///< from the root of the repository
};

std::vector<PublicHeader> public_headers() {
  const std::string text = text_of(fs::path(SINEW_SOURCE_DIR) / "runtime/public_headers.cmake");
  static const std::regex line(R"re((\w+\.h) +((?:runtime|importer)/[\w/]+\.h))re");
  std::vector<PublicHeader> headers;
  for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match)
    headers.push_back({(*match)[1], (*match)[2]});
  return headers;
}

std::vector<std::string> names_of(const std::vector<PublicHeader>& headers) {
  std::vector<std::string> names;
  for (const PublicHeader& header : headers) names.push_back(header.name);
  return names;
}

/// X of each <sinew/X> in a text.
std::vector<std::string> sinew_includes(const std::string& text) {
  static const std::regex include(R"re(<sinew/([\w/.]+)>)re");
  std::vector<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

TEST(public_headers, are_at_most_45_and_exist) {
  const auto headers = public_headers();
  EXPECT_GE(headers.size(), 30u);
  EXPECT_LE(headers.size(), kMostHeaders);
  for (const PublicHeader& header : headers)
    EXPECT_TRUE(fs::exists(fs::path(SINEW_SOURCE_DIR) / header.source)) << header.source;
}

TEST(public_headers, are_the_rows_of_the_table_in_the_readme) {
  std::vector<std::string> rows;
  for (const std::string& line : lines_of(text_of(fs::path(SINEW_SOURCE_DIR) / "runtime/README.md")))
    if (line.starts_with("| `<sinew/")) rows.push_back(sinew_includes(line).front());
  EXPECT_THAT(rows, testing::UnorderedElementsAreArray(names_of(public_headers())));
}

TEST(public_headers, are_all_that_samples_and_pages_include) {
  const auto names = names_of(public_headers());
  std::size_t found = 0;
  const auto expect_public = [&](const fs::path& file) {
    for (const std::string& name : sinew_includes(text_of(file))) {
      ++found;
      EXPECT_THAT(names, testing::Contains(name)) << file;
    }
  };
  const fs::path root = SINEW_SOURCE_DIR;
  expect_public(root / "README.md");
  for (const char* folder : {"runtime", "importer", "viewer", "tests", "samples"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path extension = entry.path().extension();
      const bool is_text = extension == ".md" || extension == ".cpp" || extension == ".h" || extension == ".c";
      if (is_text && entry.path().stem() != "public_headers_test") expect_public(entry.path());
    }
  EXPECT_GE(found, 50u);
}

/// Comments of public headers name other public headers, so that a reader of the installed folder finds them.
TEST(public_headers, name_no_path_of_this_tree) {
  for (const PublicHeader& header : public_headers())
    for (const std::string& line : lines_of(text_of(fs::path(SINEW_SOURCE_DIR) / header.source))) {
      const bool has_path = line.find("runtime/") != std::string::npos || line.find("importer/") != std::string::npos;
      EXPECT_TRUE(line.starts_with("#include") || !has_path) << header.source << ": " << line;
    }
}

}  // namespace
}  // namespace sinew::test
