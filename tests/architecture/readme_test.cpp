// SPDX-License-Identifier: MIT
// README.md stays short, and the files that the READMEs name exist.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadmeLines = 150, kFilesToRead = 8;

struct Page {
  std::string path;  ///< from the root of the repository
  std::string text;
};

Page page(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {file.lexically_relative(SINEW_SOURCE_DIR).generic_string(),
          std::string(std::istreambuf_iterator<char>(in), {})};
}

/// README.md of the root and of every folder.
std::vector<Page> readmes() {
  const fs::path root = SINEW_SOURCE_DIR;
  std::vector<Page> pages{page(root / "README.md")};
  for (const char* folder : {"runtime", "importer", "viewer", "tests", "samples"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().filename() == "README.md") pages.push_back(page(entry.path()));
  return pages;
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

/// Dead links to files, and dead source paths in code spans: `math/affine.h` of a page in runtime/, or a path from the
/// root.
std::vector<std::string> dead_paths(const Page& page) {
  const fs::path root = SINEW_SOURCE_DIR, folder = (root / page.path).parent_path();
  std::vector<std::string> dead;
  for (const std::string& link : matches(page.text, R"re(\]\(([^)#: ]+)(?:#[^)]*)?\))re"))
    if (!fs::exists(folder / link)) dead.push_back(page.path + ": " + link);
  for (const std::string& path : matches(page.text, R"re(`([\w/-]+/[\w-]+\.(?:h|cpp|py|sh|inc|md|cmake))`)re"))
    if (!path.starts_with("build/") && !fs::exists(folder / path) && !fs::exists(root / path))
      dead.push_back(page.path + ": " + path);
  return dead;
}

/// The numbered list under "Reading order".
std::vector<std::string> reading_order(const std::string& text) {
  const std::size_t start = text.find("## Reading order\n");
  if (start == std::string::npos) return {};
  return matches(text.substr(start, text.find("\n## ", start + 1) - start), R"re(\n\d+\. `([^`]+)`)re");
}

TEST(readme, is_short_and_names_at_most_eight_files_to_read_first) {
  const Page readme = page(fs::path(SINEW_SOURCE_DIR) / "README.md");
  EXPECT_LE(lines_of(readme.text).size(), kReadmeLines);
  const std::vector<std::string> files = reading_order(readme.text);
  EXPECT_FALSE(files.empty());
  EXPECT_LE(files.size(), kFilesToRead);
  for (const std::string& file : files) EXPECT_TRUE(fs::exists(fs::path(SINEW_SOURCE_DIR) / file)) << file;
}

TEST(readme, every_file_that_a_readme_names_exists) {
  std::vector<std::string> dead;
  for (const Page& page : readmes())
    for (const std::string& path : dead_paths(page)) dead.push_back(path);
  EXPECT_GE(readmes().size(), 6u);
  EXPECT_THAT(dead, testing::IsEmpty());
}

TEST(readme, names_without_a_file_are_found) {
  const Page sound{"runtime/README.md",
                   "[math](math/affine.h#x) `math/affine.h` `runtime/math/affine.h` <https://x.y>"};
  EXPECT_THAT(dead_paths(sound), testing::IsEmpty());
  EXPECT_THAT(dead_paths({"runtime/README.md", "[math](math/gone.h)"}), testing::SizeIs(1));
  EXPECT_THAT(dead_paths({"runtime/README.md", "see `math/gone.h`"}), testing::SizeIs(1));
  EXPECT_THAT(reading_order("## Reading order\n\n1. `a.h`: x\n2. `b.h`: `c.h`\n\n## Speed\n\n1. `d.h`\n"),
              testing::ElementsAre("a.h", "b.h"));
}

}  // namespace
}  // namespace sinew::test
