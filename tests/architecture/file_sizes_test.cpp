// SPDX-License-Identifier: MIT
// A file that outgrows its limit holds two ideas: split it.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeaderLines = 150, kSourceLines = 400, kTestLines = 450;

std::size_t limit_for(const SourceFile& file) {
  if (file.in("tests")) return kTestLines;
  return file.is_header() ? kHeaderLines : kSourceLines;
}

TEST(file_sizes, headers_sources_and_tests_stay_below_their_limits) {
  std::vector<std::string> large;
  for (const SourceFile& file : source_tree())
    if (const std::size_t count = lines_of(file.text).size(); count > limit_for(file))
      large.push_back(file.path + ": " + std::to_string(count) + " lines, limit " + std::to_string(limit_for(file)));
  EXPECT_THAT(large, testing::IsEmpty());
}

/// A header and its source file count once.
TEST(file_sizes, folders_of_the_product_hold_what_a_reader_can_survey) {
  constexpr std::size_t kFolderStems = 32;
  std::map<fs::path, std::set<fs::path>> stems;
  for (const SourceFile& file : source_tree())
    if (file.in("runtime") || file.in("importer") || file.in("viewer"))
      stems[fs::path(file.path).parent_path()].insert(fs::path(file.path).stem());
  EXPECT_GT(stems["viewer/app"].size(), 10u);
  for (const auto& [folder, names] : stems) EXPECT_LE(names.size(), kFolderStems) << folder;
}

TEST(file_sizes, the_tree_is_really_read) {
  const auto files = source_tree();
  EXPECT_GT(files.size(), 40u);
  EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](const SourceFile& f) {
    return f.path == "runtime/math/conventions.h" && lines_of(f.text).size() > 10;
  }));
}

TEST(file_sizes, each_file_starts_with_its_licence_and_headers_with_a_guard) {
  std::vector<std::string> bare;
  for (const SourceFile& file : source_tree()) {
    const bool has_licence = file.text.starts_with("// SPDX-License-Identifier: MIT\n") ||
                             file.text.starts_with("/* SPDX-License-Identifier: MIT\n");
    if (!has_licence) bare.push_back(file.path);
    if (file.is_header() && !file.path.ends_with("-inl.h") && file.text.find("\n#pragma once\n") == std::string::npos)
      bare.push_back(file.path + " (no #pragma once)");
  }
  EXPECT_THAT(bare, testing::IsEmpty());
}

}  // namespace
}  // namespace sinew::test
