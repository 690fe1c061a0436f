// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::tool {

inline constexpr std::size_t kHelpWidth = 100;  ///< no line of any help is longer

/// A part of a text: words that flow, or a line that stands as it is.
struct Paragraph {
  std::string text;
  bool verbatim = false;
  bool after_gap = false;  ///< an empty line is before it
};

/// Splits a text into paragraphs. Line ends inside a paragraph count as spaces. An empty line ends a paragraph and is
/// kept as a gap. A line that begins with a space is a verbatim paragraph.
std::vector<Paragraph> paragraphs(std::string_view text);

/// Breaks a text into lines of at most kHelpWidth columns. All lines but the first begin with `indent` spaces.
/// in   at   column at which the first line begins, after other text
std::string wrapped(std::string_view text, std::size_t indent, std::size_t at);

}  // namespace sinew::tool
