// SPDX-License-Identifier: MIT
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string_view>

namespace sinew::test {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> includes(const std::string& text, const char* pattern) {
  const std::regex include(pattern);
  std::vector<std::string> names;
  for (const std::string& line : lines_of(text))
    if (std::smatch match; std::regex_search(line, match, include)) names.push_back(match[1]);
  return names;
}

bool is_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// End of the comment or literal that starts at `i`; i + 1 if none starts there.
std::size_t end_of_piece(const std::string& text, std::size_t i) {
  const auto past = [&](std::string_view mark, std::size_t from) {
    const std::size_t found = text.find(mark, from);
    return found == std::string::npos ? text.size() : found + mark.size();
  };
  const char previous = i > 0 ? text[i - 1] : '\0';
  if (text.compare(i, 2, "//") == 0) return std::min(text.find('\n', i), text.size());
  if (text.compare(i, 2, "/*") == 0) return past("*/", i + 2);
  if (text[i] == '"' && previous == 'R') return past(")" + text.substr(i + 1, text.find('(', i) - i - 1) + "\"", i + 1);
  const bool digit_separator = text[i] == '\'' && is_of_a_name(previous);
  if ((text[i] != '"' && text[i] != '\'') || digit_separator) return i + 1;
  std::size_t end = i + 1;
  while (end < text.size() && text[end] != text[i] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

}  // namespace

std::vector<SourceFile> source_tree() {
  const fs::path root = SINEW_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* folder : {"runtime", "importer", "viewer", "tests", "samples"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      if (!entry.is_regular_file() || (path.extension() != ".h" && path.extension() != ".cpp")) continue;
      std::ifstream in(path, std::ios::binary);
      files.push_back(
          {path.lexically_relative(root).generic_string(), std::string(std::istreambuf_iterator<char>(in), {})});
    }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> quoted_includes(const std::string& text) {
  return includes(text, R"re(^\s*#\s*include\s*"([^"]+)")re");
}

std::vector<std::string> system_includes(const std::string& text) {
  return includes(text, R"re(^\s*#\s*include\s*<([^>]+)>)re");
}

std::string without_comments(const std::string& text) {
  std::string out = text;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = end_of_piece(text, i);
    const bool quoted = text[i] == '"' || text[i] == '\'';
    for (std::size_t k = i + quoted; end > i + 1 && k < end - quoted; ++k)
      if (text[k] != '\n') out[k] = ' ';
    i = end;
  }
  return out;
}

}  // namespace sinew::test
