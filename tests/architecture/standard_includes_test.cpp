// SPDX-License-Identifier: MIT
// Compilers differ in which standard header includes which other, and precompiled headers include more. So each file
// must include the header of every name it uses, itself or through one of our headers.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

/// Names of namespace std as a regular expression, by the header that declares them. Names that every header brings
/// (std::size_t, std::move) are left out.
const std::map<std::string, std::string> kDeclares = {
    {"algorithm",
     "(sort|min|max|clamp|any_of|all_of|none_of|find_if|transform|copy|fill|lower_bound|upper_bound|unique|minmax_"
     "element|max_element|"
     "min_element|stable_sort|reverse|rotate|equal|count_if|for_each)\\("},
    {"array", "array<"},
    {"atomic", "atomic\\b"},
    {"bit", "(bit_cast|bit_width|popcount|countr_zero|has_single_bit)\\b"},
    {"chrono", "chrono\\b"},
    {"cmath", "(sqrt|abs|sin|cos|atan2|floor|ceil|round|fmod|isfinite|pow|exp2|ldexp|hypot|fma|lround|log2)\\("},
    {"cstdint", "u?int(8|16|32|64|ptr)_t\\b"},
    {"cstdio", "(printf|fprintf|fopen|fputs|snprintf)\\b"},
    {"cstdlib", "(getenv|abort|exit|strtod|aligned_alloc|free)\\b"},
    {"cstring", "(memcpy|memcmp|memset|strlen)\\b"},
    {"filesystem", "filesystem\\b"},
    {"fstream", "[io]fstream\\b"},
    {"functional", "function<"},
    {"iterator", "(size|back_inserter|next|prev|distance)\\("},
    {"limits", "numeric_limits\\b"},
    {"map", "map<"},
    {"memory", "(unique_ptr|shared_ptr|make_unique|make_shared)\\b"},
    {"mutex", "mutex\\b"},
    {"numeric", "(iota|accumulate|gcd|reduce)\\b"},
    {"optional", "optional<"},
    {"set", "set<"},
    {"span", "span<"},
    {"stdexcept", "runtime_error\\b"},
    {"string", "string\\b"},
    {"string_view", "string_view\\b"},
    {"thread", "thread\\b"},
    {"tuple", "(tuple|tie)\\b"},
    {"variant", "(variant|visit)\\b"},
    {"vector", "vector<"},
};

/// Names of the libraries with precompiled headers, and the start of their headers' paths.
const std::map<std::string, std::string> kLibraries = {
    {"CLI::", "CLI/"}, {"fmt::", "fmt/"}, {"glm::", "glm/"}, {"nlohmann::", "nlohmann/"}, {"Vk[A-Z]", "vulkan/"}};

/// Names that follow "std::" in a text, each with the character after it, without repeats.
std::set<std::string> standard_names(const std::string& text) {
  static const std::regex name("std::([a-z_0-9]+.?)");
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) found.insert((*at)[1]);
  return found;
}

class Includes {
 public:
  explicit Includes(const std::vector<SourceFile>& files) {
    for (const SourceFile& file : files) texts_[file.path] = &file.text;
  }

  /// Standard headers that a file includes, itself or through headers of ours.
  const std::set<std::string>& of(const std::string& path) {
    const auto [entry, is_new] = found_.try_emplace(path);
    if (!is_new || !texts_.contains(path)) return entry->second;
    std::set<std::string> all;
    for (const std::string& header : system_includes(*texts_[path])) all.insert(header);
    for (const std::string& ours : quoted_includes(*texts_[path])) all.insert(of(ours).begin(), of(ours).end());
    return found_[path] = std::move(all);
  }

 private:
  std::map<std::string, const std::string*> texts_;
  std::map<std::string, std::set<std::string>> found_;
};

std::map<std::string, std::regex> patterns() {
  std::map<std::string, std::regex> out;
  for (const auto& [header, names] : kDeclares) out.emplace(header, names + ".?");
  return out;
}

std::vector<std::string> missing_of(const std::string& text, const std::set<std::string>& included) {
  static const std::map<std::string, std::regex> declared = patterns();
  std::vector<std::string> missing;
  for (const std::string& name : standard_names(without_comments(text)))
    for (const auto& [header, names] : declared)
      if (!included.contains(header) && std::regex_match(name, names))
        missing.push_back("std::" + name + " without <" + header + ">");
  return missing;
}

std::vector<std::string> missing_libraries(const std::string& text, const std::set<std::string>& included) {
  const std::string code = without_comments(text);
  std::vector<std::string> missing;
  for (const auto& [name, folder] : kLibraries) {
    const auto header = included.lower_bound(folder);
    const bool is_there = header != included.end() && header->starts_with(folder);
    if (!is_there && std::regex_search(code, std::regex("\\b" + name))) missing.push_back(name + " without " + folder);
  }
  return missing;
}

TEST(standard_includes, files_include_the_headers_of_the_names_they_use) {
  const std::vector<SourceFile> files = source_tree();
  Includes includes(files);
  for (const SourceFile& file : files)
    for (const auto& missing :
         {missing_of(file.text, includes.of(file.path)), missing_libraries(file.text, includes.of(file.path))})
      for (const std::string& what : missing) ADD_FAILURE() << file.path << ": " << what;
}

TEST(standard_includes, a_use_without_its_header_is_seen) {
  EXPECT_EQ(missing_of("std::uint32_t n = 0; std::sort(a, b);", {"algorithm"}),
            std::vector<std::string>{"std::uint32_t  without <cstdint>"});
  EXPECT_TRUE(missing_of("// std::map<int, int>\nstd::size_t n;", {}).empty());
  EXPECT_EQ(missing_libraries("glm::vec3 v; // fmt::format", {"algorithm", "gl.h", "gmock/gmock.h"}),
            std::vector<std::string>{"glm:: without glm/"});
  EXPECT_TRUE(missing_libraries("glm::vec3 v; VkImage image;", {"glm/vec3.hpp", "vulkan/vulkan.h"}).empty());
}

}  // namespace
}  // namespace sinew::test
