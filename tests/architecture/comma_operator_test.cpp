// SPDX-License-Identifier: MIT
// A comma must never join two statements: `a = b, c = d;` hides the second one. The steps of a for loop and folds over
// a pack may use it. The test has no parser: it matches brackets and classifies the code between them by its first
// tokens.
#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace sinew::test {
namespace {

using Words = std::set<std::string>;

struct Token {
  std::string text;
  std::size_t line = 0;
  std::size_t match = 0;  ///< for ( [ { and < of template arguments: index of the closing token

  bool is_word() const { return std::isalnum(static_cast<unsigned char>(text[0])) || text[0] == '_' || text[0] == '"'; }
};

/// Code without preprocessor lines.
std::string without_directives(const std::string& code) {
  std::string out;
  bool directive = false;
  for (const std::string& line : lines_of(code)) {
    const std::size_t first = line.find_first_not_of(' ');
    directive = directive || (first != std::string::npos && line[first] == '#');
    out += (directive ? "" : line) + "\n";
    directive = directive && line.ends_with('\\');
  }
  return out;
}

std::size_t length_of_token(const std::string& code, std::size_t at) {
  const auto is_name = [&](std::size_t i) {
    const bool digit_separator = i > at && code[i] == '\'' && i + 1 < code.size() && code[i + 1] != ' ';
    return std::isalnum(static_cast<unsigned char>(code[i])) || code[i] == '_' || digit_separator;
  };
  std::size_t end = at;
  while (end < code.size() && is_name(end)) ++end;
  if (end > at) return end - at;
  if (code[at] == '"' || code[at] == '\'') return code.find(code[at], at + 1) - at + 1;
  for (const char* symbol : {"...", "<<=", "<=>", "::", "->", "<<", "<=", "==", "!=", "&&", "||",
                             "++",  "--",  "+=",  "-=", "*=", "/=", "|=", "&=", "^=", "%="})
    if (code.compare(at, std::char_traits<char>::length(symbol), symbol) == 0)
      return std::char_traits<char>::length(symbol);
  return 1;
}

std::vector<Token> tokens_of(const std::string& text) {
  const std::string code = without_directives(without_comments(text));
  std::vector<Token> tokens;
  std::vector<std::size_t> open;
  std::size_t line = 1;
  for (std::size_t at = 0; at < code.size();) {
    line += code[at] == '\n';
    if (std::isspace(static_cast<unsigned char>(code[at]))) {
      ++at;
      continue;
    }
    const std::size_t length = length_of_token(code, at);
    tokens.push_back({.text = code.substr(at, length), .line = line});
    line += static_cast<std::size_t>(std::ranges::count(tokens.back().text, '\n'));
    at += std::min(length, code.size() - at);
    const char c = tokens.back().text[0];
    if (c == '(' || c == '[' || c == '{') open.push_back(tokens.size() - 1);
    if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
      tokens[open.back()].match = tokens.size() - 1;
      open.pop_back();
    }
  }
  return tokens;
}

/// The end of template arguments that start at the `<` at `at`; 0 if this `<` is a comparison.
std::size_t end_of_template(const std::vector<Token>& tokens, std::size_t at) {
  if (at == 0 || !tokens[at - 1].is_word() || tokens[at - 1].text == "operator") return 0;
  static const Words allowed = {"::", ",", "*", "&", "...", "-"};
  const bool parameters = tokens[at - 1].text == "template";
  for (std::size_t i = at + 1; i < tokens.size(); ++i) {
    if (tokens[i].text == ">") return i;
    if (tokens[i].text == "<") {
      i = end_of_template(tokens, i);
      if (i == 0) return 0;
    } else if (tokens[i].match) {
      i = tokens[i].match;
    } else if (!tokens[i].is_word() && !allowed.contains(tokens[i].text) && !(parameters && tokens[i].text == "=")) {
      return 0;
    }
  }
  return 0;
}

class CommaFinder {
 public:
  explicit CommaFinder(const std::string& text) : tokens_(tokens_of(text)) {
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (is(i, "<")) tokens_[i].match = end_of_template(tokens_, i);
    check_block(0, tokens_.size());
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (is(i, "{") && is_block(i)) check_block(i + 1, tokens_[i].match);
      if (is(i, "(") && groups(i)) check_block(i + 1, tokens_[i].match);
    }
  }

  const std::set<std::size_t>& lines() const { return lines_; }

 private:
  bool is(std::size_t i, const char* text) const { return i < tokens_.size() && tokens_[i].text == text; }
  std::size_t past(std::size_t i) const { return (tokens_[i].match ? tokens_[i].match : i) + 1; }

  /// True if braces hold statements: they follow `)` or contain a semicolon. Other braces hold a list.
  bool is_block(std::size_t open) const {
    if (open > 0 && (is(open - 1, ")") || is(open - 1, "}"))) return true;
    for (std::size_t i = open + 1; i < tokens_[open].match; i = past(i))
      if (is(i, ";")) return true;
    return false;
  }

  /// True if braces are the body of a lambda, so that the statement continues after them.
  bool is_lambda(std::size_t open) const {
    static const Words between = {"->", "::", "*", "&", ",", ">", "<"};
    std::size_t i = open;
    while (i > 0 && (tokens_[i - 1].is_word() || between.contains(tokens_[i - 1].text))) --i;
    if (i > 0 && is(i - 1, "]")) return true;
    for (std::size_t before = i; i > 0 && is(i - 1, ")") && before-- > 1;)
      if (tokens_[before].match == i - 1) return is(before - 1, "]");
    return false;
  }

  /// True if parentheses hold an expression or a condition. False for arguments, parameters and the header of a for
  /// loop.
  bool groups(std::size_t open) const {
    static const Words keywords = {"if", "while", "switch", "return", "throw", "constexpr", "case"};
    static const Words operators = {"=",  "(",  "{", ";",  ",",  "?",  ":",  "!",  "+",  "-",  "/",  "&&", "||",
                                    "==", "!=", "<", "<=", "<<", "+=", "-=", "*=", "/=", "|=", "&=", "^=", "%="};
    if (open == 0 || tokens_[open].match == 0) return false;
    const bool named_operator = open > 1 && is(open - 2, "operator");
    return keywords.contains(tokens_[open - 1].text) || (!named_operator && operators.contains(tokens_[open - 1].text));
  }

  /// Splits the tokens of a block or parentheses into statements, and checks each.
  void check_block(std::size_t first, std::size_t last) {
    std::size_t start = first;
    for (std::size_t i = first; i < last; i = past(i)) {
      if (is(i, ";")) {
        check_statement(start, i);
        start = i + 1;
      } else if (is(i, "{") && is_block(i) && !is_lambda(i)) {
        start = past(i);
      }
    }
    if (last < tokens_.size() && is(last, ")")) check_statement(start, last);
  }

  /// Index past the headers, labels and keywords before a statement's expression.
  std::size_t past_headers(std::size_t i, std::size_t last) const {
    static const Words single = {"else", "do", "try", "return", "throw", "delete", "co_return"};
    static const Words with_parentheses = {"if", "for", "while", "switch"};
    static const Words labels = {"default", "public", "private", "protected"};
    for (; i < last;) {
      if (single.contains(tokens_[i].text))
        ++i;
      else if (labels.contains(tokens_[i].text))
        i += 2;
      else if (is(i, "[") && is(i + 1, "["))
        i = past(i);
      else if (with_parentheses.contains(tokens_[i].text))
        i = past(is(i + 1, "constexpr") ? i + 2 : i + 1);
      else if (is(i, "case"))
        while (i < last && !is(i++, ":")) {
        }
      else
        break;
    }
    return i;
  }

  /// True if a statement begins with a type: two names side by side, with only `*`, `&` or template arguments between.
  bool is_declaration(std::size_t first, std::size_t last) const {
    static const Words starts = {"using", "template", "typedef", "friend", "static_assert", "auto"};
    if (starts.contains(tokens_[first].text)) return true;
    static const Words ends = {
        "=", ",", "{", "[", "+=", "-=", "*=", "/=", "|=", "&=", "^=", "%=", ".", "->", "++", "--"};
    bool after_type = false;
    for (std::size_t i = first; i < last && !ends.contains(tokens_[i].text); i = past(i)) {
      if (tokens_[i].is_word() && after_type) return true;
      const bool parenthesised_type = is(i, "(") && i > first && (is(i - 1, "decltype") || is(i - 1, "alignas"));
      if (is(i, "(") && !parenthesised_type) return false;
      const bool goes_on = after_type && (is(i, "*") || is(i, "&") || is(i, "&&"));
      after_type = tokens_[i].is_word() || is(i, "<") || parenthesised_type || goes_on;
    }
    return false;
  }

  void check_statement(std::size_t first, std::size_t last) {
    first = past_headers(first, last);
    if (first >= last || is_declaration(first, last)) return;
    for (std::size_t i = first; i < last; i = past(i))
      if (is(i, ",") && !is(i + 1, "...")) lines_.insert(tokens_[i].line);
  }

  std::vector<Token> tokens_;
  std::set<std::size_t> lines_;
};

std::size_t commas(const std::string& statements) {
  return CommaFinder("void f() {\n" + statements + "\n}\n").lines().size();
}

TEST(comma_operator, joins_no_statements_in_the_tree) {
  for (const SourceFile& file : source_tree()) {
    const auto lines = lines_of(file.text);
    const CommaFinder finder(file.text);
    for (const std::size_t line : finder.lines()) ADD_FAILURE() << file.path << ":" << line << ": " << lines[line - 1];
  }
}

TEST(comma_operator, is_found_wherever_it_joins_expressions) {
  for (const char* statement : {
           "a = b, c = d;",
           "if (x) y = 1, z = 2;",
           "if (x) {\n ++i;\n a[0] = 1, b.c->d += 2;\n}",
           "for (int i = 0; i < n; ++i) *p = i, ++p;",
           "else stop(), start();",
           "switch (x) { case Kind::a: y = 1, z = 2; break; }",
           "auto f = [&](int a) { n += a, m -= a; };",
           "run([&] { n += 1, m -= 1; }, 3);",
           "std::sort(a.begin(), a.end()), done = true;",
           "return log(x), x;",
           "const int a = (f(), 2);",
           "if (next(), ready) go();",
           "while (read(c), c != 0) use(c);",
           "x = y < 3, z = w > 4;",
           "p->a<int>(1), p->b();",
           "const char c = '\"'; a = c, b = c;",
           "a = 1'000, b = R\"(\"{)\";",
       })
    EXPECT_EQ(commas(statement), 1u) << statement;
}

TEST(comma_operator, other_commas_are_no_findings) {
  for (const char* statement : {
           "for (i = 0, j = n; i < j; ++i, --j) swap(a[i], a[j]);",
           "int a = 1, b = 2;",
           "const float *p = x, &q = y, r[3] = {1, 2, 3};",
           "std::map<int, std::vector<float>> m, n{{1, {2, 3}}};",
           "decltype(x) low = x, high = x;",
           "alignas(64) float lanes[16], more[16];",
           "const auto [first, second] = pair(1, 2);",
           "const std::uint32_t kinds[] = {1, 2, 3};",
           "return {a, b};",
           "return f(a, b)[g<int, 3>(c, d)];",
           "x = std::is_same_v<A, B> ? Vec{1, 2} : Vec{3, 4};",
           "(add(values), ...);",
           "auto f = [a, &b](int c, int d) { return c; }, g = f;",
           "run([&](int a, int b) -> float { use(a, b); return 1; }, 3, 4);",
           "enum class Kind { first = 1, second = 2 };",
           "struct Both : A, B { int a, b; };",
           "struct S { S(int a) : a_(a), b_{2} {}\n int f(int, int) const; int a_, b_; };",
           "template <class A, int n = 3> void f(A, B);",
           "bool operator==(const S& a, const S& b);",
           "std::function<const T&(int, int)> f;",
           "if (const int a = f(1, 2), b = 3; a < b) go();",
           "// a = b, c = d;",
           "puts(\"a = b, c = d;\");",
           "#define SET(a, b) a = 1, b = 2;",
       })
    EXPECT_EQ(commas(statement), 0u) << statement;
}

}  // namespace
}  // namespace sinew::test
