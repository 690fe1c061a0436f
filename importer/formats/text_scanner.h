// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace sinew::formats {

/// Splits text into words, and counts lines. Braces and colons are words of their own.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  /// Line of the last word; lines count from 1.
  std::size_t line() const noexcept { return line_; }

  /// The next word, without consuming it; empty at the end.
  std::string_view peek() noexcept {
    skip_blanks();
    if (rest_.empty()) return rest_;
    if (is_mark(rest_.front())) return rest_.substr(0, 1);
    const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return is_blank(c) || is_mark(c); });
    return rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  }

  /// The next word; empty at the end.
  std::string_view next() noexcept {
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }

  /// The rest of the line up to a brace, without blanks at its ends.
  std::string_view rest_of_line() noexcept {
    const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return c == '\n' || c == '{' || c == '}'; });
    std::string_view out = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(out.size());
    while (!out.empty() && is_blank(out.front())) out.remove_prefix(1);
    while (!out.empty() && is_blank(out.back())) out.remove_suffix(1);
    return out;
  }

  /// Upper bound of the words that follow.
  std::size_t most_words_left() const noexcept { return rest_.size() / 2 + 1; }

 private:
  static bool is_blank(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_mark(char c) noexcept { return c == '{' || c == '}' || c == ':'; }

  void skip_blanks() noexcept {
    while (!rest_.empty() && is_blank(rest_.front())) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
  }

  std::string_view rest_;
  std::size_t line_ = 1;
};

}  // namespace sinew::formats
