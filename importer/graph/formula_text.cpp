// SPDX-License-Identifier: MIT
#include "importer/graph/formula_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace sinew {
namespace {

bool is_letter(char c) noexcept { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

enum class TokenKind { end, number, word, quoted, sign, unknown };

struct Token {
  TokenKind kind = TokenKind::end;
  std::size_t at = 0, size = 0;
  std::string text;  ///< of a quoted name without its quotes
  float value = 0.0f;
};

Token number_at(std::string_view text, std::size_t at) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  Token token{TokenKind::number, at, static_cast<std::size_t>(stop - text.data()) - at, {}, 0.0f};
  if (error != std::errc{} || std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max()))
    token.kind = TokenKind::unknown;
  else
    token.value = static_cast<float>(value);
  token.size = std::max<std::size_t>(token.size, 1);
  return token;
}

Token quoted_at(std::string_view text, std::size_t at) {
  Token token{TokenKind::quoted, at, 0, {}, 0.0f};
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '\'' && !(i + 1 < text.size() && text[i + 1] == '\'')) {
      token.size = i + 1 - at;
      return token;
    }
    if (text[i] == '\'') ++i;
    token.text += text[i];
  }
  token.kind = TokenKind::unknown;  // the quote does not end
  token.size = text.size() - at;
  return token;
}

Token token_at(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n')) ++at;
  if (at == text.size()) return {TokenKind::end, at, 0, {}, 0.0f};
  if (is_digit(text[at]) || (text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1])))
    return number_at(text, at);
  if (text[at] == '\'') return quoted_at(text, at);
  std::size_t end = at;
  while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
  if (end > at) return {TokenKind::word, at, end - at, std::string(text.substr(at, end - at)), 0.0f};
  constexpr std::array<std::string_view, 4> kLong = {"<=", ">=", "==", "!="};
  const bool is_long = std::find(kLong.begin(), kLong.end(), text.substr(at, 2)) != kLong.end();
  const std::string sign(text.substr(at, is_long ? 2 : 1));
  const bool is_known = is_long || std::string_view("+-*/<>(),").find(sign) != std::string_view::npos;
  return {is_known ? TokenKind::sign : TokenKind::unknown, at, sign.size(), sign, 0.0f};
}

bool is_reserved(std::string_view word) noexcept { return word == "and" || word == "or" || word == "not"; }

/// Reads by recursive descent, one function for each level of operators.
class FormulaParser {
 public:
  explicit FormulaParser(std::string_view text) : text_(text), next_(token_at(text, 0)) {}

  std::vector<NamedFormulaStep> steps;
  std::string fault;

  void parse() {
    either();
    if (next_.kind != TokenKind::end) fail("an operator or the end was expected");
  }

 private:
  using Kind = GraphFormulaKind;
  static constexpr int kMostDepth = 64;

  void fail(const std::string& sentence) {
    if (fault.empty()) fault = "at character " + std::to_string(next_.at + 1) + ": " + sentence;
    next_ = {TokenKind::end, text_.size(), 0, {}, 0.0f};
  }
  void step() { next_ = token_at(text_, next_.at + next_.size); }
  bool is(TokenKind kind, std::string_view text) const { return next_.kind == kind && next_.text == text; }
  bool take(TokenKind kind, std::string_view text) {
    if (!is(kind, text)) return false;
    step();
    return true;
  }
  void expect(std::string_view sign) {
    if (!take(TokenKind::sign, sign)) fail("\"" + std::string(sign) + "\" was expected");
  }
  void put(Kind kind) { steps.push_back({kind, 0.0f, {}}); }

  void either() {
    if (++depth_ > kMostDepth) return fail("it is nested more than 64 deep");
    both();
    while (take(TokenKind::word, "or")) {
      both();
      put(Kind::either);
    }
    --depth_;
  }
  void both() {
    denial();
    while (take(TokenKind::word, "and")) {
      denial();
      put(Kind::both);
    }
  }
  void denial() {
    std::size_t count = 0;
    while (take(TokenKind::word, "not")) ++count;
    comparison();
    for (; count > 0; --count) put(Kind::is_false);
  }
  void comparison() {
    sum();
    if (next_.kind != TokenKind::sign) return;
    const std::string sign = next_.text;
    // a > b is not (a <= b), since numbers are never NaN.
    constexpr std::array<std::pair<std::string_view, Kind>, 6> kSigns = {{{"<", Kind::below},
                                                                          {"<=", Kind::below_or_equal},
                                                                          {"==", Kind::equal},
                                                                          {">", Kind::below_or_equal},
                                                                          {">=", Kind::below},
                                                                          {"!=", Kind::equal}}};
    const auto found = std::find_if(kSigns.begin(), kSigns.end(), [&](const auto& s) { return s.first == sign; });
    if (found == kSigns.end()) return;
    step();
    sum();
    put(found->second);
    if (found - kSigns.begin() >= 3) put(Kind::is_false);
  }
  void sum() {
    product();
    for (;;) {
      const bool adds = is(TokenKind::sign, "+");
      if (!adds && !is(TokenKind::sign, "-")) return;
      step();
      product();
      put(adds ? Kind::add : Kind::subtract);
    }
  }
  void product() {
    signed_value();
    for (;;) {
      const bool multiplies = is(TokenKind::sign, "*");
      if (!multiplies && !is(TokenKind::sign, "/")) return;
      step();
      signed_value();
      put(multiplies ? Kind::multiply : Kind::divide);
    }
  }
  void signed_value() {
    std::size_t count = 0;
    while (take(TokenKind::sign, "-")) ++count;
    value();
    for (; count > 0; --count) put(Kind::negate);
  }
  void value() {
    if (next_.kind == TokenKind::number) {
      steps.push_back({Kind::number, next_.value, {}});
      return step();
    }
    if (take(TokenKind::sign, "(")) {
      either();
      return expect(")");
    }
    if (next_.kind != TokenKind::word && next_.kind != TokenKind::quoted)
      return fail("a number, a parameter or \"(\" was expected");
    const Token name = next_;
    step();
    if (name.kind == TokenKind::word && is(TokenKind::sign, "(")) return call(name);
    if (name.kind == TokenKind::word && is_reserved(name.text)) {
      next_ = name;
      return fail("a number, a parameter or \"(\" was expected");
    }
    steps.push_back({Kind::parameter, 0.0f, name.text});
  }

  void arguments(std::size_t count) {
    expect("(");
    for (std::size_t i = 0; i < count && fault.empty(); ++i) {
      if (i > 0) expect(",");
      either();
    }
    expect(")");
  }
  void call(const Token& name) {
    if (name.text == "clamp") return clamp();
    struct Function {
      std::string_view name;
      std::size_t arguments;
      Kind kind;
    };
    constexpr std::array<Function, 5> kFunctions = {{{"min", 2, Kind::minimum},
                                                     {"max", 2, Kind::maximum},
                                                     {"abs", 1, Kind::absolute},
                                                     {"length", 2, Kind::length},
                                                     {"if", 3, Kind::choose}}};
    for (const Function& function : kFunctions)
      if (function.name == name.text) {
        arguments(function.arguments);
        return put(function.kind);
      }
    next_ = name;
    fail("there is no function \"" + name.text + "\"; there are min, max, clamp, abs, length, if");
  }
  /// clamp(x, low, high) = min(max(x, low), high)
  void clamp() {
    expect("(");
    either();
    expect(",");
    either();
    put(Kind::maximum);
    expect(",");
    either();
    put(Kind::minimum);
    expect(")");
  }

  std::string_view text_;
  Token next_;
  int depth_ = 0;
};

/// A name as formulas have it: in quotes unless it is a word without a meaning of its own.
std::string name_in_formula(const std::string& name) {
  const bool is_word = !name.empty() && !is_digit(name[0]) && !is_reserved(name) &&
                       std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
  if (is_word) return name;
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + '\'';
}

}  // namespace

tl::expected<std::vector<NamedFormulaStep>, std::string> parse_formula(std::string_view text) {
  FormulaParser parser(text);
  parser.parse();
  if (!parser.fault.empty()) return tl::make_unexpected(parser.fault);
  return std::move(parser.steps);
}

std::string rename_in_formula(const std::string& text, const std::map<std::string, std::string>& names) {
  if (!parse_formula(text)) return text;
  std::string out;
  std::size_t copied = 0;
  for (Token token = token_at(text, 0); token.kind != TokenKind::end; token = token_at(text, token.at + token.size)) {
    if (token.kind != TokenKind::word && token.kind != TokenKind::quoted) continue;
    const Token after = token_at(text, token.at + token.size);
    const bool is_call = after.kind == TokenKind::sign && after.text == "(";
    if (token.kind == TokenKind::word && (is_call || is_reserved(token.text))) continue;
    const auto found = names.find(token.text);
    if (found == names.end()) continue;
    out.append(text, copied, token.at - copied);
    out += name_in_formula(found->second);
    copied = token.at + token.size;
  }
  return out + text.substr(copied);
}

}  // namespace sinew
