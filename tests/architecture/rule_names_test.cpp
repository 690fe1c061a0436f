// SPDX-License-Identifier: MIT
// Rules that comments and READMEs of the importer name must exist: in rules.inc, or as a string in the code that
// reports them.
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string>;

/// Words such as accessor-bounds: in a string, in quotes of either kind, and anywhere in a text.
const std::regex kInString(R"re("([a-z]{2,}(?:-[a-z0-9]+)+)")re", std::regex::optimize);
const std::regex kInQuotes(R"re(["`]([a-z]{2,}(?:-[a-z0-9]+)+)["`])re", std::regex::optimize);
const std::regex kInText(R"re((?:^|[ (`"])([a-z]{2,}(?:-[a-z0-9]+)+)(?![\w-]))re", std::regex::optimize);

void add_matches(const std::string& text, const std::regex& expression, Names& out) {
  if (text.find('-') == std::string::npos) return;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    out.insert((*match)[1]);
}

/// Splits a line into its code and its comment.
std::pair<std::string, std::string> parts_of(const std::string& line) {
  const std::size_t comment = line.find("//");
  return comment == std::string::npos ? std::pair(line, std::string())
                                      : std::pair(line.substr(0, comment), line.substr(comment));
}

/// Strings in code that look like rules.
Names known_rules(const std::vector<SourceFile>& files) {
  Names known;
  for (const std::string& line : lines_of(text_of_file(fs::path(SINEW_SOURCE_DIR) / "importer/rules.inc")))
    add_matches(line.substr(0, line.find("\", ") + 1), kInString, known);  // the sentence of the rule follows
  for (const SourceFile& file : files)
    if (file.in("importer") || file.in("runtime"))
      for (const std::string& line : lines_of(file.text)) add_matches(parts_of(line).first, kInString, known);
  return known;
}

/// Names in quotes in comments, and all names in the parts `err` and `warning` of a block.
Names rules_in_comments(const SourceFile& file) {
  Names named;
  bool lists_rules = false;
  for (const std::string& line : lines_of(file.text)) {
    const std::string comment = parts_of(line).second;
    const bool is_labelled = comment.starts_with("/// err ") || comment.starts_with("/// warning ");
    lists_rules = is_labelled || (lists_rules && comment.starts_with("///  "));
    add_matches(comment, lists_rules ? kInText : kInQuotes, named);
  }
  return named;
}

std::vector<std::string> unknown(const std::string& path, const Names& named, const Names& known) {
  std::vector<std::string> found;
  for (const std::string& name : named)
    if (!known.contains(name)) found.push_back(path + ": " + name);
  return found;
}

TEST(rule_names, that_comments_name_exist) {
  const std::vector<SourceFile> files = source_tree();
  const Names known = known_rules(files);
  std::size_t named = 0;
  for (const SourceFile& file : files) {
    if (!file.in("importer")) continue;
    const Names here = rules_in_comments(file);
    named += here.size();
    EXPECT_THAT(unknown(file.path, here, known), testing::IsEmpty());
  }
  EXPECT_GT(named, 150u) << "rules are looked for where they stand";
}

TEST(rule_names, that_readmes_name_exist) {
  const Names known = known_rules(source_tree());
  const fs::path root = SINEW_SOURCE_DIR;
  for (const auto& entry : fs::recursive_directory_iterator(root / "importer")) {
    if (entry.path().filename() != "README.md") continue;
    Names named;
    for (const std::string& line : lines_of(text_of_file(entry.path()))) add_matches(line, kInQuotes, named);
    EXPECT_THAT(unknown(entry.path().lexically_relative(root).string(), named, known), testing::IsEmpty());
  }
}

}  // namespace
}  // namespace sinew::test
