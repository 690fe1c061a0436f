// SPDX-License-Identifier: MIT
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

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
  enum class In { code, line_comment, block_comment, string } in = In::code;
  std::string out = text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    const In before = in;
    if (in == In::code && text[i] == '/' && next == '/')
      in = In::line_comment;
    else if (in == In::code && text[i] == '/' && next == '*')
      in = In::block_comment;
    else if (in == In::code && text[i] == '"') {
      in = In::string;
      continue;
    } else if (in == In::line_comment && text[i] == '\n')
      in = In::code;
    else if (in == In::block_comment && text[i] == '*' && next == '/') {
      out[i] = out[i + 1] = ' ';
      ++i;
      in = In::code;
      continue;
    } else if (in == In::string && text[i] == '\\') {
      out[i] = ' ';
      if (next != '\n' && next) out[++i] = ' ';
      continue;
    } else if (in == In::string && (text[i] == '"' || text[i] == '\n')) {
      in = In::code;
      continue;
    }
    if ((in != In::code || before != In::code) && text[i] != '\n') out[i] = ' ';
  }
  return out;
}

}  // namespace sinew::test
