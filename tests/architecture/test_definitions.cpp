// SPDX-License-Identifier: MIT
#include "tests/architecture/test_definitions.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

/// The source with comments, string literals and preprocessor lines blanked.
std::string code_of(const std::string& source) {
  std::string code = without_comments(source);
  bool directive = false, line_start = true;
  for (char& c : code) {
    if (c == '\n') {
      directive = false;
      line_start = true;
    } else {
      directive = directive || (line_start && c == '#');
      line_start = line_start && c == ' ';
      if (directive) c = ' ';
    }
  }
  return code;
}

std::size_t past_closing_brace(const std::string& code, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    depth += code[i] == '{' ? 1 : code[i] == '}' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return code.size();
}

bool is_of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The name that a head defines: "f(" for a function or test, "C" for a class; "" for namespaces and tables.
std::string defined_name(const std::string& head) {
  if (const std::size_t open = head.find('('); open != head.npos) {
    const auto begin = std::find_if_not(head.rend() - static_cast<std::ptrdiff_t>(open), head.rend(), is_of_a_name);
    const std::string name(begin.base(), head.begin() + static_cast<std::ptrdiff_t>(open));
    return name.empty() ? "" : name + "(";
  }
  const std::size_t keyword = std::max(head.rfind("class ") + 1, head.rfind("struct ") + 1);  // npos + 1 is 0
  if (keyword == 0) return "";
  const auto begin = head.begin() + static_cast<std::ptrdiff_t>(head.find(' ', keyword) + 1);
  return {begin, std::find_if_not(begin, head.end(), is_of_a_name)};
}

std::string head_of(const Definition& d) { return d.text.substr(0, d.text.find('{')); }

/// True if the text contains the name as a whole word.
bool stands_in(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_of_a_name(text[at - 1])) &&
        (name.back() == '(' || end == text.size() || !is_of_a_name(text[end])))
      return true;
  }
  return false;
}

/// True if the text calls one of these functions. Also true if the head names one of these classes, as a base or as
/// the suite of a test.
bool uses_one_of(const Definition& d, const std::set<std::string>& names) {
  const std::string head = head_of(d);
  const bool has_classes = d.is_test() || !d.name.ends_with('(');
  return std::ranges::any_of(names, [&](const std::string& name) {
    return name.ends_with('(') ? stands_in(d.text, name) : has_classes && stands_in(head, name);
  });
}

std::smatch suite_and_name(const Definition& test) {
  static const std::regex pattern(R"re(\w+\s*\(\s*(\w+)\s*,\s*(\w+))re");
  std::smatch found;
  std::regex_search(test.text, found, pattern);
  return found;
}

}  // namespace

bool Definition::is_test() const {
  static const std::set<std::string> macros = {
      "TEST(", "TEST_F(", "TEST_P(", "TYPED_TEST(", "TYPED_TEST_P(", "RC_GTEST_PROP(", "RC_GTEST_FIXTURE_PROP("};
  return macros.contains(name);
}

std::vector<Definition> definitions_of(const std::string& source) {
  const std::string code = code_of(source);
  std::vector<Definition> found;
  for (std::size_t begin = 0, i = 0; i < code.size(); ++i) {
    if (code[i] == '{')
      if (const std::string name = defined_name(code.substr(begin, i - begin)); !name.empty()) {
        const std::size_t end = past_closing_brace(code, i);
        found.push_back({name, code.substr(begin, end - begin)});
        i = end - 1;
      }
    if (code[i] == ';' || code[i] == '{' || code[i] == '}') begin = i + 1;
  }
  return found;
}

std::string test_name(const Definition& test) {
  const std::smatch found = suite_and_name(test);
  return found[1].str() + "." + found[2].str();
}

std::set<std::string> skipping_names(const std::vector<Definition>& definitions) {
  std::set<std::string> names = {"GTEST_SKIP("};
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (const Definition& d : definitions)
      if (!d.is_test() && !names.contains(d.name) && uses_one_of(d, names)) names.insert(d.name);
  }
  return names;
}

bool may_be_skipped(const Definition& test, const std::set<std::string>& skipping) {
  const std::smatch found = suite_and_name(test);
  return found[1].str().starts_with("DISABLED_") || found[2].str().starts_with("DISABLED_") ||
         uses_one_of(test, skipping);
}

}  // namespace sinew::test
